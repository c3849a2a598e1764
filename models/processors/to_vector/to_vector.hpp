// A message as a vector.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// The elements in row-major order, as numpy.ravel.
template <class Io>
struct ToVector {
  static typename Io::Output convert(const typename Io::Input& in) {
    static_assert(size_of<typename Io::Input> == size_of<typename Io::Output>,
                  "ToVector: `size` is the number of elements");
    typename Io::Output out{};
    for (std::size_t i = 0; i < size_of<typename Io::Input>; ++i) element(out, i) = element(in, i);
    return out;
  }
};

}  // namespace eagerx::models

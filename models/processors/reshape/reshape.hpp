// The same elements in another shape.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// The elements in the same row-major order, as numpy.reshape.
template <class Io>
struct Reshape {
  static typename Io::Output convert(const typename Io::Input& in) {
    static_assert(size_of<typename Io::Input> == size_of<typename Io::Output>,
                  "Reshape: `rows` times `columns` is the number of elements");
    typename Io::Output out{};
    for (std::size_t i = 0; i < size_of<typename Io::Input>; ++i) element(out, i) = element(in, i);
    return out;
  }
};

}  // namespace eagerx::models

// A message as a vector.
#pragma once

#include <eagerx/message.hpp>
#include <models/processors/same_elements.hpp>

namespace eagerx::models {

/// The elements in row-major order, as numpy.ravel.
template <class Io>
struct ToVector {
  static typename Io::Output convert(const typename Io::Input& in) {
    static_assert(size_of<typename Io::Input> == size_of<typename Io::Output>,
                  "ToVector: `size` is the number of elements");
    return same_elements<typename Io::Output>(in);
  }
};

}  // namespace eagerx::models

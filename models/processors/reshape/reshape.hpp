// The same elements in another shape.
#pragma once

#include <eagerx/message.hpp>
#include <models/processors/same_elements.hpp>

namespace eagerx::models {

/// The elements in the same row-major order, as numpy.reshape.
template <class Io>
struct Reshape {
  static typename Io::Output convert(const typename Io::Input& in) {
    static_assert(size_of<typename Io::Input> == size_of<typename Io::Output>,
                  "Reshape: `rows` times `columns` is the number of elements");
    return same_elements<typename Io::Output>(in);
  }
};

}  // namespace eagerx::models

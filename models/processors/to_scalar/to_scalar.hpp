// One number without a shape.
#pragma once

#include <eagerx/message.hpp>
#include <models/processors/same_elements.hpp>

namespace eagerx::models {

/// A message of one element becomes one of shape [].
template <class Io>
struct ToScalar {
  static typename Io::Output convert(const typename Io::Input& in) {
    static_assert(size_of<typename Io::Input> == size_of<typename Io::Output>,
                  "ToScalar: the message is one number");
    return same_elements<typename Io::Output>(in);
  }
};

}  // namespace eagerx::models

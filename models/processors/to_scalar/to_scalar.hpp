// One number without a shape.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// A message of one element becomes one of shape [].
template <class Io>
struct ToScalar {
  static typename Io::Output convert(const typename Io::Input& in) {
    static_assert(size_of<typename Io::Input> == size_of<typename Io::Output>,
                  "ToScalar: the message is one number");
    typename Io::Output out{};
    for (std::size_t i = 0; i < size_of<typename Io::Input>; ++i) element(out, i) = element(in, i);
    return out;
  }
};

}  // namespace eagerx::models

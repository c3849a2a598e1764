// The opposite of every element.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// Every element x becomes −x.
template <class Io>
struct Negate {
  static typename Io::Output convert(const typename Io::Input& in) {
    using Scalar = ScalarOf<typename Io::Output>;
    typename Io::Output out{};
    for (std::size_t i = 0; i < size_of<typename Io::Input>; ++i) {
      element(out, i) = static_cast<Scalar>(-element(in, i));
    }
    return out;
  }
};

}  // namespace eagerx::models

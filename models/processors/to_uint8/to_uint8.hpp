// Every element as an unsigned byte.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <type_traits>

namespace eagerx::models {

/// Floating-point x: truncated and limited to 0…255, NaN is 0. Integer x: x modulo 256.
template <class Io>
struct ToUint8 {
  static typename Io::Output convert(const typename Io::Input& in) {
    static_assert(std::is_same_v<ScalarOf<typename Io::Output>, std::uint8_t>);
    typename Io::Output out{};
    for (std::size_t i = 0; i < size_of<typename Io::Input>; ++i) {
      element(out, i) = byte(element(in, i));
    }
    return out;
  }

 private:
  template <class Scalar>
  static constexpr std::uint8_t byte(Scalar x) {
    if constexpr (std::is_floating_point_v<Scalar>) {
      if (!(x > Scalar(0))) return 0;
      return x >= Scalar(255) ? std::uint8_t{255} : static_cast<std::uint8_t>(x);
    } else {
      return static_cast<std::uint8_t>(x);
    }
  }
};

}  // namespace eagerx::models

// Every element as an unsigned byte.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <type_traits>

namespace eagerx::models {

/// Floating-point x: truncated and limited to 0…255, NaN is 0. Integer x: x modulo 256.
template <class Io>
struct ToUint8 {
  static typename Io::Output convert(const typename Io::Input& in) {
    static_assert(std::is_same_v<Byte, std::uint8_t> || !std::is_arithmetic_v<Byte>);
    typename Io::Output out{};
    for (std::size_t i = 0; i < size_of<typename Io::Input>; ++i) {
      element(out, i) = byte(element(in, i));
    }
    return out;
  }

 private:
  using Byte = ScalarOf<typename Io::Output>;

  template <class Scalar>
  static constexpr Byte byte(const Scalar& x) {
    if constexpr (Floating<Scalar>) {
      using Lane = LaneOf<Scalar>;
      const Scalar positive = select(x > Scalar(Lane(0)), x, Scalar(Lane(0)));
      return static_cast<Byte>(eagerx::min(positive, Scalar(Lane(255))));
    } else {
      return static_cast<Byte>(x);
    }
  }
};

}  // namespace eagerx::models

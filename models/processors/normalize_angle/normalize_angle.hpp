// Angles within one turn.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <numbers>
#include <type_traits>

namespace eagerx::models {

/// `angle` − 2π·⌊(angle + π)/2π⌋ [rad], within [−π, π]. NaN and infinity become NaN.
template <Floating R>
constexpr R normalized_angle(R angle) {
  constexpr auto kPi = std::numbers::pi_v<LaneOf<R>>;
  const R turns = eagerx::floor((angle + R(kPi)) / R(2 * kPi));
  // Rounding may leave the last bit outside.
  return eagerx::clamp(angle - R(2 * kPi) * turns, R(-kPi), R(kPi));
}

/// Every element θ [rad] moved by whole turns into [−π, π].
template <class Io>
struct NormalizeAngle {
  static typename Io::Output convert(const typename Io::Input& in) {
    using Scalar = ScalarOf<typename Io::Output>;
    static_assert(Floating<Scalar>, "NormalizeAngle: angles are floating-point");
    typename Io::Output out{};
    for (std::size_t i = 0; i < size_of<typename Io::Input>; ++i) {
      const auto angle = static_cast<typename Io::Real>(element(in, i));
      element(out, i) = static_cast<Scalar>(normalized_angle(angle));
    }
    return out;
  }
};

}  // namespace eagerx::models

// The processor of tutorial 3.
#pragma once

#include <eagerx/math.hpp>
#include <numbers>

namespace tutorial {

/// Moves an angle [rad] by whole turns into [−π, π].
template <class Io>
struct WrapAngle {
  static float convert(const float& angle) {
    constexpr float kTurn = 2.0F * std::numbers::pi_v<float>;
    const float turns = eagerx::floor(angle / kTurn + 0.5F);
    return angle - kTurn * turns;
  }
};

}  // namespace tutorial

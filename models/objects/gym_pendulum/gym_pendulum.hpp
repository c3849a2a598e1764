// Gym's Pendulum-v1 as a model of GymEngine.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <models/engines/gym_engine/gym_model.hpp>
#include <models/processors/normalize_angle/normalize_angle.hpp>
#include <numbers>

namespace eagerx::models {

/// State [φ, dφ/dt] in rad and rad/s, φ = 0 upright. A step of dt with the torque u [N·m]:
///   u clipped to ±max_torque
///   reward = −(φ² + 0.1·(dφ/dt)² + 0.001·u²), φ within ±π
///   dφ/dt ← dφ/dt + (3g/(2l)·sin φ + 3/(m·l²)·u)·dt, clipped to ±max_speed
///   φ ← φ + dφ/dt·dt
/// Source: Gymnasium 0.28.1, envs/classic_control/pendulum.py.
template <class Io>
struct GymPendulum {
  using Real = typename Io::Real;
  static constexpr std::size_t kStates = 2;
  static constexpr std::size_t kActions = 1;
  static constexpr std::size_t kObservations = 3;
  static constexpr std::size_t kAttributes = 6;
  static constexpr std::uint32_t kMaxSteps = 200;
  static constexpr std::array<const char*, kAttributes> kAttributeNames = {
      "g", "m", "l", "dt", "max_speed", "max_torque"};

  /// Order of the attributes.
  enum Attribute : std::size_t {
    kGravity,    // [m/s²]
    kMass,       // [kg]
    kLength,     // [m]
    kStep,       // [s]
    kMaxSpeed,   // [rad/s]
    kMaxTorque,  // [N·m]
  };

  static constexpr Array<Real, kStates> initial_state() {
    return {{Real(std::numbers::pi_v<LaneOf<Real>>), Real(0)}};
  }
  static constexpr Array<Real, kAttributes> default_attributes() {
    return {{Real(10), Real(1), Real(1), Real(0.05), Real(8), Real(2)}};
  }

  static constexpr GymOutcome<Real> step(Array<Real, kStates>& state,
                                         const Array<Real, kActions>& action,
                                         const Array<Real, kAttributes>& a) {
    const Real angle = state[0];
    const Real speed = state[1];
    const Real u = eagerx::clamp(action[0], -a[kMaxTorque], a[kMaxTorque]);
    const Real upright = normalized_angle(angle);
    const Real cost = upright * upright + Real(0.1) * (speed * speed) + Real(0.001) * (u * u);

    const Real gravity = Real(3) * a[kGravity] / (Real(2) * a[kLength]) * eagerx::sin(angle);
    const Real motor = Real(3) / (a[kMass] * (a[kLength] * a[kLength])) * u;
    const Real faster = speed + (gravity + motor) * a[kStep];
    const Real next_speed = eagerx::clamp(faster, -a[kMaxSpeed], a[kMaxSpeed]);
    state = {{angle + next_speed * a[kStep], next_speed}};
    return {.reward = -cost};
  }

  /// [cos φ, sin φ, dφ/dt]
  static constexpr Array<Real, kObservations> observe(const Array<Real, kStates>& state) {
    const auto [sine, cosine] = eagerx::sincos(state[0]);
    return {{cosine, sine, state[1]}};
  }
};

}  // namespace eagerx::models

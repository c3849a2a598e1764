// Gym's Acrobot-v1 as a model of GymEngine.
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

/// Two links, a motor between them. State [θ1, θ2, dθ1/dt, dθ2/dt] in rad and rad/s; θ1 = 0 hangs
/// down, θ2 is relative to the first link. Action 0, 1, 2: a torque u of −1, 0, 1 N·m. With l1 = 1
/// m, lc1 = lc2 = 0.5 m, m1 = m2 = 1 kg, I1 = I2 = 1 kg·m², g = 9.8 m/s²:
///   d1 = m1·lc1² + m2·(l1² + lc2² + 2·l1·lc2·cos θ2) + I1 + I2
///   d2 = m2·(lc2² + l1·lc2·cos θ2) + I2
///   φ2 = m2·lc2·g·cos(θ1 + θ2 − π/2)
///   φ1 = −m2·l1·lc2·(dθ2/dt)²·sin θ2 − 2·m2·l1·lc2·dθ2/dt·dθ1/dt·sin θ2
///        + (m1·lc1 + m2·l1)·g·cos(θ1 − π/2) + φ2
///   d²θ2/dt² = (u + d2/d1·φ1 − m2·l1·lc2·(dθ1/dt)²·sin θ2 − φ2)/(m2·lc2² + I2 − d2²/d1)
///   d²θ1/dt² = −(d2·d²θ2/dt² + φ1)/d1
/// (Gym's "book": Sutton and Barto, Reinforcement Learning.) A step is one of rk4 over dt = 0.2 s;
/// then angles go into ±π, speeds are clipped to ±4π and ±9π. Terminated when the free end is
/// higher than one link above the shaft: −cos θ1 − cos(θ1 + θ2) > 1. Each step costs 1, the one
/// that gets there 0. Source: Gymnasium 1.4.0, envs/classic_control/acrobot.py.
template <class Io>
struct GymAcrobot {
  using Real = typename Io::Real;
  static constexpr std::size_t kStates = 4;
  static constexpr std::size_t kActions = 1;
  static constexpr std::size_t kObservations = 6;
  static constexpr std::size_t kAttributes = 9;
  static constexpr std::uint32_t kMaxSteps = 500;
  static constexpr std::array<const char*, kAttributes> kAttributeNames = {
      "LINK_LENGTH_1", "LINK_MASS_1", "LINK_MASS_2", "LINK_COM_POS_1", "LINK_COM_POS_2",
      "LINK_MOI",      "dt",          "MAX_VEL_1",   "MAX_VEL_2"};

  /// Order of the attributes.
  enum Attribute : std::size_t {
    kLength1,    // [m]
    kMass1,      // [kg]
    kMass2,      // [kg]
    kCentre1,    // [m]
    kCentre2,    // [m]
    kInertia,    // [kg·m²] of each link
    kStep,       // [s]
    kMaxSpeed1,  // [rad/s]
    kMaxSpeed2,  // [rad/s]
  };
  using State = Array<Real, kStates>;
  using Attributes = Array<Real, kAttributes>;

  static constexpr State initial_state() { return {}; }
  static constexpr Attributes default_attributes() {
    constexpr auto kPi = std::numbers::pi_v<LaneOf<Real>>;
    return {{Real(1), Real(1), Real(1), Real(0.5), Real(0.5), Real(1), Real(0.2), Real(4 * kPi),
             Real(9 * kPi)}};
  }

  static constexpr GymOutcome<Real> step(State& state, const Array<Real, kActions>& action,
                                         const Attributes& a) {
    const Real torque = eagerx::clamp(action[0], Real(0), Real(2)) - Real(1);
    const Real half = a[kStep] / Real(2);
    const State k1 = derivative(state, torque, a);
    const State k2 = derivative(moved(state, half, k1), torque, a);
    const State k3 = derivative(moved(state, half, k2), torque, a);
    const State k4 = derivative(moved(state, a[kStep], k3), torque, a);
    for (std::size_t i = 0; i < kStates; ++i) {
      state[i] += a[kStep] / Real(6) * (k1[i] + Real(2) * k2[i] + Real(2) * k3[i] + k4[i]);
    }
    state = {{normalized_angle(state[0]), normalized_angle(state[1]),
              eagerx::clamp(state[2], -a[kMaxSpeed1], a[kMaxSpeed1]),
              eagerx::clamp(state[3], -a[kMaxSpeed2], a[kMaxSpeed2])}};
    const TruthOf<Real> arrived =
        -eagerx::cos(state[0]) - eagerx::cos(state[1] + state[0]) > Real(1);
    return {.reward = select(arrived, Real(0), Real(-1)), .terminated = arrived};
  }

  /// [cos θ1, sin θ1, cos θ2, sin θ2, dθ1/dt, dθ2/dt]
  static constexpr Array<Real, kObservations> observe(const State& s) {
    const auto first = eagerx::sincos(s[0]), second = eagerx::sincos(s[1]);
    return {{first.cos, first.sin, second.cos, second.sin, s[2], s[3]}};
  }

 private:
  static constexpr State moved(const State& from, Real by, const State& slope) {
    State result{};
    for (std::size_t i = 0; i < kStates; ++i) result[i] = from[i] + by * slope[i];
    return result;
  }

  static constexpr State derivative(const State& s, Real torque, const Attributes& a) {
    const Real gravity(LaneOf<Real>(9.8));
    const Real quarter(std::numbers::pi_v<LaneOf<Real>> / 2);
    const Real l1 = a[kLength1], lc1 = a[kCentre1], lc2 = a[kCentre2];
    const Real m1 = a[kMass1], m2 = a[kMass2], inertia = a[kInertia];
    const auto [sine, cosine] = eagerx::sincos(s[1]);
    const Real d1 = m1 * (lc1 * lc1) + m2 * (l1 * l1 + lc2 * lc2 + Real(2) * l1 * lc2 * cosine) +
                    inertia + inertia;
    const Real d2 = m2 * (lc2 * lc2 + l1 * lc2 * cosine) + inertia;
    const Real phi2 = m2 * lc2 * gravity * eagerx::cos(s[0] + s[1] - quarter);
    const Real phi1 = -m2 * l1 * lc2 * (s[3] * s[3]) * sine -
                      Real(2) * m2 * l1 * lc2 * s[3] * s[2] * sine +
                      (m1 * lc1 + m2 * l1) * gravity * eagerx::cos(s[0] - quarter) + phi2;
    const Real acc2 = (torque + d2 / d1 * phi1 - m2 * l1 * lc2 * (s[2] * s[2]) * sine - phi2) /
                      (m2 * (lc2 * lc2) + inertia - d2 * d2 / d1);
    return {{s[2], s[3], -(d2 * acc2 + phi1) / d1, acc2}};
  }
};

}  // namespace eagerx::models

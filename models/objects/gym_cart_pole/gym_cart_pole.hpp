// Gym's CartPole-v1 as a model of GymEngine.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <models/engines/gym_engine/gym_model.hpp>

namespace eagerx::models {

/// State [x, dx/dt, θ, dθ/dt] in m, m/s, rad, rad/s; θ = 0 upright. Action 0 pushes the cart to the
/// left with F = force_mag [N], action 1 to the right. A step of tau with M = masscart + masspole
/// and l = length, half the pole's:
///   a = (±F + masspole·l·(dθ/dt)²·sin θ)/M
///   d²θ/dt² = (g·sin θ − a·cos θ)/(l·(4/3 − masspole·cos²θ/M))
///   d²x/dt² = a − masspole·l·d²θ/dt²·cos θ/M
///   x, dx/dt, θ, dθ/dt ← explicit Euler
/// Terminated beyond ±x_threshold or ±theta_threshold. Each step is worth 1, those after the end 0.
/// Source: Gymnasium 1.4.0, envs/classic_control/cartpole.py.
template <class Io>
struct GymCartPole {
  using Real = typename Io::Real;
  static constexpr std::size_t kStates = 4;
  static constexpr std::size_t kActions = 1;
  static constexpr std::size_t kObservations = 4;
  static constexpr std::size_t kAttributes = 8;
  static constexpr std::uint32_t kMaxSteps = 500;
  static constexpr std::array<const char*, kAttributes> kAttributeNames = {
      "gravity",   "masscart", "masspole",    "length",
      "force_mag", "tau",      "x_threshold", "theta_threshold_radians"};

  /// Order of the attributes.
  enum Attribute : std::size_t {
    kGravity,     // [m/s²]
    kCartMass,    // [kg]
    kPoleMass,    // [kg]
    kHalfLength,  // [m]
    kForce,       // [N]
    kStep,        // [s]
    kMostX,       // [m]
    kMostAngle,   // [rad]
  };

  static constexpr Array<Real, kStates> initial_state() { return {}; }
  static constexpr Array<Real, kAttributes> default_attributes() {
    return {{Real(9.8), Real(1), Real(0.1), Real(0.5), Real(10), Real(0.02), Real(2.4),
             Real(0.20943951023931953)}};
  }

  static constexpr GymOutcome<Real> step(Array<Real, kStates>& state,
                                         const Array<Real, kActions>& action,
                                         const Array<Real, kAttributes>& a) {
    const TruthOf<Real> was_up = is_up(state, a);
    const Real x_dot = state[1], theta_dot = state[3];
    const Real force = select(action[0] > Real(0.5), a[kForce], -a[kForce]);
    const auto [sine, cosine] = eagerx::sincos(state[2]);
    const Real mass = a[kPoleMass] + a[kCartMass];
    const Real moment = a[kPoleMass] * a[kHalfLength];
    const Real push = (force + moment * (theta_dot * theta_dot) * sine) / mass;
    const Real theta_acc =
        (a[kGravity] * sine - cosine * push) /
        (a[kHalfLength] * (Real(4.0 / 3.0) - a[kPoleMass] * (cosine * cosine) / mass));
    const Real x_acc = push - moment * theta_acc * cosine / mass;
    state = {{state[0] + a[kStep] * x_dot, x_dot + a[kStep] * x_acc,
              state[2] + a[kStep] * theta_dot, theta_dot + a[kStep] * theta_acc}};
    return {.reward = select(was_up, Real(1), Real(0)), .terminated = !is_up(state, a)};
  }

  static constexpr Array<Real, kObservations> observe(const Array<Real, kStates>& state) {
    return state;
  }

 private:
  static constexpr TruthOf<Real> is_up(const Array<Real, kStates>& s,
                                       const Array<Real, kAttributes>& a) {
    return s[0] >= -a[kMostX] && s[0] <= a[kMostX] && s[2] >= -a[kMostAngle] &&
           s[2] <= a[kMostAngle];
  }
};

}  // namespace eagerx::models

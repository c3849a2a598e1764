// A brushed DC motor as a differential equation.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// x = [θ, ω], u the voltage:
///   dθ/dt = ω                                                  [rad/s]
///   dω/dt = (K/R·u − (b + K²/R)·ω − c·tanh(ω/w)) / J           [rad/s²]
/// Source: the motor of eagerx_tutorials' pendulum (pendulum_ode.hpp) without its disc's mass.
template <class Io>
struct DcMotorOde {
  using Real = typename Io::Real;
  static constexpr std::size_t kStates = 2;
  static constexpr std::size_t kInputs = 1;
  static constexpr std::size_t kParameters = 6;
  using State = Array<Real, kStates>;
  using Input = Array<Real, kInputs>;
  using Parameters = Array<Real, kParameters>;

  /// Order of the parameters.
  enum Parameter : std::size_t {
    kInertia,        // J [kg·m²]
    kDamping,        // b [N·m·s/rad]
    kMotorConstant,  // K [N·m/A] = [V·s/rad]
    kResistance,     // R [Ω]
    kFriction,       // c [N·m]
    kFrictionSpeed,  // w [rad/s]
  };

  static constexpr Parameters default_parameters() {
    return {
        {Real(0.00016), Real(1.433e-05), Real(0.03334), Real(7.731), Real(0.000975), Real(0.0121)}};
  }

  /// Everything in dω/dt that does not change during an engine tick.
  struct Coefficients {
    Real motor;      // K·u / (R·J) [rad/s²]
    Real damping;    // (b + K²/R) / J [1/s]
    Real friction;   // c / J [rad/s²]
    Real per_speed;  // 1 / w [s/rad]
  };
  static constexpr Coefficients precompute(const Parameters& p, const Input& u) {
    const Real per_inertia = Real(1) / p[kInertia];
    const Real k_over_r = p[kMotorConstant] / p[kResistance];
    return {.motor = k_over_r * u[0] * per_inertia,
            .damping = (p[kDamping] + p[kMotorConstant] * k_over_r) * per_inertia,
            .friction = p[kFriction] * per_inertia,
            .per_speed = Real(1) / p[kFrictionSpeed]};
  }

  /// [ω, dω/dt]
  static constexpr State derivative(const Coefficients& c, State x) {
    const Real omega = x[1];
    return {{omega, c.motor - c.damping * omega - c.friction * eagerx::tanh(c.per_speed * omega)}};
  }

  /// ∂f/∂x, row-major.
  static constexpr Array<Real, kStates, kStates> jacobian(const Coefficients& c, State x) {
    const Real t = eagerx::tanh(c.per_speed * x[1]);
    return {{Real(0), Real(1), Real(0), -c.damping - c.friction * c.per_speed * (Real(1) - t * t)}};
  }
};

}  // namespace eagerx::models

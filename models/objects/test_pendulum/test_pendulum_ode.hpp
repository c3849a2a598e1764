// The pendulum of the tests of EAGERx's OdeEngine as a differential equation.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// A disc with an off-centre mass on the shaft of a DC motor, without friction of the shaft;
/// x = [θ, ω], θ = 0 upright.
///   dθ/dt = ω                                                     [rad/s]
///   dω/dt = (m·g·l·sin θ − (b + K²/R)·ω + K·u/R) / J              [rad/s²]
/// with u the voltage [V] and g = 9.81 m/s².
/// Source: eagerx_ode, tests/pendulum.
template <class Io>
struct TestPendulumOde {
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
    kMass,           // m [kg]
    kLength,         // l [m], from the shaft to the centre of mass
    kDamping,        // b [N·m·s/rad]
    kMotorConstant,  // K [N·m/A] = [V·s/rad]
    kResistance,     // R [Ω]
  };
  static constexpr auto kGravity = Real(9.81);  // [m/s²]

  static constexpr Parameters default_parameters() {
    return {{Real(0.000189238), Real(0.0563641), Real(0.0437891), Real(0.000142205),
             Real(0.0502769), Real(9.83536)}};
  }

  /// Everything in dω/dt that does not change during an engine tick.
  struct Coefficients {
    Real motor;    // K·u / (R·J) [rad/s²]
    Real gravity;  // m·g·l / J [rad/s²]
    Real damping;  // (b + K²/R) / J [1/s]
  };

  static constexpr Coefficients precompute(const Parameters& p, const Input& u) {
    const Real per_inertia = Real(1) / p[kInertia];
    const Real k_over_r = p[kMotorConstant] / p[kResistance];
    return {.motor = k_over_r * u[0] * per_inertia,
            .gravity = p[kMass] * kGravity * p[kLength] * per_inertia,
            .damping = (p[kDamping] + p[kMotorConstant] * k_over_r) * per_inertia};
  }

  /// [ω, dω/dt]
  static constexpr State derivative(const Coefficients& c, State x) {
    return {{x[1], c.motor + c.gravity * eagerx::sin(x[0]) - c.damping * x[1]}};
  }

  /// ∂f/∂x, row-major.
  static constexpr Array<Real, kStates, kStates> jacobian(const Coefficients& c, State x) {
    return {{Real(0), Real(1), c.gravity * eagerx::cos(x[0]), -c.damping}};
  }
};

}  // namespace eagerx::models

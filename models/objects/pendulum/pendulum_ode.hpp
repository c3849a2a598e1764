// The disc pendulum of EAGERx's tutorials as a differential equation.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// A disc with an off-centre mass on the shaft of a DC motor; x = [θ, ω], θ = 0 upright.
///   dθ/dt = ω                                                                          [rad/s]
///   dω/dt = (K/R·u + m·g·l·sin θ − b·ω − K²/R·ω − c·(2/(1 + e^(−d·ω)) − 1)) / J        [rad/s²]
/// with u the voltage [V] and g = 9.81 m/s². The last term is the friction of the shaft, nearly a
/// step at ω = 0; it is computed as c·tanh(d·ω/2), which is the same and never overflows.
/// Source: eagerx_tutorials, pendulum/pendulum_ode.py; parameters from pendulum/objects.py.
template <class Io>
struct PendulumOde {
  using Real = typename Io::Real;
  static constexpr std::size_t kStates = 2;
  static constexpr std::size_t kInputs = 1;
  static constexpr std::size_t kParameters = 8;
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
    kFriction,       // c [N·m]
    kFrictionSlope,  // d [s/rad]
  };
  static constexpr auto kGravity = Real(9.81);  // [m/s²]

  static constexpr Parameters default_parameters() {
    return {{Real(0.000159931461600856), Real(0.0508581731919534), Real(0.0415233722862552),
             Real(1.43298488358436e-05), Real(0.0333391179016334), Real(7.73125142447252),
             Real(0.000975041213361349), Real(165.417960777425)}};
  }

  /// Everything in dω/dt that does not change during an engine tick.
  struct Coefficients {
    Real motor;           // K·u / (R·J) [rad/s²]
    Real gravity;         // m·g·l / J [rad/s²]
    Real damping;         // (b + K²/R) / J [1/s]
    Real friction;        // c / J [rad/s²]
    Real friction_slope;  // d / 2 [s/rad]
  };

  static constexpr Coefficients precompute(const Parameters& p, const Input& u) {
    const Real per_inertia = Real(1) / p[kInertia];
    const Real k_over_r = p[kMotorConstant] / p[kResistance];
    return {.motor = k_over_r * u[0] * per_inertia,
            .gravity = p[kMass] * kGravity * p[kLength] * per_inertia,
            .damping = (p[kDamping] + p[kMotorConstant] * k_over_r) * per_inertia,
            .friction = p[kFriction] * per_inertia,
            .friction_slope = p[kFrictionSlope] * Real(0.5)};
  }

  /// [ω, dω/dt]
  static constexpr State derivative(const Coefficients& c, State x) {
    const Real omega = x[1];
    return {{omega, c.motor + c.gravity * eagerx::sin(x[0]) - c.damping * omega -
                        c.friction * eagerx::tanh(c.friction_slope * omega)}};
  }

  /// ∂f/∂x, row-major: [∂(dθ/dt)/∂θ, ∂(dθ/dt)/∂ω; ∂(dω/dt)/∂θ, ∂(dω/dt)/∂ω].
  static constexpr Array<Real, kStates, kStates> jacobian(const Coefficients& c, State x) {
    const Real t = eagerx::tanh(c.friction_slope * x[1]);
    return {{Real(0), Real(1), c.gravity * eagerx::cos(x[0]),
             -c.damping - c.friction * c.friction_slope * (Real(1) - t * t)}};
  }
};

}  // namespace eagerx::models

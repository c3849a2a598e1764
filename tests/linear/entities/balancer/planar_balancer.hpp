// A two-wheeled balancing robot as a differential equation, seen from the side.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>

namespace own {

/// x = [s, theta, v, omega]: way of the axle, pitch (0 upright, forward positive), and their
/// derivatives. u = [voltage of both motors].
template <class Io>
struct PlanarBalancer {
  using Real = typename Io::Real;
  static constexpr std::size_t kStates = 4;
  static constexpr std::size_t kInputs = 1;
  static constexpr std::size_t kParameters = 1;
  using Parameters = eagerx::Array<Real, kParameters>;
  using State = eagerx::Array<Real, kStates>;
  using Input = eagerx::Array<Real, kInputs>;

  static constexpr Real kRadius = Real(0.035), kWheelMass = Real(0.05), kWheelInertia = Real(4e-5);
  static constexpr Real kLength = Real(0.09), kInertia = Real(0.003), kGravity = Real(9.81);
  static constexpr Real kMotor = Real(0.36), kResistance = Real(6.0), kFriction = Real(0.02);

  /// [mass of the body]
  static constexpr Parameters default_parameters() { return {{Real(0.8)}}; }

  static constexpr State derivative(const Parameters& p, const Input& u, State x) {
    const Real m = p[0];
    const Real sine = eagerx::sin(x[1]), cosine = eagerx::cos(x[1]);
    const Real rolling = x[2] / kRadius - x[3];
    const Real torque = Real(2) * (kMotor * (u[0] - kMotor * rolling) / kResistance -
                                   kFriction * rolling * Real(0.1));
    const Real a11 = m + Real(2) * (kWheelMass + kWheelInertia / (kRadius * kRadius));
    const Real a12 = m * kLength * cosine;
    const Real a22 = kInertia + m * kLength * kLength;
    const Real b1 = torque / kRadius + m * kLength * sine * x[3] * x[3];
    const Real b2 = m * kGravity * kLength * sine - torque;
    const Real determinant = a11 * a22 - a12 * a12;
    return {{x[2], x[3], (a22 * b1 - a12 * b2) / determinant, (a11 * b2 - a12 * b1) / determinant}};
  }
};

}  // namespace own

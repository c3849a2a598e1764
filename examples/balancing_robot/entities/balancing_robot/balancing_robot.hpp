// A robot on two wheels as a differential equation, seen from the side.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>

namespace own {

/// x = [s, theta, v, omega], u = [voltage], p = [mass of the body]. Lagrange's equations of body
/// and wheels, with the torque of both motors between them.
template <class Io>
struct BalancingRobot {
  using Real = typename Io::Real;
  static constexpr std::size_t kStates = 4, kInputs = 1, kParameters = 1;
  using Parameters = eagerx::Array<Real, kParameters>;
  using State = eagerx::Array<Real, kStates>;
  using Input = eagerx::Array<Real, kInputs>;

  static constexpr Real kRadius = Real(0.035);    // of a wheel, m
  static constexpr Real kWheels = Real(0.165);    // mass of both, with their inertia, kg
  static constexpr Real kLength = Real(0.09);     // from the axle to the center of mass, m
  static constexpr Real kInertia = Real(0.003);   // of the body, kg*m^2
  static constexpr Real kGravity = Real(9.81);    // m/s^2
  static constexpr Real kMotor = Real(0.36);      // N*m/A and V*s/rad
  static constexpr Real kResistance = Real(6.0);  // Ohm
  static constexpr Real kFriction = Real(0.002);  // N*m*s/rad

  static constexpr Parameters default_parameters() { return {{Real(0.8)}}; }

  static constexpr State derivative(const Parameters& p, const Input& u, State x) {
    const Real sine = eagerx::sin(x[1]), cosine = eagerx::cos(x[1]);
    const Real rolling = x[2] / kRadius - x[3];  // of a wheel against the body
    const Real torque =
        Real(2) * (kMotor * (u[0] - kMotor * rolling) / kResistance - kFriction * rolling);
    const Real a11 = p[0] + kWheels;
    const Real a12 = p[0] * kLength * cosine;
    const Real a22 = kInertia + p[0] * kLength * kLength;
    const Real b1 = torque / kRadius + p[0] * kLength * sine * x[3] * x[3];
    const Real b2 = p[0] * kGravity * kLength * sine - torque;
    const Real determinant = a11 * a22 - a12 * a12;
    return {{x[2], x[3], (a22 * b1 - a12 * b2) / determinant, (a11 * b2 - a12 * b1) / determinant}};
  }
};

}  // namespace own

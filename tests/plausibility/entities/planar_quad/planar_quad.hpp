// A quadrotor in a plane as a differential equation.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>

namespace plausibility {

/// x = [x, z, vx, vz, phi, w]; parameters [mass in kg, wind in m/s (two)].
template <class Io>
struct PlanarQuad {
  using Real = typename Io::Real;
  static constexpr std::size_t kStates = 6;
  static constexpr std::size_t kInputs = 2;
  static constexpr std::size_t kParameters = 3;
  using State = eagerx::Array<Real, kStates>;
  using Input = eagerx::Array<Real, kInputs>;
  using Parameters = eagerx::Array<Real, kParameters>;

  static constexpr Parameters default_parameters() { return {{Real(1), Real(0), Real(0)}}; }

  struct Coefficients {
    Real lift, turn, drag;  // m/s², rad/s², 1/s
    Real wind_x, wind_z;    // m/s
  };

  static constexpr Coefficients precompute(const Parameters& p, const Input& u) {
    constexpr auto kInertia = Real(0.02), kArm = Real(0.2), kDrag = Real(0.3);
    return {(u[0] + u[1]) / p[0], (u[0] - u[1]) * kArm / kInertia, kDrag / p[0], p[1], p[2]};
  }

  static constexpr State derivative(const Coefficients& c, State x) {
    return {{x[2], x[3], c.lift * eagerx::sin(x[4]) - c.drag * (x[2] - c.wind_x),
             c.lift * eagerx::cos(x[4]) - Real(9.81) - c.drag * (x[3] - c.wind_z), x[5], c.turn}};
  }
};

}  // namespace plausibility

// A quadrotor in a vertical plane, as a differential equation.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>

namespace tests {

/// x = [px, py, vx, vy, phi, w], u = [left, right] thrust as a share of the weight, relative to
/// hovering:
///   dv/dt = [-f·sin(phi) + wind, f·cos(phi) − g],  f = g·(1 + (left + right)/2)·0.5/mass
///   dw/dt = 30·(right − left)
template <class Io>
struct PlanarQuad {
  using Real = typename Io::Real;
  static constexpr std::size_t kStates = 6, kInputs = 2, kParameters = 2;
  using State = eagerx::Array<Real, kStates>;
  using Input = eagerx::Array<Real, kInputs>;
  using Parameters = eagerx::Array<Real, kParameters>;
  enum Parameter : std::size_t { kMass, kWind };  // kg, m/s²

  static constexpr Parameters default_parameters() { return {{Real(0.5), Real(0)}}; }

  struct Coefficients {
    Real lift, wind, turn;
  };
  static constexpr Coefficients precompute(const Parameters& p, const Input& u) {
    return {Real(9.81) * (Real(1) + Real(0.5) * (u[0] + u[1])) * Real(0.5) / p[kMass], p[kWind],
            Real(30) * (u[1] - u[0])};
  }
  static constexpr State derivative(const Coefficients& c, State x) {
    return {{x[2], x[3], c.wind - c.lift * eagerx::sin(x[4]),
             c.lift * eagerx::cos(x[4]) - Real(9.81), x[5], c.turn}};
  }
};

}  // namespace tests

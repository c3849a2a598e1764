// The differential equation of tutorial 6.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>

namespace tutorial {

/// dθ/dt = ω, dω/dt = (K/R·u + m·g·l·sin θ − b·ω − K²/R·ω)/J;
/// models/engines/ode_engine/ode_model.hpp says what a model has.
template <class Io>
struct DiscPendulum {
  using Real = typename Io::Real;
  static constexpr std::size_t kStates = 2;      // x = [θ, ω]
  static constexpr std::size_t kInputs = 1;      // u
  static constexpr std::size_t kParameters = 6;  // J, m, l, b, K, R
  using Parameters = eagerx::Array<Real, kParameters>;

  static constexpr Parameters default_parameters() {
    return {{Real(0.000159931461600856), Real(0.0508581731919534), Real(0.0415233722862552),
             Real(1.43298488358436e-05), Real(0.0333391179016334), Real(7.73125142447252)}};
  }

  static constexpr eagerx::Array<Real, kStates> derivative(const Parameters& p,
                                                           const eagerx::Array<Real, kInputs>& u,
                                                           eagerx::Array<Real, kStates> x) {
    const auto [J, m, l, b, K, R] = p.data;
    const Real torque =
        K / R * u[0] + m * Real(9.81) * l * eagerx::sin(x[0]) - b * x[1] - K * K / R * x[1];
    return {{x[1], torque / J}};
  }
};

}  // namespace tutorial

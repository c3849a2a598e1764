// A tank with an outlet.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>

namespace tests {

/// x = [level]; parameters area A, outlet a: A dx/dt = u - a sqrt(x).
template <class Io>
struct TankOde {
  using Real = typename Io::Real;
  static constexpr std::size_t kStates = 1;
  static constexpr std::size_t kInputs = 1;
  static constexpr std::size_t kParameters = 2;
  using Parameters = eagerx::Array<Real, kParameters>;
  using State = eagerx::Array<Real, kStates>;
  using Input = eagerx::Array<Real, kInputs>;

  static constexpr Parameters default_parameters() { return {{Real(1.0), Real(0.8)}}; }

  static constexpr State derivative(const Parameters& p, const Input& u, State x) {
    const Real level = x[0] > Real(0) ? x[0] : Real(0);
    return {{(u[0] - p[1] * eagerx::sqrt(level)) / p[0]}};
  }
};

}  // namespace tests

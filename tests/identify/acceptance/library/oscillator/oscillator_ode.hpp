// Van der Pol's oscillator.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>

namespace tests {

/// x = [x, v]; parameters mu, w: dv/dt = u + mu (1 - x^2) v - w^2 x, van der Pol's.
template <class Io>
struct OscillatorOde {
  using Real = typename Io::Real;
  static constexpr std::size_t kStates = 2;
  static constexpr std::size_t kInputs = 1;
  static constexpr std::size_t kParameters = 2;
  using Parameters = eagerx::Array<Real, kParameters>;
  using State = eagerx::Array<Real, kStates>;
  using Input = eagerx::Array<Real, kInputs>;

  static constexpr Parameters default_parameters() { return {{Real(1.0), Real(4.0)}}; }

  static constexpr State derivative(const Parameters& p, const Input& u, State x) {
    return {{x[1], u[0] + p[0] * (Real(1) - x[0] * x[0]) * x[1] - p[1] * p[1] * x[0]}};
  }
};

}  // namespace tests

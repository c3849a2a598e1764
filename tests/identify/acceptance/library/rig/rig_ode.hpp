// A mass on a spring, or a pendulum near the top if the spring is negative.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>

namespace tests {

/// x = [q, v]: m dv/dt = u - c v - k sin(q).
template <class Io>
struct RigOde {
  using Real = typename Io::Real;
  static constexpr std::size_t kStates = 2;
  static constexpr std::size_t kInputs = 1;
  static constexpr std::size_t kParameters = 3;
  using Parameters = eagerx::Array<Real, kParameters>;
  using State = eagerx::Array<Real, kStates>;
  using Input = eagerx::Array<Real, kInputs>;

  static constexpr Parameters default_parameters() { return {{Real(1), Real(0.5), Real(4)}}; }

  static constexpr State derivative(const Parameters& p, const Input& u, State x) {
    return {{x[1], (u[0] - p[1] * x[1] - p[2] * eagerx::sin(x[0])) / p[0]}};
  }
};

}  // namespace tests

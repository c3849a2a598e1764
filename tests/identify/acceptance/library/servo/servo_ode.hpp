// A servo whose current follows the voltage at once.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>

namespace tests {

/// x = [angle, speed]; parameters resistance R, constant K, inertia J, friction b: J dw/dt = K (u -
/// K w)/R - b w.
template <class Io>
struct ServoOde {
  using Real = typename Io::Real;
  static constexpr std::size_t kStates = 2;
  static constexpr std::size_t kInputs = 1;
  static constexpr std::size_t kParameters = 4;
  using Parameters = eagerx::Array<Real, kParameters>;
  using State = eagerx::Array<Real, kStates>;
  using Input = eagerx::Array<Real, kInputs>;

  static constexpr Parameters default_parameters() {
    return {{Real(2.0), Real(0.05), Real(0.0005), Real(0.0005)}};
  }

  static constexpr State derivative(const Parameters& p, const Input& u, State x) {
    return {{x[1], (p[1] * (u[0] - p[1] * x[1]) / p[0] - p[3] * x[1]) / p[2]}};
  }
};

}  // namespace tests

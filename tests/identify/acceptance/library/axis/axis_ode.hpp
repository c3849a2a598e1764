// One axis of a drone, whose motors take their time.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>

namespace tests {

/// x = [angle, rate, torque]; parameters gain, time constant T, drag d: T dtorque/dt = gain u -
/// torque, drate/dt = torque - d rate |rate|.
template <class Io>
struct AxisOde {
  using Real = typename Io::Real;
  static constexpr std::size_t kStates = 3;
  static constexpr std::size_t kInputs = 1;
  static constexpr std::size_t kParameters = 3;
  using Parameters = eagerx::Array<Real, kParameters>;
  using State = eagerx::Array<Real, kStates>;
  using Input = eagerx::Array<Real, kInputs>;

  static constexpr Parameters default_parameters() { return {{Real(20.0), Real(0.05), Real(0.5)}}; }

  static constexpr State derivative(const Parameters& p, const Input& u, State x) {
    const Real drag = x[1] < Real(0) ? -p[2] * x[1] * x[1] : p[2] * x[1] * x[1];
    return {{x[1], x[2] - drag, (p[0] * u[0] - x[2]) / p[1]}};
  }
};

}  // namespace tests

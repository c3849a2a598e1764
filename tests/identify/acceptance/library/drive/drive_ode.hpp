// A motor and a load with a spring between them.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>

namespace tests {

/// x = [q1, v1, q2, v2]; parameters stiffness k, damping c, load m: a motor of 1 kg pulls the load.
template <class Io>
struct DriveOde {
  using Real = typename Io::Real;
  static constexpr std::size_t kStates = 4;
  static constexpr std::size_t kInputs = 1;
  static constexpr std::size_t kParameters = 3;
  using Parameters = eagerx::Array<Real, kParameters>;
  using State = eagerx::Array<Real, kStates>;
  using Input = eagerx::Array<Real, kInputs>;

  static constexpr Parameters default_parameters() { return {{Real(40.0), Real(0.5), Real(2.0)}}; }

  static constexpr State derivative(const Parameters& p, const Input& u, State x) {
    const Real force = p[0] * (x[0] - x[2]) + p[1] * (x[1] - x[3]);
    return {{x[1], u[0] - force - Real(0.3) * x[1], x[3], force / p[2]}};
  }
};

}  // namespace tests

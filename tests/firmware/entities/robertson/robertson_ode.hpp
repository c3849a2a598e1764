// Robertson's reaction of three substances, the classical stiff problem.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>

namespace eagerx::tests {

/// x = amounts of the substances, u a supply of the first, p = [k1, k2, k3] the rates:
///   dx1/dt = −k1·x1 + k3·x2·x3 + u,  dx2/dt = k1·x1 − k3·x2·x3 − k2·x2²,  dx3/dt = k2·x2²
/// Robertson: The solution of a set of reaction rate equations, 1966.
template <class Io>
struct RobertsonOde {
  using Real = typename Io::Real;
  static constexpr std::size_t kStates = 3;
  static constexpr std::size_t kInputs = 1;
  static constexpr std::size_t kParameters = 3;

  static constexpr Array<Real, kParameters> default_parameters() {
    return {{Real(0.04), Real(3e7), Real(1e4)}};
  }
  static constexpr Array<Real, kStates> derivative(const Array<Real, kParameters>& p,
                                                   const Array<Real, kInputs>& u,
                                                   Array<Real, kStates> x) {
    const Real slow = p[0] * x[0];
    const Real fast = p[1] * x[1] * x[1];
    const Real back = p[2] * x[1] * x[2];
    return {{back - slow + u[0], slow - back - fast, fast}};
  }
};

}  // namespace eagerx::tests

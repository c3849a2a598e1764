// Van der Pol's oscillator, stiff for a large mu.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>

namespace eagerx::tests {

/// x = [x, dx/dt], u a force, p = [mu]:
///   d²x/dt² = mu·(1 − x²)·dx/dt − x + u
template <class Io>
struct VanDerPolOde {
  using Real = typename Io::Real;
  static constexpr std::size_t kStates = 2;
  static constexpr std::size_t kInputs = 1;
  static constexpr std::size_t kParameters = 1;

  static constexpr Array<Real, kParameters> default_parameters() { return {{Real(1000)}}; }
  static constexpr Array<Real, kStates> derivative(const Array<Real, kParameters>& p,
                                                   const Array<Real, kInputs>& u,
                                                   Array<Real, kStates> x) {
    return {{x[1], p[0] * (Real(1) - x[0] * x[0]) * x[1] - x[0] + u[0]}};
  }
};

}  // namespace eagerx::tests

// A mass on a spring that becomes stiffer.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>

namespace eagerx::tests {

/// x = [position m, speed m/s], u the force in N, p = [mass kg, damping N·s/m, stiffness N/m]:
///   dx/dt = v,  dv/dt = (u − damping·v − stiffness·x − hardening·x³) / mass
template <class Io>
struct DuffingOde {
  using Real = typename Io::Real;
  static constexpr std::size_t kStates = 2;
  static constexpr std::size_t kInputs = 1;
  static constexpr std::size_t kParameters = 3;

  static constexpr Array<Real, kParameters> default_parameters() {
    return {{Real(0.5), Real(0.2), Real(3)}};
  }
  static constexpr Array<Real, kStates> derivative(const Array<Real, kParameters>& p,
                                                   const Array<Real, kInputs>& u,
                                                   Array<Real, kStates> x) {
    constexpr auto kHardening = static_cast<Real>(Io::Config::hardening);
    const Real spring = p[2] * x[0] + kHardening * x[0] * x[0] * x[0];
    return {{x[1], (u[0] - p[1] * x[1] - spring) / p[0]}};
  }
};

}  // namespace eagerx::tests

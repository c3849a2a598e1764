// The classical Runge-Kutta method.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <models/engines/ode_engine/elementwise.hpp>

namespace eagerx::models {

/// x + h·k
template <class Real, std::size_t N>
[[gnu::always_inline]] inline constexpr Array<Real, N> moved(const Array<Real, N>& x, Real h,
                                                             const Array<Real, N>& k) {
  return elementwise<Real, N>([&](std::size_t i) { return x[i] + h * k[i]; });
}

/// One step of `step_s` seconds of the classical fourth-order Runge-Kutta method (Kutta 1901), with
/// `f` giving dx/dt [N] of the state `x` [N]. The error of a step is of the order step_s⁵.
template <class F, class Real, std::size_t N>
[[gnu::always_inline]] inline constexpr Array<Real, N> rk4_step(const F& f, const Array<Real, N>& x,
                                                                Real step_s) {
  const Real half = step_s * Real(0.5);
  const Real sixth = step_s * Real(1.0 / 6.0);
  const Array<Real, N> k1 = f(x);
  const Array<Real, N> k2 = f(moved(x, half, k1));
  const Array<Real, N> k3 = f(moved(x, half, k2));
  const Array<Real, N> k4 = f(moved(x, step_s, k3));
  return elementwise<Real, N>([&](std::size_t i) {
    return x[i] + sixth * (k1[i] + Real(2) * k2[i] + Real(2) * k3[i] + k4[i]);
  });
}

}  // namespace eagerx::models

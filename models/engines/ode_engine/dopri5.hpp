// The method of Dormand and Prince: fifth order, with an error estimate of fourth order that
// chooses the steps.
#pragma once

#include <cstddef>
#include <eagerx/math/vocabulary.hpp>
#include <eagerx/message.hpp>
#include <models/engines/ode_engine/elementwise.hpp>

namespace eagerx::models {

/// The seven stages from a state `x` [N] over `step_s` seconds, with k1 = f(x) given. The last
/// stage is the derivative at the end, which is the first stage of the next step. Dormand, Prince:
/// A family of embedded Runge-Kutta formulae, 1980, table 2 (RK5(4)7M).
template <class Real, std::size_t N>
struct Dopri5Step {
  using State = Array<Real, N>;
  State end;    // x after the step, fifth order
  State slope;  // f(end)
  State error;  // difference to the embedded method of fourth order

  template <class F>
  constexpr Dopri5Step(const F& f, const State& x, const State& k1, Real step_s) {
    const auto at = [&](auto weighted_slope) {
      return elementwise<Real, N>([&](std::size_t i) { return x[i] + step_s * weighted_slope(i); });
    };
    const State k2 = f(at([&](std::size_t i) { return Real(1.0 / 5) * k1[i]; }));
    const State k3 =
        f(at([&](std::size_t i) { return Real(3.0 / 40) * k1[i] + Real(9.0 / 40) * k2[i]; }));
    const State k4 = f(at([&](std::size_t i) {
      return Real(44.0 / 45) * k1[i] - Real(56.0 / 15) * k2[i] + Real(32.0 / 9) * k3[i];
    }));
    const State k5 = f(at([&](std::size_t i) {
      return Real(19372.0 / 6561) * k1[i] - Real(25360.0 / 2187) * k2[i] +
             Real(64448.0 / 6561) * k3[i] - Real(212.0 / 729) * k4[i];
    }));
    const State k6 = f(at([&](std::size_t i) {
      return Real(9017.0 / 3168) * k1[i] - Real(355.0 / 33) * k2[i] + Real(46732.0 / 5247) * k3[i] +
             Real(49.0 / 176) * k4[i] - Real(5103.0 / 18656) * k5[i];
    }));
    end = at([&](std::size_t i) {
      return Real(35.0 / 384) * k1[i] + Real(500.0 / 1113) * k3[i] + Real(125.0 / 192) * k4[i] -
             Real(2187.0 / 6784) * k5[i] + Real(11.0 / 84) * k6[i];
    });
    slope = f(end);
    error = elementwise<Real, N>([&](std::size_t i) {
      return step_s * (Real(71.0 / 57600) * k1[i] - Real(71.0 / 16695) * k3[i] +
                       Real(71.0 / 1920) * k4[i] - Real(17253.0 / 339200) * k5[i] +
                       Real(22.0 / 525) * k6[i] - Real(1.0 / 40) * slope[i]);
    });
  }
};

/// The method for `integrate`, with `f` giving dx/dt [N].
template <class F, class Real, std::size_t N>
class Dopri5 {
 public:
  static constexpr int kErrorOrder = 5;
  constexpr explicit Dopri5(const F& f) : f_(f) {}
  constexpr void begin(const Array<Real, N>& x) { slope_ = f_(x); }
  constexpr auto step(const Array<Real, N>& x, Real step_s) const {
    return Dopri5Step<Real, N>(f_, x, slope_, step_s);
  }
  constexpr void go_on(const Dopri5Step<Real, N>& step) { slope_ = step.slope; }
  constexpr void go_on(const Dopri5Step<Real, N>& step, const Array<Real, N>& /*x*/,
                       const TruthOf<Real>& taken) {
    for (std::size_t i = 0; i < N; ++i) slope_[i] = select(taken, step.slope[i], slope_[i]);
  }

 private:
  const F& f_;
  Array<Real, N> slope_{};
};

}  // namespace eagerx::models

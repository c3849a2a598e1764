// The method of Dormand and Prince: fifth order, with an error estimate of fourth order that
// chooses the steps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <limits>
#include <models/engines/ode_engine/elementwise.hpp>

namespace eagerx::models {

/// What a step must satisfy: with e_i the estimated error of state i in this step, the Euclidean
/// norm of e_i / (atol + rtol·|x_i|) must be at most 1, where |x_i| is the larger one at both ends
/// of the step.
template <class Real>
struct Dopri5Settings {
  Real rtol;
  Real atol;
  Real shortest_s;          // never try a shorter step, but for the last of a call
  Real longest_s;           // never try a longer step
  std::uint32_t max_tries;  // accepted and refused steps of one call
};

enum class Dopri5Outcome : std::uint8_t {
  done,
  too_many_steps,  // max_tries
  step_too_short,  // the error is too large, or not a number, in the shortest step
};

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

  /// Square of the error's norm relative to the tolerances; NaN if anything is.
  constexpr Real error_squared(const State& x, const Dopri5Settings<Real>& settings) const {
    Real sum{0};
    for (std::size_t i = 0; i < N; ++i) {
      const Real size = eagerx::max(eagerx::abs(x[i]), eagerx::abs(end[i]));
      const Real ratio = error[i] / (settings.atol + settings.rtol * size);
      sum += ratio * ratio;
    }
    return sum;
  }
};

/// Factor from a step to the next: 0.9 · error^(-1/5), within 1/5 and 5. 1/5 for NaN and infinity.
template <class Real>
constexpr Real dopri5_step_factor(Real error_squared) {
  constexpr auto kSafety = Real(0.9);
  constexpr auto kLeast = Real(0.2);
  constexpr auto kMost = Real(5);
  constexpr auto kTinyErrorSquared = Real(1e-8);  // any smaller one gives kMost as well
  constexpr auto kHugeErrorSquared = Real(1e10);  // any larger one gives kLeast as well
  if (!(error_squared < kHugeErrorSquared)) return kLeast;
  const Real bounded = eagerx::max(error_squared, kTinyErrorSquared);
  const Real factor = kSafety * eagerx::exp(Real(-0.1) * eagerx::log(bounded));
  return eagerx::max(kLeast, eagerx::min(factor, kMost));
}

/// Integrates `x` [N] over `span_s` seconds with steps chosen by the error, `f` giving dx/dt [N].
/// `next_step_s` is the step to begin with (0: not known, span/100 is tried) and gets the one to go
/// on with. If the outcome is not `done`, `x` is the last state that met the tolerances, at some
/// earlier time.
template <class F, class Real, std::size_t N>
constexpr Dopri5Outcome dopri5(const F& f, Array<Real, N>& x, Real span_s, Real& next_step_s,
                               const Dopri5Settings<Real>& settings) {
  // A remainder that is this much longer than a step is covered by one step.
  constexpr auto kStretch = Real(1.01);
  // Steps below the resolution of time within the span would go on forever.
  const Real resolution_s = span_s * std::numeric_limits<Real>::epsilon();
  const Real shortest_s = eagerx::max(settings.shortest_s, resolution_s);

  const auto limited = [&](Real step_s) {
    return eagerx::min(eagerx::max(step_s, shortest_s), settings.longest_s);
  };
  Real step_s = limited(next_step_s > Real(0) ? next_step_s : span_s * Real(0.01));
  Real remaining_s = span_s;
  Real most_growth = std::numeric_limits<Real>::max();
  Array<Real, N> slope = f(x);
  for (std::uint32_t tries = 0; tries < settings.max_tries; ++tries) {
    const bool last = remaining_s <= eagerx::min(step_s * kStretch, settings.longest_s);
    const Real tried_s = last ? remaining_s : step_s;
    const Dopri5Step<Real, N> step(f, x, slope, tried_s);
    const Real error_squared = step.error_squared(x, settings);
    const Real proposed_s = tried_s * eagerx::min(dopri5_step_factor(error_squared), most_growth);
    if (error_squared <= Real(1)) {
      x = step.end;
      slope = step.slope;
      remaining_s -= tried_s;
      most_growth = std::numeric_limits<Real>::max();
      if (last) {  // cut short by the end of the span: no reason to go on with less than planned
        next_step_s = limited(eagerx::max(step_s, proposed_s));
        return Dopri5Outcome::done;
      }
    } else {
      if (tried_s <= shortest_s) {
        next_step_s = Real(0);
        return Dopri5Outcome::step_too_short;
      }
      most_growth = Real(1);  // do not try the refused step again at once
    }
    step_s = limited(proposed_s);
  }
  next_step_s = step_s;
  return Dopri5Outcome::too_many_steps;
}

}  // namespace eagerx::models

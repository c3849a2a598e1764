// Integration with steps of adaptive size, chosen by an error estimate.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <limits>

namespace eagerx::models {

/// The condition on a step: with e_i the estimated error of state i in this step, the Euclidean
/// norm of e_i / (atol + rtol·|x_i|) must be at most 1, where |x_i| is the larger one at both ends
/// of the step.
template <class Real>
struct AdaptiveSettings {
  Real rtol;
  Real atol;
  Real shortest_s;          // never try a shorter step, but for the last of a call
  Real longest_s;           // never try a longer step
  std::uint32_t max_tries;  // accepted and refused steps of one call
};

/// Numbers and SIMD vectors have the same settings.
template <class Real>
using SettingsFor = AdaptiveSettings<LaneOf<Real>>;

enum class AdaptiveOutcome : std::uint8_t {
  done,
  too_many_steps,  // max_tries
  step_too_short,  // the error is too large, or not a number, in the shortest step
};

/// Square of the norm of `error` [N] relative to the tolerances, for a step from `begin` [N] to
/// `end` [N]; NaN if anything is.
template <class Real, std::size_t N, class Setting>
[[gnu::always_inline]] inline constexpr Real error_squared(
    const Array<Real, N>& error, const Array<Real, N>& begin, const Array<Real, N>& end,
    const AdaptiveSettings<Setting>& settings) {
  const Real atol(settings.atol);
  const Real rtol(settings.rtol);
  Real sum(LaneOf<Real>(0));
  for (std::size_t i = 0; i < N; ++i) {
    const Real size = eagerx::max(eagerx::abs(begin[i]), eagerx::abs(end[i]));
    const Real ratio = error[i] / (atol + rtol * size);
    sum += ratio * ratio;
  }
  return sum;
}

/// Factor from a step to the next: 0.9 · error^(-1/order), within 1/5 and 5, with `order` 4 or 5,
/// that of the error of a step. 1/5 for NaN and infinity.
template <class Real>
constexpr Real step_factor(Real error_squared, int order) {
  using Lane = LaneOf<Real>;
  constexpr auto kSafety = Lane(0.9);
  constexpr auto kLeast = Lane(0.2);
  constexpr auto kMost = Lane(5);
  constexpr auto kTinyErrorSquared = Lane(1e-8);  // any smaller one gives kMost as well
  constexpr auto kHugeErrorSquared = Lane(1e10);  // any larger one gives kLeast as well
  const auto is_bounded = error_squared < Real(kHugeErrorSquared);
  if constexpr (lanes<Real> == 1) {
    if (!is_bounded) return kLeast;
  }
  const Real bounded = eagerx::max(error_squared, Real(kTinyErrorSquared));
  const Real exponent(order == 5 ? Lane(-0.1) : Lane(-0.125));
  const Real factor = Real(kSafety) * eagerx::exp(exponent * eagerx::log(bounded));
  return select(is_bounded, eagerx::max(Real(kLeast), eagerx::min(factor, Real(kMost))),
                Real(kLeast));
}

/// Integrates `x` [N] over `span_s` seconds with steps of `method` that are chosen by the error.
/// `next_step_s` is the step to begin with (0: not known, span/100 is tried) and receives the one
/// to continue with. If the outcome is not `done`, `x` is the last state that met the tolerances,
/// at some
/// earlier time. A method has
///   static constexpr int kErrorOrder;   // the error of a step is of the order h^kErrorOrder
///   void begin(x);                      // a first step from x follows
///   auto step(x, step_s) const;         // with the members `end` and `error`, both [N]
///   void go_on(step);                   // the step was taken, another one follows
template <class Method, class Real, std::size_t N>
constexpr AdaptiveOutcome integrate(Method& method, Array<Real, N>& x, Real span_s,
                                    Real& next_step_s, const AdaptiveSettings<Real>& settings) {
  // A remainder that is this much longer than a step is covered by one step.
  constexpr auto kStretch = Real(1.01);
  // Steps below the resolution of time within the span would never end.
  const Real resolution_s = span_s * std::numeric_limits<Real>::epsilon();
  const Real shortest_s = eagerx::max(settings.shortest_s, resolution_s);

  const auto limited = [&](Real step_s) {
    return eagerx::min(eagerx::max(step_s, shortest_s), settings.longest_s);
  };
  Real step_s = limited(next_step_s > Real(0) ? next_step_s : span_s * Real(0.01));
  Real remaining_s = span_s;
  Real most_growth = std::numeric_limits<Real>::max();
  method.begin(x);
  for (std::uint32_t tries = 0; tries < settings.max_tries; ++tries) {
    const bool last = remaining_s <= eagerx::min(step_s * kStretch, settings.longest_s);
    const Real tried_s = last ? remaining_s : step_s;
    const auto step = method.step(x, tried_s);
    const Real error = error_squared(step.error, x, step.end, settings);
    const Real factor = step_factor(error, Method::kErrorOrder);
    const Real proposed_s = tried_s * eagerx::min(factor, most_growth);
    if (error <= Real(1)) {
      x = step.end;
      remaining_s -= tried_s;
      most_growth = std::numeric_limits<Real>::max();
      if (last) {  // cut short by the end of the span: no reason to continue with less than planned
        next_step_s = limited(eagerx::max(step_s, proposed_s));
        return AdaptiveOutcome::done;
      }
      method.go_on(step);
    } else {
      if (tried_s <= shortest_s) {
        next_step_s = Real(0);
        return AdaptiveOutcome::step_too_short;
      }
      most_growth = Real(1);  // do not try the refused step again at once
    }
    step_s = limited(proposed_s);
  }
  next_step_s = step_s;
  return AdaptiveOutcome::too_many_steps;
}

}  // namespace eagerx::models

// A PID controller with limits.
#pragma once

#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// Every tick: u := clamp(kp·e + Σ(ki·e)/rate − kd·d + feed_forward, low, high); see the manifest.
/// The integral keeps its value when ki is tuned, so that u does not jump.
/// The derivative is that of `measured`, so that nothing jumps with the setpoint.
template <class Io>
class PidController {
 public:
  void reset(const typename Io::States& states) {
    sum_ = {};
    last_ = {};
    has_last_ = {};
    tune(states);
  }
  void tune([[maybe_unused]] const typename Io::States& states) {
    if constexpr (requires { states.kp; }) kp_.reset(states.kp, constant<Real>(Config::kp));
    if constexpr (requires { states.ki; }) ki_.reset(states.ki, constant<Real>(Config::ki));
    if constexpr (requires { states.kd; }) kd_.reset(states.kd, constant<Real>(Config::kd));
    if constexpr (requires { states.setpoint; })
      setpoint_.reset(states.setpoint, constant<Real>(Config::setpoint));
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    const Real nan(FloatFormat<LaneOf<Real>>::nan);
    const Real measured = newest<Real>(in.measured, 0, nan);
    Real setpoint = setpoint_.or_constant(constant<Real>(Config::setpoint));
    if constexpr (requires { in.setpoint; }) setpoint = newest<Real>(in.setpoint, 0, setpoint);
    Real forward(0);
    if constexpr (requires { in.feed_forward; }) forward = newest<Real>(in.feed_forward, 0);
    const Real derivative = derivative_of(in, measured);
    const auto right = eagerx::isfinite(measured) && eagerx::isfinite(derivative) &&
                       eagerx::isfinite(setpoint) && eagerx::isfinite(forward);
    const Real error = within_turn(setpoint - measured, kTurn);
    put(out.u, 0, output<requires { in.feed_forward; }>(right, error, derivative, forward));
  }

 private:
  using Real = typename Io::Real;
  using Config = typename Io::Config;
  static constexpr auto kLow = constant<Real>(Config::low);
  static constexpr auto kHigh = constant<Real>(Config::high);
  static constexpr auto kTurn = constant<Real>(Config::turn);
  static_assert(kLow < kHigh, "PidController: the lowest output is below the highest");

  Real derivative_of(const typename Io::Inputs& in, const Real& measured) {
    if constexpr (requires { in.derivative; }) {
      return newest<Real>(in.derivative, 0, Real(FloatFormat<LaneOf<Real>>::nan));
    } else {
      const auto right = eagerx::isfinite(measured);
      const Real moved = within_turn(measured - last_, kTurn);
      const Real change = select(has_last_ > Real(0), moved, Real(0));
      last_ = select(right, measured, last_);
      has_last_ = select(right, Real(1), has_last_);
      return change * Real(constant<Real>(Io::Rate::hz));
    }
  }

  /// Zero, moved into the limits, unless `right`.
  template <bool HasForward, class Truth>
  Real output(const Truth& right, const Real& error, const Real& derivative, const Real& forward) {
    constexpr auto kPeriod = constant<Real>(Io::Rate::period_s);
    const Real sum_term = ki_.or_constant(constant<Real>(Config::ki)) * error;
    const auto sum = sum_.plus(sum_term * Real(kPeriod));
    Real wanted = (kp_.or_constant(constant<Real>(Config::kp)) * error + sum.value) -
                  kd_.or_constant(constant<Real>(Config::kd)) * derivative;
    // Not even zero is added without it: −0 would become 0.
    if constexpr (HasForward) wanted += forward;
    const auto winds_up =
        (wanted > Real(kHigh) && sum_term > Real(0)) || (wanted < Real(kLow) && sum_term < Real(0));
    // Finite inputs can still make inf − inf, which is not an output and not to be kept.
    const auto good = right && !eagerx::isnan(wanted);
    const auto sums = good && !winds_up && eagerx::isfinite(sum.value);
    sum_ = {select(sums, sum.value, sum_.value), select(sums, sum.rest, sum_.rest)};
    return eagerx::clamp(select(good, wanted, Real(0)), Real(kLow), Real(kHigh));
  }

  CompensatedSum<Real> sum_{};  // of ki·e/rate, in the unit of u
  Real last_{};                 // measured, a tick ago
  Real has_last_{};             // 1 after the first measured

  using States = typename Io::States;
  static constexpr bool kTunesKp = requires(States s) { s.kp; };
  static constexpr bool kTunesKi = requires(States s) { s.ki; };
  static constexpr bool kTunesKd = requires(States s) { s.kd; };
  static constexpr bool kTunesSetpoint = requires(States s) { s.setpoint; };
  [[no_unique_address]] Tunable<Real, kTunesKp, 0> kp_;
  [[no_unique_address]] Tunable<Real, kTunesKi, 1> ki_;
  [[no_unique_address]] Tunable<Real, kTunesKd, 2> kd_;
  [[no_unique_address]] Tunable<Real, kTunesSetpoint, 3> setpoint_;
};

}  // namespace eagerx::models

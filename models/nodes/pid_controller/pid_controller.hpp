// A PID controller with limits.
#pragma once

#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <type_traits>

namespace eagerx::models {

/// Every tick: u := clamp(kp·e + ki·Σe/rate − kd·d, low, high); see the manifest. The derivative is
/// that of `measured`, so that nothing jumps.
template <class Io>
class PidController {
 public:
  void reset(const typename Io::States& /*states*/) {
    sum_ = {};
    last_ = {};
    has_last_ = false;
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    element(out.u, 0) = static_cast<ScalarOf<decltype(out.u)>>(next(in));
  }

 private:
  using Real = typename Io::Real;
  using Config = typename Io::Config;
  template <class Message>
  using ScalarOf = eagerx::ScalarOf<std::remove_cvref_t<Message>>;
  static constexpr auto kLow = static_cast<Real>(Config::low);
  static constexpr auto kHigh = static_cast<Real>(Config::high);
  static_assert(kLow < kHigh, "PidController: the lowest output is below the highest");

  Real next(const typename Io::Inputs& in) {
    const Real zero = eagerx::clamp(Real(0), kLow, kHigh);
    if (in.measured.empty()) return zero;
    const auto measured = static_cast<Real>(element(in.measured.back(), 0));
    if (!eagerx::isfinite(measured)) return zero;
    Real derivative{};
    if constexpr (requires { in.derivative; }) {
      if (in.derivative.empty()) return zero;
      derivative = static_cast<Real>(element(in.derivative.back(), 0));
      if (!eagerx::isfinite(derivative)) return zero;
    } else {
      const Real change = has_last_ ? within_turn(measured - last_) : Real(0);
      derivative = change * static_cast<Real>(Io::Rate::hz);
      last_ = measured;
      has_last_ = true;
    }
    return output(within_turn(static_cast<Real>(Config::setpoint) - measured), derivative);
  }

  Real output(Real error, Real derivative) {
    constexpr auto kPeriod = static_cast<Real>(Io::Rate::period_s);
    const Real sum = sum_ + error * kPeriod;
    const Real wanted =
        (static_cast<Real>(Config::kp) * error + static_cast<Real>(Config::ki) * sum) -
        static_cast<Real>(Config::kd) * derivative;
    const bool winds_up = (wanted > kHigh && sum_term(error) > Real(0)) ||
                          (wanted < kLow && sum_term(error) < Real(0));
    if (!winds_up) sum_ = sum;
    return eagerx::clamp(wanted, kLow, kHigh);
  }

  static Real sum_term(Real error) { return static_cast<Real>(Config::ki) * error; }

  /// Moved by whole turns into [−turn/2, turn/2].
  static Real within_turn(Real x) {
    constexpr auto kTurn = static_cast<Real>(Config::turn);
    if constexpr (kTurn > Real(0)) {
      return x - kTurn * eagerx::round(x / kTurn);
    } else {
      return x;
    }
  }

  Real sum_{};   // of the errors, in their unit times seconds
  Real last_{};  // measured, a tick ago
  bool has_last_ = false;
};

}  // namespace eagerx::models

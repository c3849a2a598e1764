// Delays a signal, also by fractions of a tick.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/nodes/action_limits/per_element.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// y(t) = signal(t − delay), on a straight line between two ticks; `initial` before the first
/// signal. A reset may set the delay, up to `max_delay`. NaN passes.
/// Looks up lane by lane: lanes of a SIMD vector may have other delays.
template <class Io>
class TransportDelay {
 public:
  void reset(const typename Io::States& states) {
    delay_.reset(Real(constant<Real>(Io::Config::delay)));
    if constexpr (requires { states.delay; }) {
      if (states.delay) delay_.set(static_cast<Real>(*states.delay));
    }
    for (std::size_t i = 0; i < kSize; ++i) {
      for (Real& old : past_[i]) old = each<Real>(kInitial, i);
    }
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    for (std::size_t i = 0; i < kSize; ++i) {
      std::array<Real, kTicks + 2>& past = past_[i];
      for (std::size_t k = past.size() - 1; k > 0; --k) past[k] = past[k - 1];
      past[0] = newest<Real>(in.signal, i, each<Real>(kInitial, i));
      Real y = past[0];
      for (int k = 0; k < lanes<Real>; ++k) set_lane(y, k, at(past, lane(delay_.value, k), k));
      put(out.y, i, y);
    }
  }

 private:
  using Real = typename Io::Real;
  using Lane = LaneOf<Real>;
  static constexpr std::size_t kSize = elements_of<decltype(Io::Outputs::y)>;
  static constexpr double kMost = Io::Config::max_delay * Io::Rate::hz;
  static constexpr auto kTicks = static_cast<std::size_t>(kMost + 0.999999);
  static constexpr auto kInitial = constants<Real>(Io::Config::initial);
  static_assert(is_one_or_each(kInitial, kSize),
                "TransportDelay: `initial` has one value, or one for each element");
  static_assert(Io::Config::delay <= Io::Config::max_delay,
                "TransportDelay: `delay` is not above `max_delay`");

  /// The value received `delay` seconds ago.
  static Lane at(const std::array<Real, kTicks + 2>& past, Lane delay, int lane_number) {
    const Lane wanted = delay * constant<Real>(Io::Rate::hz);
    // NaN is none.
    const Lane ticks = wanted > Lane(0) ? eagerx::min(wanted, constant<Real>(kMost)) : Lane(0);
    const auto whole = static_cast<std::size_t>(ticks);
    const Lane part = ticks - static_cast<Lane>(whole);
    const Lane young = lane(past[whole], lane_number);
    if (part == Lane(0)) return young;
    return (Lane(1) - part) * young + part * lane(past[whole + 1], lane_number);
  }

  ResetNumber<Real> delay_{};                               // [s]
  std::array<std::array<Real, kTicks + 2>, kSize> past_{};  // the newest first
};

}  // namespace eagerx::models

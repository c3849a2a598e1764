// Real time: every step ends at its own deadline on the monotonic clock.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <eagerx/safety.hpp>

namespace eagerx::linux_sim {

/// Nanoseconds of CLOCK_MONOTONIC.
std::int64_t now_ns();

/// CLOCK_MONOTONIC of this machine.
struct MonotonicClock {
  static std::int64_t now_ns() { return linux_sim::now_ns(); }
  /// Returns early when the run is interrupted.
  static void sleep_until(std::int64_t ns);
};

/// Holds the steps of an episode to absolute deadlines, start + n·period, so that lateness does not
/// add up. `Clock` has static now_ns() and sleep_until(ns).
template <class Clock>
class PacerOn {
 public:
  /// `period_s` in simulated seconds, `factor` in simulated seconds a second of wall-clock; 0 does
  /// not pace at all. A step that begins more than `max_lateness_ns` late is too late.
  PacerOn(double period_s, double factor, std::int64_t max_lateness_ns)
      : period_ns_(factor > 0.0 ? period_s / factor * kNsPerSecond : 0.0),
        max_lateness_ns_(max_lateness_ns) {}

  bool paces() const { return period_ns_ > 0.0; }
  /// Whether a step takes so long that nothing should wait for the next one.
  bool is_slow() const { return period_ns_ > kNsPerSecond / 4; }
  /// Begins an episode; the duration of its reset does not count.
  void start() {
    start_ns_ = due_ns_ = Clock::now_ns();
    late_in_a_row_ = 0;
  }
  /// Sleeps until the deadline of step `n` of the episode (from 1). A step that ends later is an
  /// overrun, and the next one starts immediately. Returns early on a signal.
  void wait_for(std::uint64_t n) {
    // A double holds whole nanoseconds for 104 days.
    due_ns_ = start_ns_ + static_cast<std::int64_t>(static_cast<double>(n) * period_ns_);
    std::int64_t now = Clock::now_ns();
    if (now > due_ns_) {
      ++overruns_;
      worst_ns_ = std::max(worst_ns_, now - due_ns_);
    } else {
      Clock::sleep_until(due_ns_);
      now = Clock::now_ns();
    }
    // Checked after the sleep, during which the program may have been stopped.
    late_in_a_row_ = now - due_ns_ > max_lateness_ns_ ? late_in_a_row_ + 1 : 0;
  }

  /// Time has stood still for so long.
  void pause(std::int64_t ns) {
    start_ns_ += ns;
    due_ns_ += ns;
  }
  /// 2^`power` times as fast as requested, from step `n` on.
  void set_speed(std::uint64_t n, int power) {
    if (power == speed_) return;
    const double period_ns = period_ns_ * std::ldexp(1.0, speed_ - power);
    start_ns_ += static_cast<std::int64_t>(static_cast<double>(n) * (period_ns_ - period_ns));
    period_ns_ = period_ns;
    speed_ = power;
  }

  std::int64_t start_ns() const { return start_ns_; }
  std::uint64_t overruns() const { return overruns_; }
  /// Steps in a row that were too late, now that the latest action is about to be applied.
  std::uint64_t late_in_a_row() const {
    if (!paces()) return 0;
    const std::int64_t age_ns = std::max(Clock::now_ns() - due_ns_, std::int64_t{0});
    return eagerx::late_instants(late_in_a_row_, static_cast<std::uint64_t>(age_ns),
                                 static_cast<std::uint64_t>(std::max(period_ns_, 1.0)),
                                 static_cast<std::uint64_t>(max_lateness_ns_));
  }
  /// Until when the action of the latest instant is in time, as late_in_a_row() checks it; 0:
  /// always.
  std::int64_t in_time_until_ns() const {
    return paces() ? due_ns_ + std::max(static_cast<std::int64_t>(period_ns_), max_lateness_ns_)
                   : 0;
  }
  /// The largest lateness of the end of a step, in seconds.
  double worst_s() const { return static_cast<double>(worst_ns_) / kNsPerSecond; }

 private:
  static constexpr double kNsPerSecond = 1e9;

  double period_ns_;
  std::int64_t max_lateness_ns_;
  int speed_ = 0;
  std::int64_t start_ns_ = 0;
  std::int64_t due_ns_ = 0;  // of the latest instant
  std::int64_t worst_ns_ = 0;
  std::uint64_t overruns_ = 0;
  std::uint64_t late_in_a_row_ = 0;  // instants that began too late
};

using Pacer = PacerOn<MonotonicClock>;

}  // namespace eagerx::linux_sim

// Real time: every step ends at its own deadline on the monotonic clock.
#pragma once

#include <cstdint>

namespace eagerx::linux_sim {

/// Nanoseconds of CLOCK_MONOTONIC.
std::int64_t now_ns();

/// Holds the steps of an episode to absolute deadlines, start + n·period, so that lateness does not
/// add up.
class Pacer {
 public:
  /// `period_s` in simulated seconds, `factor` in simulated seconds a second of wall-clock; 0 does
  /// not pace at all. An overrun of more than `max_lateness_ns` is too late.
  Pacer(double period_s, double factor, std::int64_t max_lateness_ns);

  bool paces() const { return period_ns_ > 0.0; }
  /// An episode begins: its reset took as long as it took.
  void start() {
    start_ns_ = now_ns();
    late_in_a_row_ = 0;
  }
  /// Sleeps until the deadline of step `n` of the episode (from 1). A step that ends after it is an
  /// overrun, and the next one starts at once. Returns early on a signal.
  void wait_for(std::uint64_t n);

  std::int64_t start_ns() const { return start_ns_; }
  std::uint64_t overruns() const { return overruns_; }
  /// Steps up to now that were too late, one after the other.
  std::uint64_t late_in_a_row() const { return late_in_a_row_; }
  /// How far behind its deadline the latest step ended, in seconds.
  double worst_s() const;

 private:
  double period_ns_;
  std::int64_t max_lateness_ns_;
  std::int64_t start_ns_ = 0;
  std::int64_t worst_ns_ = 0;
  std::uint64_t overruns_ = 0;
  std::uint64_t late_in_a_row_ = 0;
};

}  // namespace eagerx::linux_sim

// Time on Linux.
#pragma once

#include <cerrno>
#include <cstdint>
#include <ctime>

extern "C" {
/// Whether a signal wants the program to end or to stop; the target's, if it has one.
[[gnu::weak]] bool eagerx_is_interrupted();
/// Called before a deliberate sleep until this time; defined by the target, if at all.
[[gnu::weak]] void eagerx_sleeps_until(std::int64_t ns);
}

namespace eagerx::links {

/// CLOCK_MONOTONIC in nanoseconds.
struct LinuxClock {
  static std::int64_t now_ns() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<std::int64_t>(now.tv_sec) * kNsPerSecond + now.tv_nsec;
  }
  /// Sleeps until an absolute time, so that lateness does not add up. False if a signal came first.
  static bool sleep_until(std::int64_t ns) {
    if (eagerx_sleeps_until != nullptr) eagerx_sleeps_until(ns);
    const timespec until{static_cast<time_t>(ns / kNsPerSecond),
                         static_cast<decltype(timespec::tv_nsec)>(ns % kNsPerSecond)};
    return clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) != EINTR;
  }

  /// Whether a signal arrived outside of sleep_until().
  static bool is_interrupted() {
    return eagerx_is_interrupted != nullptr && eagerx_is_interrupted();
  }

  static constexpr std::int64_t kNsPerSecond = 1'000'000'000;
};

}  // namespace eagerx::links

// An engine whose time is what a test says.
#pragma once

#include <cstdint>
#include <eagerx/rate.hpp>

namespace async_test {

/// The clock, and by how much the slot of one tick begins too late.
struct Clock {
  static inline std::int64_t now_ns = 0;
  static inline eagerx::Seq late_tick = 0;  // 0: none
  static inline std::int64_t late_ns = 0;
};

template <class Model>
struct NoSimulator {
  void reset() {}
};

/// Tick n begins at n/rate, or at once if that has passed.
template <class Io>
class ClockEngine {
 public:
  static std::int64_t now_ns() { return Clock::now_ns; }

  void reset(const typename Io::States& /*states*/) { start_ns_ = Clock::now_ns; }
  void callback(const eagerx::Tick& tick) {
    const auto period_ns =
        static_cast<std::int64_t>(Io::Rate::den * std::uint64_t{1'000'000'000} / Io::Rate::num);
    const std::int64_t due_ns = start_ns_ + static_cast<std::int64_t>(tick.n) * period_ns;
    if (Clock::now_ns < due_ns) Clock::now_ns = due_ns;
    if (tick.n == Clock::late_tick) Clock::now_ns = due_ns + Clock::late_ns;
  }

 private:
  std::int64_t start_ns_ = 0;
};

}  // namespace async_test

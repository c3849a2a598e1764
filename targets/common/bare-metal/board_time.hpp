// The board's clock in nanoseconds, as engines of real hardware need it.
#pragma once

#include <cstdint>
#include <targets/common/bare-metal/clock.hpp>

namespace eagerx::board {

/// Time since start_clock(), which its user calls first.
struct BoardTime {
  static std::int64_t now_ns() {
    const std::uint64_t ticks = clock_ticks();
    const std::uint64_t hz = clock_hz();
    return static_cast<std::int64_t>(ticks / hz * kNsPerSecond + ticks % hz * kNsPerSecond / hz);
  }
  /// Waits without sleeping (`wfi` keeps the wrong time under QEMU). Always true: no signals here.
  static bool sleep_until(std::int64_t ns) {
    const auto time = static_cast<std::uint64_t>(ns);
    const std::uint64_t hz = clock_hz();
    wait_for_clock(time / kNsPerSecond * hz +
                   (time % kNsPerSecond * hz + kNsPerSecond - 1) / kNsPerSecond);
    return true;
  }
  /// A short wait, for drivers. Starts the clock if it is not running.
  static void at_least_ns(std::uint32_t ns) {
    start_clock();
    const std::uint64_t hz = clock_hz();
    wait_for_clock(clock_ticks() + (ns * hz + kNsPerSecond - 1) / kNsPerSecond + 1);
  }

 private:
  static constexpr std::uint64_t kNsPerSecond = 1'000'000'000;
};

}  // namespace eagerx::board

#include <cerrno>
#include <ctime>
#include <runtime/host/base/interrupt.hpp>
#include <targets/linux-sim/pacer.hpp>

namespace eagerx::linux_sim {
namespace {

constexpr std::int64_t kNsPerSecond = 1'000'000'000;

}  // namespace

std::int64_t now_ns() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::int64_t>(now.tv_sec) * kNsPerSecond + now.tv_nsec;
}

void MonotonicClock::sleep_until(std::int64_t ns) {
  const timespec until{static_cast<time_t>(ns / kNsPerSecond),
                       static_cast<long>(ns % kNsPerSecond)};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
    if (host::interrupted() || host::is_stop_requested()) return;
  }
}

}  // namespace eagerx::linux_sim

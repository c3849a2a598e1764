#include <algorithm>
#include <cerrno>
#include <ctime>
#include <targets/linux-sim/interrupt.hpp>
#include <targets/linux-sim/pacer.hpp>

namespace eagerx::linux_sim {
namespace {

constexpr std::int64_t kNsPerSecond = 1'000'000'000;
constexpr double kSecondsPerNs = 1e-9;

}  // namespace

std::int64_t now_ns() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::int64_t>(now.tv_sec) * kNsPerSecond + now.tv_nsec;
}

Pacer::Pacer(double period_s, double factor, std::int64_t max_lateness_ns)
    : period_ns_(factor > 0.0 ? period_s / factor * static_cast<double>(kNsPerSecond) : 0.0),
      max_lateness_ns_(max_lateness_ns) {}

void Pacer::wait_for(std::uint64_t n) {
  // A double holds whole nanoseconds for 104 days.
  const std::int64_t deadline =
      start_ns_ + static_cast<std::int64_t>(static_cast<double>(n) * period_ns_);
  const std::int64_t late_ns = now_ns() - deadline;
  late_in_a_row_ = late_ns > max_lateness_ns_ ? late_in_a_row_ + 1 : 0;
  if (late_ns > 0) {
    ++overruns_;
    worst_ns_ = std::max(worst_ns_, late_ns);
    return;
  }
  const timespec until{static_cast<time_t>(deadline / kNsPerSecond),
                       static_cast<long>(deadline % kNsPerSecond)};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
    if (interrupted()) return;
  }
}

double Pacer::worst_s() const {
  return static_cast<double>(worst_ns_) * kSecondsPerNs;
}

}  // namespace eagerx::linux_sim

#include <algorithm>
#include <limits>
#include <runtime/host/trace/log_clock.hpp>

namespace eagerx::trace_log {

std::int64_t time_of_tick(std::uint64_t count, std::uint64_t num, std::uint64_t den) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::int64_t>::max() / 4;
  constexpr std::uint64_t kNsPerSecond = 1'000'000'000;
  // 64 bits are enough for all rates that make sense, and some machines have no more.
  std::uint64_t periods = 0, rest_ns = 0, whole_ns = 0, time_ns = 0;
  if (!__builtin_mul_overflow(count, den, &periods) &&
      !__builtin_mul_overflow(periods % num, kNsPerSecond, &rest_ns) &&
      !__builtin_add_overflow(rest_ns, num / 2, &rest_ns) &&
      !__builtin_mul_overflow(periods / num, kNsPerSecond, &whole_ns) &&
      !__builtin_add_overflow(whole_ns, rest_ns / num, &time_ns))
    return static_cast<std::int64_t>(std::min(time_ns, kMost));
  const double seconds =
      static_cast<double>(count) * static_cast<double>(den) / static_cast<double>(num);
  return static_cast<std::int64_t>(
      std::min(seconds * static_cast<double>(kNsPerSecond), static_cast<double>(kMost)));
}

LogClock::LogClock(const std::vector<RecordedChannel>& channels) {
  for (const RecordedChannel& channel : channels)
    gap_ns_ = std::max(gap_ns_, time_of_tick(1, channel.rate_num, channel.rate_den));
}

}  // namespace eagerx::trace_log

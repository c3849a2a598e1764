#include "generator/trace/timeline.hpp"

#include <algorithm>
#include <limits>

namespace eagerx::gen {
namespace {

using trace_log::Log;
__extension__ using Wide = unsigned __int128;

constexpr std::uint64_t kSecond_ns = 1'000'000'000;

/// count / (num / den) seconds; the longest time there is for more than that.
std::int64_t time_of(std::uint64_t count, std::uint64_t num, std::uint64_t den) {
  constexpr Wide kMost = std::numeric_limits<std::int64_t>::max();
  const Wide time_ns = (Wide{count} * den * kSecond_ns + num / 2) / num;
  return static_cast<std::int64_t>(std::min(time_ns, kMost / 4));
}

std::int64_t longest_period(const Log& log) {
  std::int64_t longest_ns = 0;
  for (const auto& channel : log.channels)
    longest_ns = std::max(longest_ns, time_of(1, channel.rate_num, channel.rate_den));
  return longest_ns;
}

}  // namespace

Timeline timeline_of(const Log& log) {
  Timeline timeline;
  timeline.in_episode_ns.reserve(log.rows.size());
  timeline.in_log_ns.reserve(log.rows.size());
  const std::int64_t gap_ns = longest_period(log);
  std::int64_t begin_ns = 0, last_ns = 0;
  std::uint32_t episode = 0;
  for (const auto& row : log.rows) {
    const auto& channel = log.channels[row.channel];
    const std::int64_t time_ns = time_of(row.seq, channel.rate_num, channel.rate_den);
    if (row.episode != episode) {
      begin_ns = last_ns + gap_ns;
      episode = row.episode;
    }
    const std::int64_t in_log_ns = log.timed ? row.time_ns : begin_ns + time_ns;
    last_ns = std::max(last_ns, in_log_ns);
    timeline.in_episode_ns.push_back(time_ns);
    timeline.in_log_ns.push_back(in_log_ns);
  }
  return timeline;
}

}  // namespace eagerx::gen

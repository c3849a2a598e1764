#include "generator/trace/timeline.hpp"

#include <algorithm>
#include <limits>
#include <utility>

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

/// When each episode of a log with time stamps would have begun: of the first message of each
/// channel the earliest, less its place in the episode.
std::vector<std::int64_t> measured_begins(const Log& log, const Timeline& timeline) {
  std::vector<std::int64_t> begins(log.episodes(), std::numeric_limits<std::int64_t>::max());
  std::vector<std::int64_t> seen(log.channels.size(), -1);  // the last episode
  for (std::size_t i = 0; i < log.rows.size(); ++i) {
    const auto& row = log.rows[i];
    if (std::exchange(seen[row.channel], std::int64_t{row.episode}) == row.episode) continue;
    std::int64_t& begin = begins[row.episode];
    begin = std::min(begin, row.time_ns - timeline.in_episode_ns[i]);
  }
  return begins;
}

}  // namespace

std::int64_t time_of_tick(const trace_log::RecordedChannel& channel, std::uint64_t tick) {
  return time_of(tick, channel.rate_num, channel.rate_den);
}

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
  timeline.planned_ns = timeline.in_log_ns;
  if (!log.timed) return timeline;
  const std::vector<std::int64_t> begins = measured_begins(log, timeline);
  for (std::size_t i = 0; i < log.rows.size(); ++i)
    timeline.planned_ns[i] = begins[log.rows[i].episode] + timeline.in_episode_ns[i];
  return timeline;
}

}  // namespace eagerx::gen

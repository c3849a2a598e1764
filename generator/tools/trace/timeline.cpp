#include "generator/tools/trace/timeline.hpp"

#include <algorithm>
#include <limits>
#include <runtime/host/trace/log_clock.hpp>
#include <utility>

namespace eagerx::gen {
namespace {

using trace_log::Log;

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
  return trace_log::time_of_tick(tick, channel.rate_num, channel.rate_den);
}

Timeline timeline_of(const Log& log) {
  Timeline timeline;
  timeline.in_episode_ns.reserve(log.rows.size());
  timeline.in_log_ns.reserve(log.rows.size());
  trace_log::LogClock clock(log.channels);
  for (const auto& row : log.rows) {
    const std::int64_t time_ns = time_of_tick(log.channels[row.channel], row.seq);
    timeline.in_episode_ns.push_back(time_ns);
    timeline.in_log_ns.push_back(log.timed ? row.time_ns : clock.in_log_ns(row.episode, time_ns));
  }
  timeline.planned_ns = timeline.in_log_ns;
  if (!log.timed) return timeline;
  const std::vector<std::int64_t> begins = measured_begins(log, timeline);
  for (std::size_t i = 0; i < log.rows.size(); ++i)
    timeline.planned_ns[i] = begins[log.rows[i].episode] + timeline.in_episode_ns[i];
  return timeline;
}

}  // namespace eagerx::gen

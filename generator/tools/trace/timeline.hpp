// Times at which the messages of a log were sent.
#pragma once

#include <cstdint>
#include <runtime/host/trace/log_file.hpp>
#include <vector>

namespace eagerx::gen {

/// Times of the rows of a log, in its order. Without time stamps a message's is that of its tick:
/// its number over the rate of its channel, to the nearest nanosecond.
struct Timeline {
  std::vector<std::int64_t> in_episode_ns;  // by the graph's clock
  /// Behind the start of the log, without steps back between episodes: as measured, if the run was
  /// paced; else each episode begins one period of its slowest channel after the one before.
  std::vector<std::int64_t> in_log_ns;
  /// The same as planned: of its tick, counted from when its episode would have begun.
  std::vector<std::int64_t> planned_ns;
};
Timeline timeline_of(const trace_log::Log& log);
/// Time of a tick since the start of its episode.
std::int64_t time_of_tick(const trace_log::RecordedChannel& channel, std::uint64_t tick);

}  // namespace eagerx::gen

// Send times of a log's messages, one after the other.
#pragma once

#include <cstdint>
#include <runtime/host/trace/log_file.hpp>
#include <vector>

namespace eagerx::trace_log {

/// Time of tick `count` at a rate of num / den Hz, to the nearest nanosecond; saturates.
std::int64_t time_of_tick(std::uint64_t count, std::uint64_t num, std::uint64_t den);

/// Behind the start of a log, without steps back between episodes: each begins one period of the
/// slowest channel after the one before.
class LogClock {
 public:
  explicit LogClock(const std::vector<RecordedChannel>& channels);

  /// Time of a message that was sent `in_episode_ns` after the start of `episode`; call it in the
  /// order of the log.
  std::int64_t in_log_ns(std::uint32_t episode, std::int64_t in_episode_ns) {
    const std::int64_t time_ns = in_log_of_other_ns(episode, in_episode_ns);
    if (time_ns > last_ns_) last_ns_ = time_ns;
    return time_ns;
  }
  /// The same of something that is no message: the next episode begins no later because of it.
  std::int64_t in_log_of_other_ns(std::uint32_t episode, std::int64_t in_episode_ns) {
    if (episode != episode_) {
      begin_ns_ = last_ns_ + gap_ns_;
      episode_ = episode;
    }
    return begin_ns_ + in_episode_ns;
  }

 private:
  std::int64_t gap_ns_ = 0, begin_ns_ = 0, last_ns_ = 0;
  std::uint32_t episode_ = 0;
};

}  // namespace eagerx::trace_log

#include <fmt/format.h>

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "generator/support/quote/quote.hpp"
#include "generator/tools/trace/convert.hpp"
#include "generator/tools/trace/timeline.hpp"

namespace eagerx::gen {
namespace {

using trace_log::Log;

/// "pendulum" of "pendulum/theta/observation".
std::string owner_of(const std::string& channel) {
  return channel.substr(0, channel.find('/'));
}

/// {"0":1.5,"1":2}: what a counter of Perfetto shows; empty if nothing in it is finite.
std::string arguments_of(const Log& log, const trace_log::Row& row) {
  const auto& channel = log.channels[row.channel];
  std::string text;
  trace_log::Row one = row;
  for (std::uint64_t i = 0; i < channel.size; ++i) {
    const double value = trace_log::number_of(channel.dtype, log.values_of(one)[i]);
    if (!(value - value == 0.0)) continue;
    text += fmt::format("{}\"{}\":{}", text.empty() ? "" : ",",
                        channel.size == 1 ? "value" : fmt::format("{}", i),
                        trace_log::text_of(channel.dtype, log.values_of(one)[i]));
  }
  return text.empty() ? text : "{" + text + "}";
}

/// Microseconds with their nanoseconds, in whole numbers so that long logs lose nothing.
std::string microseconds(std::int64_t time_ns) {
  // A first message that was sent early can give its episode a start before the log, so times may
  // be negative.
  const std::int64_t size_ns = time_ns < 0 ? -time_ns : time_ns;
  return fmt::format("{}{}.{:03}", time_ns < 0 ? "-" : "", size_ns / 1000, size_ns % 1000);
}

/// "pendulum/theta" of "pendulum/theta/observation".
std::string node_of(const std::string& channel) {
  return channel.substr(0, channel.rfind('/'));
}

/// A node has a track of its planned ticks and, of a log with time stamps, one of what was
/// measured.
struct Track {
  std::size_t process = 0, planned = 0;
  std::optional<std::pair<std::uint32_t, std::uint64_t>> last = {};  // episode and tick
};

class EventWriter {
 public:
  explicit EventWriter(const Log& log) : log_(log), timeline_(timeline_of(log)) {}

  std::string write() {
    name_tracks();
    std::int64_t episode = -1;
    for (std::size_t i = 0; i < log_.rows.size(); ++i) {
      const auto& row = log_.rows[i];
      if (row.episode != episode) {
        episode = row.episode;
        add(fmt::format(R"({{"ph":"i","s":"g","name":"episode {}","pid":0,"tid":0,"ts":{}}})",
                        episode, microseconds(timeline_.in_log_ns[i])));
      }
      add_planned(i);
      if (log_.timed) add_measured(i);
      add_counter(i);
    }
    return text_ + "\n]}\n";
  }

 private:
  void add(const std::string& event) {
    text_ += (first_ ? "" : ",\n") + event;
    first_ = false;
  }
  void name(const char* what, std::size_t process, std::size_t thread, const std::string& name) {
    add(fmt::format(R"({{"ph":"M","name":"{}","pid":{},"tid":{},"args":{{"name":{}}}}})", what,
                    process, thread, quoted_json(name)));
  }

  void name_tracks() {
    std::map<std::string, std::size_t> processes, nodes;
    for (const auto& channel : log_.channels) {
      const std::string owner = owner_of(channel.name), node = node_of(channel.name);
      const auto [process, is_new] = processes.try_emplace(owner, processes.size() + 1);
      if (is_new) name("process_name", process->second, 0, owner);
      const std::size_t planned = 2 * nodes.try_emplace(node, nodes.size()).first->second + 1;
      tracks_.push_back({planned, process->second});
      if (!states_.try_emplace(planned, Track{process->second, planned}).second) continue;
      name("thread_name", process->second, planned, node + ", planned");
      if (log_.timed) name("thread_name", process->second, planned + 1, node + ", measured");
    }
  }

  /// A tick lasts until the next one.
  void add_planned(std::size_t i) {
    const auto& row = log_.rows[i];
    Track& track = states_.at(tracks_[row.channel].first);
    const auto tick = std::make_pair(row.episode, row.seq);
    if (track.last == tick) return;  // another output of the node
    track.last = tick;
    const auto& channel = log_.channels[row.channel];
    const std::int64_t lasts_ns =
        time_of_tick(channel, row.seq + 1) - time_of_tick(channel, row.seq);
    add(fmt::format(R"({{"ph":"X","name":"tick {}","pid":{},"tid":{},"ts":{},"dur":{}}})", row.seq,
                    track.process, track.planned, microseconds(timeline_.planned_ns[i]),
                    microseconds(lasts_ns)));
  }
  void add_measured(std::size_t i) {
    const auto& row = log_.rows[i];
    const auto& [planned, process] = tracks_[row.channel];
    const std::int64_t late_ns = timeline_.in_log_ns[i] - timeline_.planned_ns[i];
    add(fmt::format(R"({{"ph":"i","s":"t","name":{},"pid":{},"tid":{},"ts":{},)"
                    R"("args":{{"tick":{},"late_ns":{}}}}})",
                    quoted_json(log_.channels[row.channel].name), process, planned + 1,
                    microseconds(timeline_.in_log_ns[i]), row.seq, late_ns));
  }
  void add_counter(std::size_t i) {
    const auto& row = log_.rows[i];
    const std::string arguments = arguments_of(log_, row);
    if (arguments.empty()) return;
    add(fmt::format(R"({{"ph":"C","name":{},"pid":{},"ts":{},"args":{}}})",
                    quoted_json(log_.channels[row.channel].name), tracks_[row.channel].second,
                    microseconds(timeline_.in_log_ns[i]), arguments));
  }

  const Log& log_;
  const Timeline timeline_;
  std::vector<std::pair<std::size_t, std::size_t>> tracks_;  // planned track, process; by channel
  std::map<std::size_t, Track> states_;                      // by planned track
  std::string text_ = "{\"displayTimeUnit\":\"ms\",\"traceEvents\":[\n";
  bool first_ = true;
};

}  // namespace

// Trace Event Format: a process for each node and object, in it for each node a slice a tick as
// planned and an instant a message as measured, a counter for each channel, and an instant where an
// episode begins.
std::string trace_json(const Log& log) {
  return EventWriter(log).write();
}

}  // namespace eagerx::gen

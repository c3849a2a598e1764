#include <fmt/format.h>

#include <map>

#include "generator/quote/quote.hpp"
#include "generator/trace/convert.hpp"
#include "generator/trace/timeline.hpp"

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
  return fmt::format("{}.{:03}", time_ns / 1000, time_ns % 1000);
}

}  // namespace

// Trace Event Format: a process for each node and object, a counter for each channel, an instant
// where an episode begins.
std::string trace_json(const Log& log) {
  const Timeline timeline = timeline_of(log);
  std::map<std::string, std::size_t> processes;
  std::string text = "{\"displayTimeUnit\":\"ms\",\"traceEvents\":[\n";
  std::string separator;
  const auto add = [&](const std::string& event) {
    text += separator + event;
    separator = ",\n";
  };
  for (const auto& channel : log.channels) {
    const auto [entry, added] = processes.try_emplace(owner_of(channel.name), processes.size() + 1);
    if (!added) continue;
    add(fmt::format(R"({{"ph":"M","name":"process_name","pid":{},"args":{{"name":{}}}}})",
                    entry->second, quoted_json(entry->first)));
  }
  std::int64_t episode = -1;
  for (std::size_t i = 0; i < log.rows.size(); ++i) {
    const auto& row = log.rows[i];
    const std::string time = microseconds(timeline.in_log_ns[i]);
    if (row.episode != episode) {
      episode = row.episode;
      add(fmt::format(R"({{"ph":"i","s":"g","name":"episode {}","pid":0,"tid":0,"ts":{}}})",
                      episode, time));
    }
    const std::string arguments = arguments_of(log, row);
    if (arguments.empty()) continue;
    const auto& channel = log.channels[row.channel];
    add(fmt::format(R"({{"ph":"C","name":{},"pid":{},"ts":{},"args":{}}})",
                    quoted_json(channel.name), processes.at(owner_of(channel.name)), time,
                    arguments));
  }
  return text + "\n]}\n";
}

}  // namespace eagerx::gen

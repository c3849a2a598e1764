#include "generator/tools/trace/compare_logs.hpp"

#include <fmt/format.h>

#include <runtime/host/trace/replay.hpp>
#include <vector>

namespace eagerx::gen {
namespace {

using trace_log::Log;

std::vector<eagerx::Channel> facts_of(const Log& log) {
  std::vector<eagerx::Channel> facts;
  facts.reserve(log.channels.size());
  for (const auto& channel : log.channels) {
    facts.push_back({channel.name.c_str(), trace_log::name_of(channel.dtype).data(), channel.size,
                     channel.rate_num, channel.rate_den, Publisher::node});
  }
  return facts;
}

std::string ends_early(const Log& log) {
  return log.complete ? "" : fmt::format("`{}` ends early, in line {}\n", log.path, log.lines);
}

/// Channels that only one of them has.
std::string alone(const Log& log, const Log& other) {
  std::string names;
  for (const auto& channel : log.channels) {
    if (!other.channel(channel.name)) names += " " + channel.name;
  }
  return names.empty() ? "" : fmt::format("only in `{}`:{}\n", log.path, names);
}

/// Stops at the first difference.
void go_through(const Log& log, bool other_is_complete, trace_log::Replay& replay) {
  std::uint32_t episode = 0;
  for (const auto& row : log.rows) {
    for (; episode < row.episode; ++episode) replay.end_episode(episode);
    replay.compare(row.channel, row.episode, row.seq, log.values_of(row));
    if (!replay.go_on()) return;
  }
  if (log.complete && other_is_complete) replay.end_all();
}

}  // namespace

Comparison compare_logs(const std::string& first, const std::string& second) {
  std::string problem;
  const auto recorded = trace_log::read_log_file(first, problem);
  if (!recorded) return {problem + "\n"};
  const auto here = trace_log::read_log_file(second, problem);
  if (!here) return {problem + "\n"};
  const std::vector<eagerx::Channel> facts = facts_of(*here);
  trace_log::Replay replay(*recorded, facts);
  if (!replay.fits(problem)) return {problem + "\n"};
  go_through(*here, recorded->complete, replay);
  std::string text = alone(*recorded, *here) + alone(*here, *recorded);
  if (const auto& divergence = replay.divergence()) {
    text += trace_log::divergence_text(*divergence, facts[divergence->channel], "`" + first + "`",
                                       "in `" + second + "`");
    text +=
        fmt::format("\n{} before, all equal\n", trace_log::count_text(replay.equal(), "message"));
    return {text, true, false};
  }
  text += ends_early(*recorded) + ends_early(*here) +
          fmt::format("equal: {}\n", trace_log::count_text(replay.equal(), "message"));
  return {text, true, true};
}

}  // namespace eagerx::gen

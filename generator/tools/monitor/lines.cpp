#include "generator/tools/monitor/lines.hpp"

#include <fmt/format.h>

#include "generator/tools/monitor/numbers.hpp"

namespace eagerx::gen {
namespace {

std::string known(const std::optional<double>& value) {
  return value ? fmt::format("{:.6g}", *value) : "-";
}
std::string seconds(std::int64_t ns) {
  return fmt::format("{:.6g}", static_cast<double>(ns) / kNsInSecond);
}

std::string limit_text(const NearestLimit& limit, std::size_t elements) {
  const std::string element = elements > 1 ? fmt::format("[{}]", limit.element) : "";
  return fmt::format("{}{}={}", limit.is_high ? "high" : "low", element, exact_text(limit.bound));
}

std::string stream_line(const Model& model) {
  const StreamFacts& facts = model.facts();
  std::string graph = facts.graph;
  if (graph.empty() && model.expected() != nullptr) graph = model.expected()->graph;
  std::string text = fmt::format("# graph {}", graph.empty() ? "-" : graph);
  if (facts.hash) text += fmt::format(" 0x{:016x}", *facts.hash);
  const StreamStep& step = model.last_step();
  text += fmt::format(", episode {}", step.episode);
  if (step.step) text += fmt::format(", step {}", *step.step);
  text += fmt::format(", time {} s", seconds(step.time_ns));
  for (std::size_t i = 0; i < kStreamFaults; ++i) {
    const auto fault = static_cast<StreamFault>(i);
    if (model.faults(fault) > 0)
      text += fmt::format(", {} {}", text_of(fault), model.faults(fault));
  }
  return text + "\n";
}

std::string channel_line(const Model& model, const WatchedChannel& channel) {
  const ChannelState state = model.state(channel);
  std::string values;
  for (const double value : channel.values)
    values += (values.empty() ? "" : ",") + exact_text(value);
  if (channel.elements > channel.values.size()) values += ",...";
  return fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\n", channel.name,
                     values.empty() ? "-" : values, channel.messages, known(state.measured_hz),
                     known(channel.planned_hz), known(state.age_s),
                     state.has_come ? seconds(channel.late_ns) : "-",
                     state.limit ? limit_text(*state.limit, channel.values.size()) : "-",
                     state.limit ? fmt::format("{:.4g}", state.limit->left) : "-", state.words());
}

}  // namespace

std::string lines_head() {
  return "# channel\tvalue\tmessages\trate_hz\tplanned_hz\tage_s\tlate_s\tlimit\tleft\tstate\n";
}

std::string lines_text(const Model& model) {
  std::string text = stream_line(model);
  for (const WatchedChannel& channel : model.channels()) text += channel_line(model, channel);
  return text;
}

}  // namespace eagerx::gen

#include <fmt/format.h>

#include "generator/analysis/info/info.hpp"
#include "generator/graph/plan/vectorized.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

std::string milliseconds(const Rational& seconds) {
  return (seconds * Rational(1000)).is_integer()
             ? fmt::format("{} ms", (seconds * Rational(1000)).to_string())
             : fmt::format("{:.3f} ms", seconds.to_double() * 1e3);
}

std::string delays_text(const Graph& graph) {
  std::string text;
  for (const auto& node : graph.nodes) {
    for (const auto& input : node.inputs) {
      if (input.delay_s == Rational() && !input.max_delay_s) continue;
      text += fmt::format("  {} <- {}: {}{}\n", input.written, name_of_source(graph, input),
                          milliseconds(input.delay_s),
                          input.max_delay_s ? ", up to " + milliseconds(*input.max_delay_s) : "");
    }
  }
  return text.empty() ? text : "\ndelays\n" + text;
}

std::string load_text(const char* what, const LinkLoad& load) {
  return fmt::format(
      "  {:<10} {:>10.1f} frames/s, {} bytes at most in one, {:.1f} bytes/s, {:.0f} baud\n", what,
      load.frames_per_s.to_double(), load.largest_frame, load.bytes_per_s.to_double(),
      load.baud.to_double());
}

std::string compared_text(const PlanInfo& report) {
  if (report.compared.empty()) return {};
  std::string text = "\nbudget of ages\n";
  for (const AgeComparison& compared : report.compared) {
    const AgeLimit& limit = compared.limit;
    const std::string at_most =
        milliseconds(limit.at_most_s) +
        (limit.ends.through_agent || limit.ends.from_actions ? "" : " without the agent");
    if (compared.ages.empty() && compared.unknown.empty())
      text += fmt::format("  at most {} (line {}) limits nothing\n", at_most, limit.span.line);
    for (const Input* input : compared.unknown)
      text +=
          fmt::format("  unknown over the connection to {}, at most {}\n", input->written, at_most);
    for (const DataAge& age : compared.ages) {
      const std::string nodes = nodes_on_path(age);
      text += fmt::format("  {} -> {}: {}, at most {}{}{}\n", age.from, age.to,
                          milliseconds(age.newest_s), at_most,
                          age.newest_s <= limit.at_most_s ? "" : ", too old",
                          nodes.empty() ? "" : ", through " + nodes);
    }
  }
  return text;
}

}  // namespace

std::string plan_text(const PlanInfo& report) {
  const Plan& plan = *report.plan;
  std::string text = fmt::format(
      "{}: {} {}\n\nrates\n", plan.graph->name, counted(plan.graph->nodes.size(), "node"),
      plan.graph->has_engine() ? "on " + plan.graph->engine_id() : "without an engine");
  for (std::size_t rate = 0; rate < plan.rates.size(); ++rate) {
    text += fmt::format("  {} Hz:", plan.rates[rate].rate_hz.to_string());
    for (std::size_t n = 0; n < plan.nodes.size(); ++n) {
      if (plan.nodes[n].rate == rate) text += " " + plan.graph->nodes[n].name;
    }
    text += "\n";
  }
  text += plan.schedule.slots
              ? fmt::format("\n{} in a hyperperiod, {}\n", counted(*plan.schedule.slots, "slot"),
                            text_of(plan.schedule.form))
              : fmt::format("\ntoo many slots in a hyperperiod to count, {}\n",
                            text_of(plan.schedule.form));
  std::uint64_t messages = 0, bytes = 0;
  for (const auto& ring : plan.rings) {
    messages += ring.capacity;
    bytes += ring.capacity * bytes_of(ring.space);
  }
  return text +
         fmt::format("{} with room for {}, {}\n", counted(plan.rings.size(), "buffer"),
                     counted(messages, "message"), counted(bytes, "byte")) +
         delays_text(*plan.graph);
}

std::string vectorized_text(const Plan& plan) {
  const std::string reason = why_not_vectorized(plan);
  if (!reason.empty())
    return fmt::format("\nmany environments at once run one by one, not vectorized: {}\n", reason);
  std::vector<std::string> by_lane;
  for (const auto& node : plan.graph->nodes) {
    if (!node.drawn && runs_lane_by_lane(node))
      by_lane.push_back(fmt::format("`{}` ({})", node.name, node.entity->id.value));
  }
  return fmt::format("\nmany environments at once run vectorized, in SIMD lanes{}{}\n",
                     by_lane.empty() ? "" : ", one lane after the other: ", join(by_lane, ", "));
}

std::string timing_text(const PlanInfo& report) {
  const bool engine = report.plan->graph->has_engine();
  std::string text = engine ? "\nage of a sensor's data at an actuator's ticks, at most\n"
                            : "\nage of an action's data in the observation of a step, at most\n";
  if (report.ages.empty() && report.ages_unknown.empty())
    text += engine ? "  no sensor's data reach an actuator\n"
                   : "  no action's data reach an observation\n";
  for (const Input* input : report.ages_unknown)
    text += fmt::format("  unknown over the connection to {}\n", input->written);
  for (const auto& age : report.ages) {
    text += fmt::format("  {} -> {}: newest {}, oldest {}{}\n", age.from, age.to,
                        milliseconds(age.newest_s),
                        age.oldest_s ? milliseconds(*age.oldest_s) : "unknown",
                        age.exact ? "" : " (sums over connections)");
    for (const auto& edge : age.path)
      text += fmt::format("    -> {:<24} {}\n", edge.input, milliseconds(edge.newest_s));
  }
  text += compared_text(report);
  if (report.link.messages.empty()) return text;
  text += fmt::format("\na serial link to the engine would carry ({} bytes of framing a frame)\n",
                      kFrameBytes);
  text += load_text("sensors", report.link.sensors);
  return text + load_text("actuators", report.link.actuators);
}

}  // namespace eagerx::gen

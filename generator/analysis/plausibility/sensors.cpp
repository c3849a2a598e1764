// Sensors: how often they measure, and whether a policy knows their range.
#include <fmt/format.h>

#include "generator/analysis/plausibility/plausibility.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/frontend/spec/port_name.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// Where the rate of the sensor is written in the graph, else where the engine's is.
Span place_of_rate(const GraphSpec& spec, const std::string& sensor) {
  const PortName name = parse_port(sensor);
  const EntitySpec* object = find_named(spec.objects, name.owner);
  const ComponentSpec* said =
      object != nullptr && object->sensors ? find_named(*object->sensors, name.name) : nullptr;
  if (said != nullptr && said->rate) return said->rate->span;
  return spec.engine.rate ? spec.engine.rate->span : spec.engine.name.span;
}

/// One warning for all sensors whose rates are written at one place.
struct Fast {
  Span place;
  Rational rate_hz;
  std::vector<std::string> sensors;
};

void add_fast(const CheckedGraph& checked, const GraphNode& node, const std::string& sensor,
              std::vector<Fast>& result) {
  const Span place = place_of_rate(checked.spec, sensor);
  const auto same = ranges::find_if(result, [&](const Fast& fast) {
    return fast.place.line == place.line && fast.place.column == place.column &&
           fast.rate_hz == node.rate_hz;
  });
  if (same == result.end()) {
    result.push_back({place, node.rate_hz, {sensor}});
  } else {
    same->sensors.push_back(sensor);
  }
}

std::vector<Fast> fast_sensors(const CheckedGraph& checked) {
  std::vector<Fast> result;
  for (const auto& node : checked.graph.nodes) {
    if (node.rate_hz <= checked.graph.engine().rate_hz) continue;
    for (const auto& output : node.outputs) {
      for (const std::string& sensor : output.sensors) add_fast(checked, node, sensor, result);
    }
  }
  return result;
}

void check_rates(const CheckedGraph& checked, Diagnostics& diagnostics) {
  const std::string engine_hz = checked.graph.engine().rate_hz.to_string();
  for (const Fast& fast : fast_sensors(checked)) {
    auto& problem = diagnostics.warning(
        "W0106", fast.place,
        fmt::format("`{}` {} read at {} Hz, but the engine steps at {} Hz",
                    join(fast.sensors, "`, `"), fast.sensors.size() == 1 ? "is" : "are",
                    fast.rate_hz.to_string(), engine_hz));
    problem.label = "between two steps nothing new can be read";
    const auto& rate = checked.spec.engine.rate;
    problem.help =
        fmt::format("{} {}`, or a lower rate for the sensor: `sensors: {{{}: {{rate: {}}}}}`",
                    rate && rate->is_option ? "give `--engine-rate" : "write `engine: {rate:",
                    fast.rate_hz.to_string() + (rate && rate->is_option ? "" : "}"),
                    parse_port(fast.sensors.front()).name, engine_hz);
  }
}

/// A policy was trained on numbers of some size; without bounds, no check shows that these differ.
void check_policy(const CheckedGraph& checked, Diagnostics& diagnostics) {
  const AgentSpec& agent = checked.spec.agent;
  if (agent.kind != AgentSpec::Kind::policy || agent.normalize) return;
  for (const std::size_t i : checked.graph.agent.observations) {
    const Input& input = checked.graph.environment().inputs[i];
    if (!is_floating(input.space.dtype)) continue;
    if (!input.space.low.empty() && !input.space.high.empty()) continue;
    auto& problem = diagnostics.warning(
        "W0107", input.span,
        fmt::format("the policy takes `{}`, but its bounds are unknown", input.written));
    problem.notes.push_back({"the policy", checked.graph.agent.span, ""});
    problem.help = fmt::format(
        "write the bounds that it was trained with: `observations: {{{}: {{space: {{low: …, high: "
        "…}}}}}}`",
        input.name);
  }
}

}  // namespace

void check_sensors(const CheckedGraph& checked, Diagnostics& diagnostics) {
  check_rates(checked, diagnostics);
  check_policy(checked, diagnostics);
}

}  // namespace eagerx::gen

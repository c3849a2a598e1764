#include "generator/tools/monitor/expected.hpp"

#include <fmt/format.h>

#include <utility>

namespace eagerx::gen {
namespace {

/// Bounds of all elements; those of a space are one for all, one for each, or none.
std::vector<double> of_each(const std::vector<double>& bounds, std::uint64_t size) {
  if (bounds.size() != 1) return bounds;
  return std::vector<double>(size, bounds.front());
}

const Space& space_of(const Graph& graph, const Channel& channel) {
  // The actuators of an action limit it, too.
  if (channel.node == Graph::kEnvironment && channel.output < graph.applied.size())
    return graph.applied[channel.output].space;
  return graph.nodes[channel.node].outputs[channel.output].space;
}

std::string text_of(const trace_log::RecordedChannel& channel) {
  return fmt::format("{} [{}] at {} Hz", trace_log::name_of(channel.dtype), channel.size,
                     Rational(static_cast<std::int64_t>(channel.rate_num),
                              static_cast<std::int64_t>(channel.rate_den))
                         .to_string());
}

}  // namespace

Expected expected_of(const Plan& plan, std::string file, std::uint64_t hash) {
  const Graph& graph = *plan.graph;
  Expected expected;
  expected.file = std::move(file);
  expected.graph = graph.name;
  expected.engine = graph.engine_id();
  expected.hash = hash;
  expected.step_hz = graph.environment().rate_hz.to_double();
  expected.has_scenes =
      graph.render && graph.nodes[graph.render->node].inputs.front().space.dtype == Dtype::float32;
  for (const Channel& channel : plan.channels) {
    const GraphNode& node = graph.nodes[channel.node];
    const Space& sent = node.outputs[channel.output].space;
    ExpectedChannel each;
    each.channel.name = channel.name;
    each.channel.dtype =
        trace_log::dtype_of(to_string(sent.dtype)).value_or(trace_log::Dtype::float32);
    each.channel.size = sent.size();
    each.channel.rate_num = static_cast<std::uint64_t>(node.rate_hz.num());
    each.channel.rate_den = static_cast<std::uint64_t>(node.rate_hz.den());
    each.port = channel.port;
    for (const auto size : sent.shape) each.shape.push_back(static_cast<std::uint32_t>(size));
    each.is_sensor = node.role == NodeRole::engine_node;
    const Space& space = space_of(graph, channel);
    each.low = of_each(space.low, sent.size());
    each.high = of_each(space.high, sent.size());
    const bool is_action = channel.node == Graph::kEnvironment;
    if (is_action && graph.safety.declared && channel.output < graph.safety.actions.size())
      each.safe = of_each(graph.safety.actions[channel.output], sent.size());
    expected.places.emplace(channel.name, expected.channels.size());
    expected.channels.push_back(std::move(each));
  }
  return expected;
}

std::string problem_with_channels(const Expected& expected,
                                  const std::vector<trace_log::RecordedChannel>& channels) {
  for (const auto& channel : channels) {
    const ExpectedChannel* const known = expected.find(channel.name);
    if (known == nullptr)
      return fmt::format("`{}` has no channel `{}`", expected.file, channel.name);
    const std::string here = text_of(channel), there = text_of(known->channel);
    if (here != there)
      return fmt::format("`{}` is {}, in `{}` {}", channel.name, here, expected.file, there);
  }
  return {};
}

}  // namespace eagerx::gen

#include "generator/policy/agent/use.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace eagerx::gen {

ActionKind PolicyUse::kind(const Network& network) const {
  if (!output) return network.action_kind();
  if (*output == "argmax") return ActionKind::argmax;
  if (*output == "binary") return ActionKind::binary;
  return *output == "squashed" ? ActionKind::squashed : ActionKind::raw;
}

PolicyUse agent_use(const Graph& graph) {
  const GraphNode& environment = graph.environment();
  PolicyUse use;
  use.file = graph.agent.file;
  use.span = graph.agent.span;
  use.place = graph.span;
  for (const std::size_t i : graph.agent.observations) use.inputs.push_back(&environment.inputs[i]);
  if (!use.inputs.empty()) use.place = use.inputs.front()->span;
  for (const auto& action : environment.outputs) use.outputs.push_back(&action);
  std::ranges::sort(use.outputs, {}, &Output::name);
  use.output = graph.agent.output;
  use.trained_at = graph.agent.trained_at;
  use.rate_hz = environment.rate_hz;
  use.takes = "observations of this graph";
  use.gives = "actions of this graph";
  use.in = "observations.";
  use.out = "actions.";
  return use;
}

PolicyUse node_use(const Graph& graph, std::size_t node, const AgentSpec& policy) {
  const GraphNode& where = graph.nodes[node];
  PolicyUse use;
  use.file = policy.file.value;
  use.span = policy.file.span;
  use.place = where.span;
  for (const auto& input : where.inputs) use.inputs.push_back(&input);
  for (const auto& output : where.outputs) use.outputs.push_back(&output);
  if (policy.output) use.output = policy.output->value;
  use.trained_at = policy.trained_at;
  use.rate_hz = where.rate_hz;
  use.takes = fmt::format("inputs of `{}`", where.name);
  use.gives = fmt::format("outputs of `{}`", where.name);
  use.in = where.name + ".";
  use.out = where.name + ".";
  use.is_agent = false;
  return use;
}

std::string policy_namespace(const std::string& node) {
  return "policy_of_" + node;
}

}  // namespace eagerx::gen

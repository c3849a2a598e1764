#include "generator/policy/agent/policies.hpp"

#include <utility>

#include "generator/policy/agent/check.hpp"
#include "generator/policy/agent/node_entity.hpp"
#include "generator/policy/agent/weights.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {

Policies read_policies(const GraphSpec& spec, Library& library, Diagnostics& diagnostics) {
  Policies policies;
  if (spec.agent.kind == AgentSpec::Kind::policy) {
    policies.agent = read_weights(spec.agent, spec.path, diagnostics);
  }
  for (std::size_t i = 0; i < spec.nodes.size(); ++i) {
    const EntitySpec& node = spec.nodes[i];
    if (!node.policy) continue;
    auto network = read_weights(*node.policy, spec.path, diagnostics);
    library.entities[node.type.value] = policy_entity(spec, node, network ? &*network : nullptr);
    if (network) policies.nodes.push_back({i, std::move(*network)});
  }
  return policies;
}

std::vector<NodePolicy> node_policies(const GraphSpec& spec, const Graph& graph,
                                      const Policies& policies) {
  std::vector<NodePolicy> result;
  for (const NodeNetwork& item : policies.nodes) {
    const EntitySpec& node = spec.nodes[item.spec];
    const auto found = ranges::find(graph.nodes, node.name.value, &GraphNode::name);
    const auto index = static_cast<std::size_t>(found - graph.nodes.begin());
    result.push_back({index, node_use(graph, index, *node.policy), &item.network});
  }
  return result;
}

void check_policies(const GraphSpec& spec, const Graph& graph, const Policies& policies,
                    Diagnostics& diagnostics) {
  if (policies.agent) check_policy(agent_use(graph), *policies.agent, diagnostics);
  for (const NodePolicy& policy : node_policies(spec, graph, policies)) {
    check_policy(policy.use, *policy.network, diagnostics);
  }
}

}  // namespace eagerx::gen

// Where a policy is used: as the agent, or in a node.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/graph/resolve/graph.hpp"
#include "generator/policy/network/network.hpp"

namespace eagerx::gen {

/// The inputs and outputs of a policy, in its order. Points into the graph.
struct PolicyUse {
  std::string file;  // as written
  Span span, place;  // where it was written; what it takes
  std::vector<const Input*> inputs;
  std::vector<const Output*> outputs;
  std::optional<std::string> output;  // squashed, raw, argmax, binary, as written
  Rational rate_hz;
  std::optional<Spanned<Rational>> trained_at;  // as written
  std::string takes, gives;  // for messages: "observations of this graph", "outputs of `balance`"
  std::string in, out;       // what names are prefixed with: "observations.", "balance."
  bool is_agent = true;

  /// The conversion of the network's outputs.
  [[nodiscard]] ActionKind kind(const Network& network) const;
};

/// The agent: observations in the order that the graph says, actions by name.
PolicyUse agent_use(const Graph& graph);
/// A node: inputs and outputs in the order in which they are written.
PolicyUse node_use(const Graph& graph, std::size_t node, const AgentSpec& policy);

/// The namespace and the header of a node's policy: "policy_of_balance".
std::string policy_namespace(const std::string& node);

/// A node's policy, and where it is used.
struct NodePolicy {
  std::size_t node = 0;
  PolicyUse use;
  const Network* network = nullptr;
};

}  // namespace eagerx::gen

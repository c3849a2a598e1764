// The policies of a graph. Their weights are read before the graph is resolved, because they
// determine the outputs of nodes that run them, and are checked against it afterwards.
#pragma once

#include <optional>
#include <vector>

#include "generator/frontend/library/library.hpp"
#include "generator/frontend/spec/graph_spec.hpp"
#include "generator/graph/resolve/graph.hpp"
#include "generator/policy/agent/use.hpp"
#include "generator/policy/network/network.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// The weights of a node that runs a policy: `spec` is its place among the nodes of the graph file.
struct NodeNetwork {
  std::size_t spec = 0;
  Network network;
};

struct Policies {
  std::optional<Network> agent;
  std::vector<NodeNetwork> nodes;
};

/// All weights that the graph names. Each node that runs a policy becomes an entity of its own in
/// `library`. Problems: those of read_weights().
Policies read_policies(const GraphSpec& spec, Library& library, Diagnostics& diagnostics);

/// Where the nodes' policies are used, in the graph that `spec` became. Points into `policies`.
std::vector<NodePolicy> node_policies(const GraphSpec& spec, const Graph& graph,
                                      const Policies& policies);

/// Whether all policies fit the graph. Problems: those of check_policy().
void check_policies(const GraphSpec& spec, const Graph& graph, const Policies& policies,
                    Diagnostics& diagnostics);

}  // namespace eagerx::gen

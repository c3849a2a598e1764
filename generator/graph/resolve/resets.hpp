// Reset nodes, and the nodes that can run during a reset.
#pragma once

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

void resolve_reset_targets(UnresolvedGraph& draft);  // which states the reset nodes bring about
/// Checks the requirements of a reset on the finished graph (E0317, E0318), and marks nodes that
/// cannot run during a reset.
void check_resets(Graph& graph, Diagnostics& diagnostics);
/// Whether a connection requests a state from a reset node: `to: node.targets.name`.
bool is_reset_target(const ConnectionSpec& connection);

}  // namespace eagerx::gen

// Reset nodes, and the nodes that can run during a reset.
#pragma once

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

void resolve_reset_targets(UnresolvedGraph& draft);  // which states the reset nodes bring about
/// The requirements of a reset on the finished graph (E0317, E0318); marks what cannot run during
/// one.
void check_resets(Graph& graph, Diagnostics& diagnostics);
/// Whether a connection asks a reset node for a state: `to: node.targets.name`.
bool is_reset_target(const ConnectionSpec& connection);

}  // namespace eagerx::gen

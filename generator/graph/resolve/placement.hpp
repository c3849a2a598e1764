// Assigns each node to a program.
#pragma once

#include <vector>

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

/// The placement of nodes in programs (E0332 what cannot be placed, E0333 what is placed twice,
/// E0334 targets that are no partners).
void place_parts(UnresolvedGraph& draft, const std::vector<PlacementSpec>& placement);

}  // namespace eagerx::gen

// Assigns each node to a program.
#pragma once

#include <vector>

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

/// Places nodes in programs (E0332 an element that cannot be placed, E0333 one that is placed
/// twice, E0334 a target that cannot run a part).
void place_parts(UnresolvedGraph& draft, const std::vector<PlacementSpec>& placement);

}  // namespace eagerx::gen

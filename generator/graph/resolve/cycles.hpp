// Cycles of connections: one connection of each must skip.
#pragma once

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

void check_cycles(UnresolvedGraph& draft);

}  // namespace eagerx::gen

// Connections in a circle, of which one must skip.
#pragma once

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

void check_cycles(UnresolvedGraph& draft);

}  // namespace eagerx::gen

// Engines that do not wait for the graph.
#pragma once

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

/// Checks `sync: false` (E0338 conflicts with it).
void check_sync(UnresolvedGraph& draft);

}  // namespace eagerx::gen

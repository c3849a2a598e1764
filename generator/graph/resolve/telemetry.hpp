// Messages that boards send.
#pragma once

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

/// Which messages boards send (E0206, E0307), which is nothing for half of a split graph (E0342).
void resolve_telemetry(UnresolvedGraph& draft);

}  // namespace eagerx::gen

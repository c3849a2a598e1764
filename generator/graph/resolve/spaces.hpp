// Spaces of all messages, and the processors between them.
#pragma once

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

void resolve_spaces(
    UnresolvedGraph& draft);  // spaces and processors; fills the graph's inputs and outputs

}  // namespace eagerx::gen

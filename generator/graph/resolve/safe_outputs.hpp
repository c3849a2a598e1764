// The safe observations of a graph without engine.
#pragma once

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

/// The safe outputs of a graph without engine (E0307, E0327, E0348).
void resolve_safe_outputs(UnresolvedGraph& draft);

}  // namespace eagerx::gen

// The stages of a training.
#pragma once

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

/// Resolves the stages of a training (E0307 names, E0327 ranges, E0352 invalid stages).
void resolve_stages(UnresolvedGraph& draft);

}  // namespace eagerx::gen

// The node that forwards the picture of `render:`.
#pragma once

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

void add_render(UnresolvedGraph& draft);  // its node
/// Whether the source of `render:` can be shown (E0360), and which nodes only pictures need.
void resolve_render(UnresolvedGraph& draft);

}  // namespace eagerx::gen

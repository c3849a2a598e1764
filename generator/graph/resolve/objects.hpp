// Objects become the engine nodes that implement them on the chosen engine.
#pragma once

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

void add_objects(UnresolvedGraph& draft);

}  // namespace eagerx::gen

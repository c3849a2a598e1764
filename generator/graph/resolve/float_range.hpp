// Parameters that are too large for float.
#pragma once

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

/// Parameters that are too large for float, where the program computes with it (E0323).
void check_float_range(UnresolvedGraph& draft);

}  // namespace eagerx::gen

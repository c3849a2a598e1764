// Noise on observations.
#pragma once

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

/// A node that adds noise to each observation that `task.noise` names, once it is connected (E0307,
/// E0315).
void add_noise(UnresolvedGraph& draft);

}  // namespace eagerx::gen

// Delays of connections: constant, sampled at a reset, or changed by a reset up to a maximum.
#pragma once

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

/// Resolves the delay of the connection to `from` into `into`: its initial value, its maximum, and
/// its distribution (E0327).
void resolve_delay(const UnresolvedGraph& draft, const UnresolvedInput& from, Input& into);

}  // namespace eagerx::gen

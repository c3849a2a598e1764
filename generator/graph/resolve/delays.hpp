// Delays of connections: constant, sampled at a reset, or changed by a reset up to a maximum.
#pragma once

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

/// The delay of the connection to `from`, in `into`: what it is at first, the longest that a reset
/// may make it, and how it is sampled (E0327).
void resolve_delay(const UnresolvedGraph& draft, const UnresolvedInput& from, Input& into);

}  // namespace eagerx::gen

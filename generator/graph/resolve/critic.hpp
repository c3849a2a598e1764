// Inputs that only the critic of a training has.
#pragma once

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

/// The inputs of a training's critic (E0307). Its inputs of the task get an output each, of the
/// task's node, behind the terms (E0315).
void add_critic_outputs(UnresolvedGraph& draft, UnresolvedNode& task);
void resolve_critic(UnresolvedGraph& draft);

}  // namespace eagerx::gen

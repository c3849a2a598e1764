// Inputs that only the critic of a training has.
#pragma once

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

/// Adds the inputs of a training's critic (E0307). Each of its inputs that is an input of the task
/// gets an output of the task's node, after the terms (E0315).
void add_critic_outputs(UnresolvedGraph& draft, UnresolvedNode& task);
void resolve_critic(UnresolvedGraph& draft);

}  // namespace eagerx::gen

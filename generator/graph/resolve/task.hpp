// The node that computes the reward of a step.
#pragma once

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

void add_task(UnresolvedGraph& draft);       // its node
void let_task_skip(UnresolvedGraph& draft);  // its inputs that wait for the action of the same tick
/// Expressions of the task, once its inputs' spaces are known. Problems: E0323 a time of too many
/// steps, E0339 an expression.
void resolve_task(UnresolvedGraph& draft);

}  // namespace eagerx::gen

// The description that a library of environments will have, before it is built.
#pragma once

#include <string>

#include "generator/graph/resolve/graph.hpp"

namespace eagerx::gen {

/// The part of eagerx_describe()'s JSON that is known without compiling: the names, types, shapes
/// and bounds of observations, actions and states, and whether the task defines success. Empty for
/// observations with `window: 0`, whose maximum number of messages only the plan knows.
std::string description_of(const Graph& graph);

}  // namespace eagerx::gen

// `tunable: [controller.kp]`: parameters that a reset may set.
#pragma once

#include "generator/frontend/library/library.hpp"

namespace eagerx::gen {

/// Adds the parameters of `tunable:` to the states of their nodes, in a flat graph. Problems: E0396
/// not a tunable parameter of a node.
void take_tunable(YamlValue& root, const Library& library, Diagnostics& diagnostics);

}  // namespace eagerx::gen

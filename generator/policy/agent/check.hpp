// Checks that a policy fits the graph: its inputs and outputs against observations and actions.
#pragma once

#include "generator/policy/agent/use.hpp"

namespace eagerx::gen {

/// Problems: E0701 another number of inputs, E0702 another number of outputs, E0703 an observation
/// or action that a policy cannot take or give; and those of check_policy_world(). False if there
/// is any.
bool check_policy(const PolicyUse& use, const Network& network, Diagnostics& diagnostics);

}  // namespace eagerx::gen

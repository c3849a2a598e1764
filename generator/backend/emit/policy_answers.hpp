// The outputs of a network as actions, in generated code.
#pragma once

#include <string>

#include "generator/backend/emit/names.hpp"
#include "generator/policy/agent/use.hpp"

namespace eagerx::gen {

/// A list with, for each output of `use`: field, how, expression. The expressions read the array
/// `output` from position `out` on, and the spaces `<prefix><Name>`.
View policy_answers(const PolicyUse& use, const Network& network, const std::string& prefix,
                    Numbers numbers = Numbers::plain);

/// Whether those expressions read the outputs one after the other, with a position `out`.
bool reads_in_order(const PolicyUse& use, const Network& network);

/// The class of a node that runs a policy, for cpp/policy_node.mustache.
View policy_node_view(const Plan& plan, const NodePolicy& policy, Numbers numbers = Numbers::plain);

/// The class that runs the agent's policy over SIMD vectors, for
/// cpp/vectorized_policy.hpp.mustache.
View vectorized_agent_view(const Plan& plan, const Network& network);

/// Whether a policy's layers are all computed over SIMD vectors, none lane by lane.
bool needs_lane_by_lane(const Network& network);

}  // namespace eagerx::gen

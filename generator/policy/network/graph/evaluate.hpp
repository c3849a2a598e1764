// Static knowledge of an operator's results.
#pragma once

#include "generator/policy/network/graph/call.hpp"

namespace eagerx::gen {

/// Whether operator `type` multiplies with weights, and whether it remembers.
bool has_weights(std::string_view type);
bool has_memory(std::string_view type);

/// The first result. Never fails: values that cannot be represented have kind `other`. E0612,
/// E0613, E0618, E0619.
NetValue evaluate(const NetCall& call);

/// Result `i` (from 1) of an operator whose first one is `first`.
NetValue later_output(const NetCall& call, const NetValue& first, int i);

}  // namespace eagerx::gen

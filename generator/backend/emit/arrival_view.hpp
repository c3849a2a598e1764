// Inputs that are read by the clock instead of by counting.
#pragma once

#include <string>

#include "generator/backend/emit/names.hpp"

namespace eagerx::gen {

/// The messages of nodes, and when an observation is complete; false if inputs count.
View arrivals_view(const Plan& plan, const ProgramNames& names);

/// C++: whether a window of `in` has no message yet; a skipped one may be empty until the first
/// callback. Empty if every window may be.
std::string lacks_messages(const Plan& plan, const ProgramNames& names, std::size_t node);

}  // namespace eagerx::gen

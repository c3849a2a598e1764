// Inputs that go by the clock instead of counting.
#pragma once

#include <string>

#include "generator/emit/names.hpp"

namespace eagerx::gen {

/// Adds what nodes send to the view of program.hpp, and when an observation is complete.
void add_arrivals(const Plan& plan, const ProgramNames& names, View& view);

/// C++: whether a window of `in` has no message yet; a skipped one may be empty until the first
/// callback. Empty if every window may be.
std::string lacks_messages(const Plan& plan, const ProgramNames& names, std::size_t node);

}  // namespace eagerx::gen

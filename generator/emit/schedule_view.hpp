// The part of program.hpp that finds the next slot.
#pragma once

#include "generator/emit/names.hpp"

namespace eagerx::gen {

/// Adds the slots, in one of the forms of the schedule, to the view of program.hpp.
void add_schedule(const Plan& plan, const ProgramNames& names, View& view);

}  // namespace eagerx::gen

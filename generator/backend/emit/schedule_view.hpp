// The part of program.hpp that finds the next slot.
#pragma once

#include "generator/backend/emit/names.hpp"

namespace eagerx::gen {

/// The slots in the form that the plan has chosen.
View schedule_view(const Plan& plan, const ProgramNames& names);

}  // namespace eagerx::gen

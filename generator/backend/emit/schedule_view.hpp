// The part of program.hpp that finds the next slot.
#pragma once

#include <cstdint>

#include "generator/backend/emit/names.hpp"

namespace eagerx::gen {

/// Slots from one observation to the next, at most.
std::uint64_t most_slots(const Plan& plan);

/// The slots in the form that the plan has chosen.
View schedule_view(const Plan& plan, const ProgramNames& names);

}  // namespace eagerx::gen

// What goes over the link between the two programs of a split graph.
#pragma once

#include "generator/plan/plan.hpp"

namespace eagerx::gen {

/// Needs everything of the plan but the split, and the graph's placement.
Split make_split(const Plan& plan);

}  // namespace eagerx::gen

// Whether environments of a graph can be calculated in packs: one lane of a pack one environment.
#pragma once

#include <string>

#include "generator/plan/plan.hpp"

namespace eagerx::gen {

/// Why they run one by one instead, as a sentence without its end; empty if they can run in packs.
/// Steps of a pack are those of the graph, with packs for numbers; resets run alone. So all lanes
/// do the same at the same time: every rate is due whenever an episode may begin.
std::string why_no_packs(const Plan& plan);

}  // namespace eagerx::gen

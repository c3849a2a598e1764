// Whether environments of a graph can run vectorized: each in one lane of a SIMD group.
#pragma once

#include <string>
#include <vector>

#include "generator/graph/plan/plan.hpp"

namespace eagerx::gen {

/// Why they run one by one instead, as a sentence without its end; empty if they can run
/// vectorized. Steps of a SIMD group are those of the graph, with SIMD vectors for numbers; resets
/// run alone. So all lanes do the same at the same time: every rate is due whenever an episode may
/// begin.
std::string why_not_vectorized(const Plan& plan);

/// Whether SIMD groups run a node lane by lane: it is written for plain numbers, or receives a
/// different number of messages in each lane. Not possible for engines, objects and engine nodes,
/// whose simulation is vectorized.
bool runs_lane_by_lane(const GraphNode& node);

/// Steps after which every rate is due again; 1 where all rates are multiples of the environment's.
std::size_t steps_in_hyperperiod(const Plan& plan);

/// By rate of the plan, whether SIMD groups have it: not that of pictures alone, which they never
/// show.
std::vector<bool> vectorized_rates(const Plan& plan);
/// The slots of SIMD groups, with the masks of the plan: without those in which only pictures are
/// due, and without regard to reset nodes, whose routines end in any slot, but not in a group.
/// Where an environment continues in its own program, that is where its reset has left it, a step
/// like any other but for its pictures, which are never shown.
Schedule vectorized_schedule(const Plan& plan);

/// By ring of a plan with the schedule of SIMD groups, whether only the step that writes a message
/// reads it: SIMD groups need not keep it. None where that is not obvious, or where a reset
/// continues from messages of the last episode.
std::vector<bool> passing_rings(const Plan& plan);

}  // namespace eagerx::gen

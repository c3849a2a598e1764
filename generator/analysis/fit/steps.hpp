// Bounds of a graph's steps, computed from the bounds of the slots due in each.
#pragma once

#include <optional>
#include <string>

#include "generator/analysis/bound/bound.hpp"
#include "generator/graph/plan/plan.hpp"

namespace eagerx::gen {

/// Of a schedule whose steps differ; the table of an image counts its longest slot for each one of
/// a hyperperiod.
struct StepBounds {
  InstructionBound longest;      // of the steps
  InstructionBound hyperperiod;  // all steps of one
  std::size_t steps = 0;         // in a hyperperiod
};

/// nullopt: all steps have the same slots, so that the bound of a step has just these; or the image
/// does not tell kinds of slots apart, or something has no bound.
std::optional<StepBounds> step_bounds(const BoundReport& report, const Plan& plan);

std::string steps_text(const StepBounds& steps, const std::optional<TimeModel>& time);
Json steps_json(const StepBounds& steps, const std::optional<TimeModel>& time);

}  // namespace eagerx::gen

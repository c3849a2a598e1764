#include "generator/analysis/fit/steps.hpp"

#include <algorithm>
#include <vector>

namespace eagerx::gen {
namespace {

/// The slots of the hyperperiod; empty: the report does not have all of them.
std::vector<const SlotBound*> slots_of(const BoundReport& report, const Schedule& schedule) {
  std::vector<const SlotBound*> slots;
  for (const std::uint64_t mask : schedule.masks) {
    const auto found = std::ranges::find(report.slots, std::optional(mask), &SlotBound::due);
    if (found == report.slots.end() || !found->is_bound) return {};
    slots.push_back(&*found);
  }
  return slots;
}

void add(InstructionBound& to, const SlotBound::Half& half) {
  to.most += half.most;
  to.cycles += half.cycles;
}

}  // namespace

/// A step: what of the last observation's slot comes after the action, the slots between, and what
/// of the next observation's slot comes before its action.
std::optional<StepBounds> step_bounds(const BoundReport& report, const Plan& plan) {
  const InstructionBound *schedule = report.part("schedule"), *whole = report.part("step");
  if (schedule == nullptr || whole == nullptr || !schedule->is_bound) return std::nullopt;
  if (plan.schedule.form != ScheduleForm::kinds) return std::nullopt;
  const auto slots = slots_of(report, plan.schedule);
  if (slots.empty()) return std::nullopt;
  const std::uint64_t environment = std::uint64_t{1} << plan.nodes[Graph::kEnvironment].rate;
  StepBounds result{{"longest step", 0, 0, true}, {"hyperperiod", 0, 0, true}, 0};
  InstructionBound step = *schedule;
  add(step, slots.front()->after);
  for (std::size_t i = 1; i <= slots.size(); ++i) {
    const SlotBound& slot = *slots[i % slots.size()];
    add(step, slot.before);
    if ((*slot.due & environment) != 0) {
      result.longest.most = std::max(result.longest.most, step.most);
      result.longest.cycles = std::max(result.longest.cycles, step.cycles);
      add(result.hyperperiod, {step.most, step.cycles});
      ++result.steps;
      step = *schedule;
    }
    add(step, slot.after);
  }
  if (whole->is_bound) {
    result.longest.most = std::min(result.longest.most, whole->most);
    result.longest.cycles = std::min(result.longest.cycles, whole->cycles);
  }
  return result;
}

std::string steps_text(const StepBounds& steps, const std::optional<TimeModel>& time) {
  return bound_rows_text("steps, by the slots that are due in each",
                         {steps.longest, steps.hyperperiod}, time);
}

Json steps_json(const StepBounds& steps, const std::optional<TimeModel>& time) {
  return {{"longest", bound_row_json(steps.longest, time)},
          {"hyperperiod", bound_row_json(steps.hyperperiod, time)},
          {"steps", std::uint64_t{steps.steps}}};
}

}  // namespace eagerx::gen

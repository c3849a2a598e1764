// What a plan says of time, memory and traffic before anything is compiled; budgets of it.
#pragma once

#include <string>

#include "generator/json/json.hpp"
#include "generator/plan/ages.hpp"
#include "generator/plan/link.hpp"

namespace eagerx::gen {

struct PlanReport {
  const Plan* plan = nullptr;
  std::vector<DataAge> ages;
  std::vector<const Input*> ages_unknown;  // connections that `ages` leave out
  Link link;
};

PlanReport report_of(const Plan& plan);

/// Rates, slots, buffers.
std::string plan_text(const PlanReport& report);
/// Ages from sensors to actuators, and the link.
std::string timing_text(const PlanReport& report);
/// Whether target environments steps environments of the graph in packs.
std::string packs_text(const Plan& plan);
/// What the graph's task sees and gives; empty without one.
std::string task_text(const Graph& graph);
Json task_json(const Graph& graph);
/// One JSON object with all of it; fractions as texts, beside them numbers in seconds.
Json report_json(const PlanReport& report);

/// The keys `age` and `link` of a graph's `budget:`. Exceeded: E0420, with the connection that adds
/// the most.
void check_plan_budget(const PlanReport& report, const YamlValue& budget, Diagnostics& diagnostics);

}  // namespace eagerx::gen

// Time, memory and traffic of a plan before anything is compiled, and their budgets.
#pragma once

#include <string>

#include "generator/graph/plan/ages.hpp"
#include "generator/graph/plan/link.hpp"
#include "generator/support/json/json.hpp"

namespace eagerx::gen {

/// An entry of `age` in `budget:`.
struct AgeLimit {
  std::string from, to;  // empty: all of this kind
  PathEnds ends;
  Rational at_most_s;
  Span span;
};

/// The pairs that an entry covers: those without an entry with more names.
struct AgeComparison {
  AgeLimit limit;
  std::vector<DataAge> ages;
  std::vector<const Input*> unknown;  // connections that these leave out
};

struct PlanInfo {
  const Plan* plan = nullptr;
  std::vector<DataAge> ages;               // between the usual ends
  std::vector<const Input*> ages_unknown;  // connections that `ages` leave out
  std::vector<AgeComparison> compared;
  Link link;
};

/// `budget` of the graph, if it has one. Problems with its `age`: E0208 a key that does nothing,
/// E0424 an unknown name, E0425 a pair without a path, W0120 an entry without effect.
PlanInfo info_of(const Plan& plan, const std::optional<BudgetSpec>& budget,
                 Diagnostics& diagnostics);
/// The comparisons of it.
std::vector<AgeComparison> compare_ages(const Plan& plan, const std::vector<AgeBudgetSpec>& ages,
                                        Diagnostics& diagnostics);
/// The nodes on the path: "position, speed" or "agent, smooth"; empty if there are none.
std::string nodes_on_path(const DataAge& age);

/// Rates, slots, buffers.
std::string plan_text(const PlanInfo& report);
/// The telemetry of boards; empty without `telemetry:`.
std::string telemetry_text(const Plan& plan);
Json telemetry_json(const Plan& plan);
/// Ages from sensors to actuators, and the link.
std::string timing_text(const PlanInfo& report);
/// The traffic on the links of a graph with parts, next to the key `parts` of its `budget:`; empty
/// without parts.
std::string parts_text(const Plan& plan, const std::optional<BudgetSpec>& budget);
/// "1 exchange, 34 bytes with their frames", of a step.
std::string load_of_part(const Plan& plan, std::size_t part);
Json parts_json(const Plan& plan);
/// On a serial line, with frames: bytes a step both ways, and bits a second in real time.
double bytes_on_line(const PartLink& link);
double baud_of(const Plan& plan, const PartLink& link);
/// The key `parts` of `budget:`, for each link. Exceeded: E0420.
void check_parts_budget(const Plan& plan, const Spanned<Rational>& limit, Diagnostics& diagnostics);
/// Whether target environments steps environments of the graph vectorized.
std::string vectorized_text(const Plan& plan);
/// The graph's task, its inputs and results; empty without one.
std::string task_text(const Graph& graph);
Json task_json(const Graph& graph);
/// A time as its exact fraction and in seconds.
Json time_json(const Rational& seconds);
/// One JSON object with all of it: fractions as strings, and next to them numbers in seconds.
Json info_json(const PlanInfo& report);

/// The keys `age`, `link` and `telemetry` of a graph's `budget:`. Exceeded: E0420, with the
/// connection that adds the most.
void check_plan_budget(const PlanInfo& report, const BudgetSpec& budget, Diagnostics& diagnostics);

}  // namespace eagerx::gen

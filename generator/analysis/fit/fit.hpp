// Checks that the bounds of slots fit into the time that the graph's rates allow.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/analysis/bound/bound.hpp"
#include "generator/frontend/read/tree.hpp"
#include "generator/graph/plan/plan.hpp"

namespace eagerx::gen {

/// A slot in its time; what follows a step is part of the slot that ends it: policy, guard,
/// outcome.
struct SlotFit {
  std::string name;        // the rates that are due
  std::uint64_t mask = 0;  // the same as bits
  double busy_s = 0;       // at most
  double until_next_s = 0;

  [[nodiscard]] double load() const { return busy_s / until_next_s; }
};

struct Fit {
  SlotFit busiest;  // by load
  SlotFit longest;  // by time
  double hyperperiod_s = 0, busy_s = 0;
  struct Outputs {
    std::string rate;     // "30 Hz"
    double latest_s = 0;  // after the beginning of their slot
  };
  std::vector<Outputs> outputs;  // of each rate, fastest first
};

/// nullopt: the report has no times or not all bounds, or the hyperperiod has too many slots.
std::optional<Fit> fit_of(const BoundReport& report, const Plan& plan);

std::string fit_text(const Fit& fit);
/// "the slot of 30 Hz takes up to 6.8 % of its time, 2275.6 us of 33333.3 us"
std::string busiest_text(const Fit& fit);
Json fit_json(const Fit& fit);

/// Whether `budget:` limits the time of slots.
bool limits_time(const BudgetSpec& budget);
/// The keys `time` and `slot` of `budget:`. Exceeded: E0420, with the nodes that take most; E0422:
/// the time has no bound.
void check_time_budget(const BoundReport& report, const std::optional<Fit>& fit, const Plan& plan,
                       const BudgetSpec& budget, Diagnostics& diagnostics);

}  // namespace eagerx::gen

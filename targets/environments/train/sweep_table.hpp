// The table of a sweep: one line for each combination of settings.
#pragma once

#include <string>
#include <vector>

#include "targets/environments/train/sweep_results.hpp"

namespace eagerx::train {

/// One combination of a sweep's settings, and the results of its seeds.
struct SweepCase {
  std::string settings;  // "learning_rate=0.001 layers=64,64"
  std::vector<const SweepRow*> rows;
};

/// For people, the best first. `has_success`: the task says it.
std::string sweep_text(const std::vector<SweepCase>& cases, bool has_success);
/// A row for each, the best first; each setting has a column.
std::string sweep_csv(const std::vector<SweepCase>& cases);

}  // namespace eagerx::train

// The table of a campaign (`eagerx-gen campaign --csv`): a row for each run.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace eagerx::gen::campaign {

/// A column of a quantity that differs between runs: a state, a delay or the step of a fault.
struct CampaignColumn {
  std::string name;            // "robot/body.mass", "angle=silent"
  std::vector<double> values;  // [runs]; NaN where nothing has set it
};

struct CampaignTable {
  std::string name;                     // of its file, without folder and end
  std::vector<double> returns;          // [runs], by the number of the run; may be not finite
  std::vector<bool> successes;          // [runs]
  std::vector<CampaignColumn> sampled;  // those that differ between runs
};

/// nullopt: see `problem`, which names the line.
std::optional<CampaignTable> read_campaign(const std::string& path, std::string& problem);

}  // namespace eagerx::gen::campaign

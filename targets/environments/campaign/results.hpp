// Results of the runs.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace eagerx::campaign {

enum Flags : std::uint8_t { kSuccess = 1, kTerminated = 2, kTruncated = 4 };

/// Counts of guards and nodes that are not 0, by their names.
using Counts = std::map<std::string, std::uint64_t>;

/// Some runs in order, one place each.
struct Results {
  Results(std::size_t runs, std::size_t numbers)
      : returns(runs), steps(runs), flags(runs), states(runs * numbers), width(numbers) {}

  std::size_t size() const { return returns.size(); }
  bool succeeded(std::size_t run) const { return (flags[run] & kSuccess) != 0; }

  std::vector<double> returns;       // sum of the rewards, NaN if one was
  std::vector<std::uint32_t> steps;  // of the episode
  std::vector<std::uint8_t> flags;
  // [runs][width] initial states of the episodes, then the steps at which their faults begin
  std::vector<double> states;
  std::size_t width;
  Counts counts;  // of all runs
};

}  // namespace eagerx::campaign

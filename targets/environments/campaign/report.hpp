// The report of a campaign: the same bytes for the same results.
#pragma once

#include <cstddef>
#include <string>

#include "targets/environments/campaign/plan.hpp"
#include "targets/environments/campaign/results.hpp"
#include "targets/environments/client/description.hpp"

namespace eagerx::campaign {

struct Report {
  const client::Description& description;
  const Plan& plan;
  const Results& results;
  std::string replay;  // what a command that repeats a run begins with
  std::size_t worst;   // how many of the worst runs are named
  bool says_steps;     // whether the command says `--steps`

  std::string text() const;
  std::string json() const;
  /// A row for each run.
  std::string csv() const;
  /// The command that repeats a run.
  std::string command(std::uint32_t run) const;
};

}  // namespace eagerx::campaign

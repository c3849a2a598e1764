// The command line of eagerx-campaign.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "targets/environments/campaign/plan.hpp"

namespace eagerx::campaign {

struct Options {
  std::string library;
  std::uint32_t runs = 1000;
  std::uint32_t steps = 0;  // of an episode; 0: what the task says
  std::uint64_t seed = 1;
  std::vector<Variation> variations;
  std::vector<target::Fault> faults;
  unsigned threads = 0;  // 0: one for each core
  std::size_t worst = 5;
  std::string csv, checkpoint, resume;  // empty: none
  std::string replay =
      "eagerx-gen run GRAPH.yaml";  // what a command that repeats a run begins with
  bool json = false;
  bool is_quiet = false;
  bool wants_help = false;
  bool only_checks = false;  // options and the places of files; there is no library yet
  std::string describes;     // what it will say of its graph; empty: that is ignored
};

/// Throws Problem with kUsage.
Options parse_options(int argc, const char* const* argv);

/// The text of --help.
std::string help_text();

}  // namespace eagerx::campaign

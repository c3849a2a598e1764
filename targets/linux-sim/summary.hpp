// The summary of a run, in lines of `name value` that people and scripts read.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace eagerx::linux_sim {

struct Summary {
  std::string graph;
  std::string engine;
  std::string agent;
  std::uint64_t seed = 0;
  std::uint64_t episodes = 0;  // begun
  std::uint64_t steps = 0;
  double simulated_s = 0.0;
  double elapsed_s = 0.0;  // wall-clock
  bool paced = false;
  std::uint64_t overruns = 0;
  double worst_overrun_s = 0.0;
  std::vector<std::pair<std::string, std::uint64_t>> faults;  // that the program has counted
  std::vector<std::pair<std::string, std::string>> states;    // that the episodes began with
  std::vector<std::pair<std::string, std::string>> more;      // lines at the end
  bool interrupted = false;
};

/// With `digits` digits after the point, in any locale.
std::string fixed(double value, int digits);

std::string summary_text(const Summary& summary);

/// The message for a run with rewards that were not finite; `first` describes the first one.
std::string not_finite_problem(const std::string& first, std::uint64_t seed,
                               std::uint32_t environment);

/// "trace hash 0x0123456789abcdef\n", the line of `--hash` on every target.
std::string hash_line(std::uint64_t hash);

}  // namespace eagerx::linux_sim

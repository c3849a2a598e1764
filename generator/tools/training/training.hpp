// The record of a training, for the page of `eagerx-gen report --training`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/support/diagnostics/diagnostics.hpp"
#include "generator/support/json/json.hpp"

namespace eagerx::gen {

/// Of the last evaluation. It is the first episode of the environment of that number and seed.
struct TrainingEpisode {
  std::uint64_t seed = 0;
  std::uint32_t environment = 0;
  double sum = 0.0;  // of its rewards
  std::uint64_t steps = 0;
  bool success = false;
};

struct TrainingRecord {
  Json page;          // what the page shows, but for episodes that are run again
  std::string graph;  // its name; empty: a table does not say
  /// The file of the best policy, as passed to the training, and the hash of the written file;
  /// empty: none was written.
  std::string policy, policy_hash;
  std::vector<TrainingEpisode> episodes;  // of that policy; empty: they are not known
};

/// Reads a file of `train --record`, `train --csv` or, for a sweep, `train --results`. nullopt and
/// E0363, with the line, if it cannot be read.
std::optional<TrainingRecord> read_training(const std::string& path, SourceMap& sources,
                                            Diagnostics& diagnostics);

/// The same of `bytes` instead of the file's bytes.
std::optional<TrainingRecord> read_training_text(const std::string& path, std::string bytes,
                                                 SourceMap& sources, Diagnostics& diagnostics);

/// The best and the worst of these, which are not none: by success, then return, then the order.
struct BestAndWorst {
  TrainingEpisode best, worst;
};
BestAndWorst best_and_worst(const std::vector<TrainingEpisode>& episodes);

}  // namespace eagerx::gen

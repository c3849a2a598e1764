// The part of a page that `report --training` adds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/driver/pipeline/pipeline.hpp"
#include "generator/tools/training/training.hpp"

namespace eagerx::gen {

class ReportedTraining {
 public:
  /// Of the file `path`. Problems: those of read_training().
  static std::optional<ReportedTraining> read(const std::string& path, SourceMap& sources,
                                              Diagnostics& diagnostics);

  /// Shows the graph with the trained policy, if it exists and no other one is named; without a
  /// policy if it cannot be read: the page shows what is available.
  void choose_policy(GraphOptions& options);
  /// Whether it is of this graph. Problems: E0361.
  bool check(const Graph& graph, Diagnostics& diagnostics) const;
  /// The traces of the best and the worst episode, as read_logs() gives them: run again by the
  /// graph's program, which is built. None if that cannot be, which the page says. Nothing if there
  /// is a problem, which has been reported; `code` is the exit code.
  std::optional<Json> run_episodes(const Run& run, const GenerateOptions& options,
                                   std::size_t points, int& code);
  /// Says on the page why no episodes are run.
  void leave_episodes_out(const std::string& why);
  /// The contents of the page, with the next commands.
  Json page(const Graph& graph, const GraphOptions& options) const;
  /// Why there are no episodes; empty: there are, or none are known.
  [[nodiscard]] const std::string& why_not() const { return why_not_; }

 private:
  explicit ReportedTraining(TrainingRecord record) : record_(std::move(record)) {}

  TrainingRecord record_;
  bool has_policy_ = false;  // that of the training
  std::string why_not_;
};

}  // namespace eagerx::gen

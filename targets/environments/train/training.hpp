// A training from its first step to the file of the policy.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "targets/environments/train/algorithm.hpp"
#include "targets/environments/train/checkpoint.hpp"
#include "targets/environments/train/model_selection.hpp"
#include "targets/environments/train/options.hpp"
#include "targets/environments/train/progress_report.hpp"
#include "targets/environments/train/saving.hpp"
#include "targets/environments/train/start.hpp"
#include "targets/environments/train/summary.hpp"

namespace eagerx::train {

class Training {
 public:
  /// Throws Problem for a library that cannot be trained on, and a checkpoint of another training.
  Training(const Options& options, const Library& library, ProgressReport::SharedTable table = {},
           Ranks& ranks = environments::alone());

  /// Trains until the policy succeeds, the steps are used up, or it is to `stop`. Writes the
  /// files. Returns an exit code. Throws Problem, after the checkpoint is written. Called by all
  /// ranks, which all come to the same; rank 0 alone writes and prints.
  int run(const Stop& stop);

  /// The curve that run() has written.
  const std::vector<CurvePoint>& curve() const { return progressed_.curve; }
  const Evaluation& evaluation() const { return last_; }
  /// The best policy and its known answers. Throws Problem.
  void write_policy(const std::string& path) const;

 private:
  std::uint64_t begin();
  Ending learn(const Stop& stop);
  Ending iterate(const Stop& stop);
  void start_iteration();
  bool evaluate(CurvePoint& point);
  void evaluate_at_last();
  void evaluate_all(CurvePoint& point);
  void set_stage();
  [[noreturn]] void tell_where(const Problem& problem);
  CurvePoint note(const Algorithm::Result& result);
  std::string checkpoint();
  Ended ended(Ending ending) const;
  void write_curves();
  std::uint64_t steps() const;

  const Options& options_;
  const Library& library_;
  const Kernels& kernels_;
  Ranks& ranks_;
  const Settings settings_;  // with what its files say
  const std::string conditions_, interface_;
  ThreadPool pool_;
  const std::unique_ptr<Algorithm> algorithm_;
  ModelSelection selection_;
  Progressed progressed_;
  Evaluation last_;            // of the best policy, when all is over
  double evaluating_s_ = 0.0;  // of report_.seconds()
  Saving saving_;
  std::uint32_t first_iteration_ = 0;  // of this run
  bool continues_ = false;             // in the middle of an era
  ProgressReport report_;
};

}  // namespace eagerx::train

// A training from its first step to the file of the policy.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include "targets/environments/train/algorithm.hpp"
#include "targets/environments/train/checkpoint.hpp"
#include "targets/environments/train/curve_file.hpp"
#include "targets/environments/train/evaluation.hpp"
#include "targets/environments/train/options.hpp"
#include "targets/environments/train/progress.hpp"
#include "targets/environments/train/summary.hpp"
#include "targets/environments/train/tensorboard.hpp"

namespace eagerx::train {

/// Throws Problem if a file of the options could not be written or read.
void check_files(const Options& options);

class Training {
 public:
  /// What the table of the curve has so far, for who makes another one than curve_csv().
  using Table = std::function<std::string(const std::vector<CurvePoint>&)>;

  /// Throws Problem for a library that cannot be trained on, and a checkpoint of another training.
  Training(const Options& options, const Library& library, Table table = curve_csv);

  /// Trains until the policy succeeds, the steps are used up, or `is_interrupted`. Writes the
  /// files. Returns an exit code. Throws Problem, after the checkpoint is written.
  int run(const Interrupt& is_interrupted);

  /// Of what run() has written.
  const std::vector<CurvePoint>& curve() const { return progressed_.curve; }
  const Evaluation& evaluation() const { return last_; }

 private:
  using Clock = std::chrono::steady_clock;

  Ending learn(const Interrupt& is_interrupted);
  Ending iterate(const Interrupt& is_interrupted);
  void start_iteration();
  bool is_evaluation_due() const;
  void write_checkpoint();
  std::optional<Problem> save();
  void save_if_due(bool begins_era);
  [[noreturn]] void tell_where(const Problem& problem);
  CurvePoint note(const Algorithm::Result& result);
  Evaluation evaluate_at_last();
  Evaluation run(const Policy& policy, std::uint64_t seed);
  void show();
  void grow_curve();
  void open_events();
  bool is_good(const Evaluation& evaluation) const;
  Evaluation judge(const Policy& now, Evaluation seen);
  bool is_confirmed(const Policy& now);
  bool evaluate(CurvePoint& point);
  Policy policy(std::vector<float> parameters) const;
  std::string report(const Evaluation& evaluation, Ending ending) const;
  void write_policy() const;
  void write_curve() const;
  std::uint64_t steps() const;

  const Options& options_;
  const Library& library_;
  const Kernels& kernels_;
  const std::uint32_t longest_;  // steps of an episode, besides the task's limit
  const std::uint32_t era_;      // iterations between two starts of all environments
  const bool has_aim_;           // something says when a policy is good
  const std::string conditions_, interface_;
  const Head head_;
  Team team_;
  const std::unique_ptr<Algorithm> algorithm_;
  Evaluator evaluator_;
  Progressed progressed_;
  Evaluation seen_;  // the last evaluation of this run
  Evaluation last_;  // of the best policy, when all is over
  std::optional<EventFile> events_;
  const Table table_;
  CurveFile curve_file_;
  std::uint32_t first_iteration_ = 0;  // of this run
  bool goes_on_ = false;               // in the middle of an era
  bool is_saved_ = true;               // as far as it was tried
  Clock::time_point tried_ = Clock::now();
  Progress progress_;
};

}  // namespace eagerx::train

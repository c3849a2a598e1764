// A training from its first step to the file of the policy.
#pragma once

#include "targets/environments/train/checkpoint.hpp"
#include "targets/environments/train/evaluation.hpp"
#include "targets/environments/train/options.hpp"
#include "targets/environments/train/ppo.hpp"
#include "targets/environments/train/progress.hpp"

namespace eagerx::train {

enum class Ending : std::uint8_t { success, steps, interrupted };

/// Throws Problem if a file of the options could not be written or read.
void check_files(const Options& options);

class Training {
 public:
  /// Throws Problem for a library that cannot be trained on, and a checkpoint of another training.
  Training(const Options& options, const Library& library);

  /// Trains until the policy succeeds, the steps are used up, or `is_interrupted` is not 0. Writes
  /// the files. Returns an exit code.
  int run(const volatile int& is_interrupted);

 private:
  Ending learn(const volatile int& is_interrupted);
  void start_era();
  void write_checkpoint();
  Ending iterate(const volatile int& is_interrupted);
  [[noreturn]] void tell_where(const Problem& problem);
  CurvePoint note(const Ppo::Result& result);
  bool is_good(const Evaluation& evaluation) const;
  bool evaluate(CurvePoint& point);
  Policy policy(std::vector<float> parameters) const;
  void report(const Evaluation& evaluation, Ending ending) const;
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
  Ppo ppo_;
  Evaluator evaluator_;
  Progressed progressed_;
  std::string checkpoint_;  // says what is in the file; nothing: there is none
  Progress progress_;
};

}  // namespace eagerx::train

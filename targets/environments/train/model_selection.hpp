// Selects the best policy of a training, and decides whether it is good.
#pragma once

#include <cstdint>
#include <vector>

#include "targets/environments/train/algorithm.hpp"
#include "targets/environments/train/checkpoint.hpp"
#include "targets/environments/train/client.hpp"
#include "targets/environments/train/evaluation.hpp"

namespace eagerx::train {

class ModelSelection {
 public:
  ModelSelection(const Settings& settings, const Library& library, const Kernels& kernels,
                 ThreadPool& pool, Ranks& ranks);

  /// Whether something says when a policy is good.
  bool has_aim() const { return has_aim_; }
  /// Whether evaluate() is due: every few iterations or, if episodes are long, so rarely that
  /// evaluations take no more steps than learning, but at least after each twentieth of all steps.
  /// It depends on the curve alone, so a resumed training evaluates at the same times.
  bool is_due(const std::vector<CurvePoint>& curve) const;
  /// Evaluates the current policy: fills its part of `point` and, if it is the best so far, `best`.
  /// Returns whether it is good, also in episodes that were not used to select it.
  bool evaluate(const Algorithm& algorithm, Best& best, CurvePoint& point);
  /// The learned model, in a stage of the task.
  Evaluation evaluate_in(const std::string& stage, const Algorithm& algorithm);
  /// The best policy, in as many episodes as have chosen it, which are all others.
  Evaluation evaluate_at_last(const Algorithm& algorithm, const Best& best);
  std::size_t episodes_at_last() const;
  /// Processor time of all evaluations of this process.
  double spent_s() const { return evaluator_.spent_s(); }
  /// The last one of evaluate(), in this run.
  const Evaluation& seen() const { return seen_; }
  Policy policy(const Algorithm& algorithm, std::vector<float> parameters) const;

 private:
  bool is_good(const Evaluation& evaluation) const;
  bool is_worth_choosing(const Evaluation& evaluation) const;
  Evaluation run(const Algorithm& algorithm, const Policy& policy, std::uint64_t seed,
                 const std::string& stage = {});
  Evaluation run_some(const Algorithm& algorithm, const Policy& policy, environments::Share some);
  Evaluation see(const Algorithm& algorithm, const Policy& now);
  Evaluation choose(const Algorithm& algorithm, const Policy& now, Evaluation seen);
  bool is_confirmed(const Algorithm& algorithm, const Policy& now);

  const double until_return_, success_share_;
  const std::size_t every_;     // iterations
  const std::size_t episodes_;  // of an evaluation
  const double longest_;        // steps of an evaluation, at most
  const bool has_success_;      // the task says it
  const bool has_aim_;
  const bool is_cheap_;  // an evaluation, compared with learning
  const double first_;   // steps before anything is learned
  const Head head_;
  Evaluator evaluator_;
  Evaluation seen_;
};

}  // namespace eagerx::train

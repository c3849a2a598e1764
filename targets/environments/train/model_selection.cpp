#include "targets/environments/train/model_selection.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "targets/environments/train/start.hpp"

namespace eagerx::train {
namespace {

constexpr std::uint64_t kEvaluations = 4;  // of a policy that seems to be the best
constexpr std::uint64_t kEvaluationSeed = std::uint64_t{1} << 63U;
constexpr std::uint64_t kLastSeed = kEvaluationSeed + (std::uint64_t{1} << 62U);

/// Samples that an iteration learns from, each of which takes longer than a step of an evaluation.
double samples_of(const Settings& settings) {
  if (settings.algorithm != "sac") return 0.0;
  const sac::Settings& s = settings.sac;
  return static_cast<double>(s.n_envs * s.train_freq * s.batch_size) * double{s.utd_ratio};
}

}  // namespace

ModelSelection::ModelSelection(const Settings& settings, const Library& library,
                               const Kernels& kernels, ThreadPool& pool, Ranks& ranks)
    : until_return_(settings.until_return),
      success_share_(settings.target_success_rate),
      every_(settings.eval_interval),
      episodes_(settings.n_eval_episodes),
      longest_(static_cast<double>(settings.n_eval_episodes) *
               std::max(library.description().episode_steps, longest_of(library.description()))),
      has_success_(library.description().has_success),
      has_aim_(has_success_ || std::isfinite(until_return_)),
      is_cheap_(has_aim_ && samples_of(settings) >= longest_),
      first_(static_cast<double>(settings.sac.learning_starts)),
      head_(library.description()),
      evaluator_(library, kernels, pool, longest_of(library.description()),
                 settings.n_eval_episodes, ranks) {}

Policy ModelSelection::policy(const Algorithm& algorithm, std::vector<float> parameters) const {
  return {algorithm.deployed(), std::move(parameters), head_};
}

bool ModelSelection::is_good(const Evaluation& evaluation) const {
  if (!has_aim_ || evaluation.mean_return < until_return_) return false;
  return !has_success_ || evaluation.passed(success_share_);
}

/// While many episodes fail, the next evaluations are better anyway, and most of them seem the
/// best: 300 episodes more for each would choose nothing that is kept.
bool ModelSelection::is_worth_choosing(const Evaluation& evaluation) const {
  constexpr double kNearly = 0.9;
  return !has_success_ || evaluation.passed(kNearly * success_share_);
}

bool ModelSelection::is_due(const std::vector<CurvePoint>& curve) const {
  constexpr double kLate = 0.05;  // of all steps
  const auto is_evaluated = [](const CurvePoint& x) { return !std::isnan(x.evaluation_return); };
  if (curve.empty() || is_evaluated(curve.back())) return false;
  const bool is_regular = curve.size() % every_ == 0;
  if (!is_regular && (!is_cheap_ || curve.back().steps <= first_)) return false;
  const auto last = std::find_if(curve.rbegin(), curve.rend(), is_evaluated);
  const double since = curve.back().steps - (last == curve.rend() ? 0.0 : last->steps);
  const double late = kLate * curve.back().steps;
  return since >= (is_regular ? std::min(longest_, late) : late);
}

std::size_t ModelSelection::episodes_at_last() const {
  return kEvaluations * episodes_;
}

Evaluation ModelSelection::evaluate_at_last(const Algorithm& algorithm, const Best& best) {
  const Policy last = policy(algorithm, best.parameters);
  Evaluation evaluation = run(algorithm, last, kLastSeed);
  for (std::uint64_t more = 1; more < kEvaluations; ++more)
    evaluation.add(run(algorithm, last, kLastSeed + more));
  return evaluation;
}

Evaluation ModelSelection::run(const Algorithm& algorithm, const Policy& policy, std::uint64_t seed,
                               const std::string& stage) {
  return evaluator_.run(policy, seed, algorithm.observations(), stage, evaluator_.all());
}

Evaluation ModelSelection::run_some(const Algorithm& algorithm, const Policy& policy,
                                    environments::Share some) {
  return evaluator_.run(policy, kEvaluationSeed, algorithm.observations(), {}, some);
}

/// The episodes that each policy is seen in. One that fails in most of the first 32 would not be
/// good after the others, which are as expensive as learning where a step takes long. Where few
/// have to succeed, 32 say too little: a policy that is just good enough for 0.5 fails them once in
/// 1,000 times, for 0.2 in 93.
Evaluation ModelSelection::see(const Algorithm& algorithm, const Policy& now) {
  constexpr std::size_t kFirst = 2;  // parts
  constexpr double kHalf = 0.5;
  constexpr double kTelling = 0.5;
  if (!has_success_ || success_share_ < kTelling || evaluator_.parts() <= kFirst)
    return run(algorithm, now, kEvaluationSeed);
  Evaluation seen = run_some(algorithm, now, {0, kFirst});
  if (seen.passed(kHalf * success_share_))
    seen.add(run_some(algorithm, now, {kFirst, evaluator_.parts()}));
  return seen;
}

Evaluation ModelSelection::evaluate_in(const std::string& stage, const Algorithm& algorithm) {
  return run(algorithm, policy(algorithm, algorithm.deployed_parameters()), kEvaluationSeed, stage);
}

/// All the episodes that choose the best policy: those that it was seen in and three times as many.
Evaluation ModelSelection::choose(const Algorithm& algorithm, const Policy& now, Evaluation seen) {
  for (std::uint64_t more = 1; more < kEvaluations; ++more)
    seen.add(run(algorithm, now, kEvaluationSeed + more));
  return seen;
}

/// One of many evaluations may be good by luck: as many episodes that have chosen nothing.
bool ModelSelection::is_confirmed(const Algorithm& algorithm, const Policy& now) {
  const std::uint64_t seed =
      kEvaluationSeed + kEvaluations * (std::uint64_t{algorithm.pace.iteration} + 1);
  for (std::uint64_t more = 0; more < kEvaluations; ++more) {
    if (!is_good(run(algorithm, now, seed + more))) return false;
  }
  return true;
}

bool ModelSelection::evaluate(const Algorithm& algorithm, Best& best, CurvePoint& point) {
  Policy now = policy(algorithm, algorithm.deployed_parameters());
  const Evaluation evaluation = see(algorithm, now);
  const Score seen{evaluation.success(), evaluation.mean_return};
  bool succeeds = false;
  if (best.parameters.empty() || seen.is_better_than(best.seen) || is_good(evaluation)) {
    Score confirmed = Best().confirmed;
    const bool is_chosen = is_worth_choosing(evaluation);
    if (is_chosen) {
      const Evaluation all = choose(algorithm, now, evaluation);
      confirmed = {all.success(), all.mean_return};
      succeeds = is_good(all) && is_confirmed(algorithm, now);
    }
    if (!best.is_confirmed() || confirmed.is_better_than(best.confirmed) || succeeds)
      best = {std::move(now.parameters), seen, confirmed};
  }
  seen_ = evaluation;
  // All at once, for callers that continue after an exception.
  point.evaluation_return = evaluation.mean_return;
  if (has_success_) point.evaluation_success = evaluation.success();
  return succeeds;
}

}  // namespace eagerx::train

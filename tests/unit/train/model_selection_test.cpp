// When policies are evaluated, which is the best, and when one is good.
#include "targets/environments/train/model_selection.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "targets/environments/train/training.hpp"
#include "tests/unit/train/common.hpp"

namespace eagerx::train {
namespace {

/// Episodes of the pendulum have 150 steps, so those of an evaluation have 100 times as many.
constexpr double kEvaluation = 100 * 150;

/// The steps after which there are evaluations, if each iteration has this number.
std::vector<double> due(Settings settings, double steps, std::size_t iterations) {
  ThreadPool pool(1);
  ModelSelection selection(settings, pendulum(), *kernels_here().back(), pool,
                           environments::alone());
  std::vector<CurvePoint> curve;
  std::vector<double> result;
  EXPECT_FALSE(selection.is_due(curve)) << "nothing was learnt yet";
  while (curve.size() < iterations) {
    CurvePoint point{};
    point.steps = steps * static_cast<double>(curve.size() + 1);
    point.evaluation_return = std::nan("");
    curve.push_back(point);
    if (!selection.is_due(curve)) continue;
    result.push_back(point.steps);
    curve.back().evaluation_return = 0.0;
    EXPECT_FALSE(selection.is_due(curve)) << "once is enough";
  }
  return result;
}

TEST(TrainModelSelection, LongIterationsAreFollowedByEvaluationsEvenly) {
  Settings settings;
  settings.eval_interval = 3;
  EXPECT_EQ(due(settings, 8192, 10), (std::vector<double>{3 * 8192, 6 * 8192, 9 * 8192}));
}

TEST(TrainModelSelection, EvaluationsTakeNoMoreStepsThanLearningOrAreAtMostATwentiethLate) {
  Settings settings;
  settings.eval_interval = 5;
  constexpr double kSteps = 512, kFive = 5 * kSteps;
  const std::vector<double> all = due(settings, kSteps, 2000);
  EXPECT_EQ(all.front(), kFive);
  double before = 0.0;
  for (const double now : all) {
    EXPECT_GE(now - before, std::min(kEvaluation, now / 20.0)) << now;
    EXPECT_LT(now - before, std::min(kEvaluation, now / 20.0) + kFive + 1.0) << now;
    before = now;
  }
  EXPECT_EQ(all[10], 11 * kFive) << "while little is learnt it is as `eval_interval` says";
  EXPECT_EQ(all[all.size() - 1] - all[all.size() - 2], std::ceil(kEvaluation / kFive) * kFive);
}

TEST(TrainModelSelection, SacIsEvaluatedAtMostATwentiethLate) {
  Settings settings;
  settings.algorithm = "sac";
  constexpr double kSteps = 512;
  const std::vector<double> all = due(settings, kSteps, 200);
  EXPECT_EQ(all.front(), 2 * kSteps) << "the first updates were made after 1,000 steps";
  for (std::size_t i = 1; i < all.size(); ++i) {
    const double since = all[i] - all[i - 1];
    EXPECT_LT(since, std::max(kSteps, all[i] / 20.0) + kSteps) << all[i];
    EXPECT_TRUE(since == kSteps || all[i] > 20 * kSteps) << all[i];
  }
  settings.sac.utd_ratio =
      0.1F;  // 6,554 samples of an iteration, and 15,000 steps of an evaluation
  EXPECT_EQ(due(settings, kSteps, 10), (std::vector<double>{5 * kSteps, 10 * kSteps}));
}

/// Files of a training that ends at this share of successes.
Progressed trained(double share, std::uint64_t iterations) {
  const TestFolder folder;
  Options options;
  options.settings = even_settings();
  options.settings.target_success_rate = share;
  options.steps = iterations * kIteration;
  options.output = folder.path("policy.safetensors");
  options.checkpoint = folder.path("checkpoint");
  options.threads = 1;
  options.is_quiet = true;
  Training(options, pendulum()).run(never);
  ThreadPool pool(1);
  Progressed progressed;
  chosen_algorithm(options.settings, pendulum(), *kernels_here().back(), pool,
                   environments::alone())
      ->restore(read_file(options.checkpoint), "checkpoint",
                conditions(options.settings, pendulum().description().hash), progressed);
  return progressed;
}

TEST(TrainModelSelection, WhereMostEpisodesFailTheBestIsOfThoseThatAllHave) {
  const Progressed early = trained(0.99, 5);
  ASSERT_FALSE(early.best.parameters.empty());
  EXPECT_LT(early.best.seen.success, 0.89);
  EXPECT_FALSE(early.best.is_confirmed());
}

/// The evaluation of a policy that has learnt nothing.
Evaluation seen_at_first(const Settings& settings) {
  ThreadPool pool(1);
  ModelSelection selection(settings, pendulum(), *kernels_here().back(), pool,
                           environments::alone());
  const auto algorithm =
      chosen_algorithm(settings, pendulum(), *kernels_here().back(), pool, environments::alone());
  Best best;
  CurvePoint point{};
  EXPECT_FALSE(selection.evaluate(*algorithm, best, point));
  EXPECT_EQ(point.evaluation_success, selection.seen().success());
  EXPECT_EQ(best.seen.success, selection.seen().success());
  return selection.seen();
}

TEST(TrainModelSelection, APolicyThatFailsInTheFirst32EpisodesIsNotSeenInTheOthers) {
  Settings settings;
  EXPECT_EQ(seen_at_first(settings).episodes, 32U);
  settings.n_eval_episodes = 20;
  EXPECT_EQ(seen_at_first(settings).episodes, 20U);
}

TEST(TrainModelSelection, WhereFewHaveToSucceedAllEpisodesAreSeen) {
  Settings settings;
  settings.target_success_rate = 0.5;
  EXPECT_EQ(seen_at_first(settings).episodes, 32U);
  settings.target_success_rate = 0.49;
  EXPECT_EQ(seen_at_first(settings).episodes, settings.n_eval_episodes);
}

TEST(TrainModelSelection, SomePartsAfterOthersAreOneEvaluation) {
  constexpr std::size_t kEpisodes = 40, kInputs = 3;
  const Settings settings;
  ThreadPool pool(1);
  const Kernels& kernels = *kernels_here().back();
  const auto algorithm =
      chosen_algorithm(settings, pendulum(), kernels, pool, environments::alone());
  ModelSelection selection(settings, pendulum(), kernels, pool, environments::alone());
  const Policy policy = selection.policy(*algorithm, algorithm->deployed_parameters());
  Evaluator evaluator(pendulum(), kernels, pool, 150, kEpisodes);
  ASSERT_EQ(evaluator.parts(), 3U);
  Statistics observations = algorithm->observations();
  observations.mean.assign(kInputs, 7.5);  // some of what is seen is far from it
  const auto run = [&](environments::Share some) {
    return evaluator.run(policy, 7, observations, {}, some);
  };
  const Evaluation all = run(evaluator.all());
  Evaluation added = run({0, 1});
  EXPECT_EQ(added.episodes, 16U);
  added.add(run({1, 3}));
  ASSERT_EQ(added.outcomes.size(), kEpisodes);
  for (std::size_t i = 0; i < kEpisodes; ++i) {
    EXPECT_EQ(added.outcomes[i].environment, i);
    EXPECT_EQ(added.outcomes[i].sum, all.outcomes[i].sum) << i;
  }
  constexpr double kRounding = 1e-9;
  EXPECT_EQ(added.successes, all.successes);
  EXPECT_NEAR(added.mean_return, all.mean_return, kRounding * std::abs(all.mean_return));
  EXPECT_NEAR(added.mean_steps, all.mean_steps, kRounding * all.mean_steps);
  EXPECT_NEAR(added.saturated, all.saturated, kRounding);
  ASSERT_EQ(added.far.size(), kInputs);
  for (std::size_t i = 0; i < kInputs; ++i) EXPECT_NEAR(added.far[i], all.far[i], kRounding) << i;
  EXPECT_GT(all.far[0], 0.0);
  EXPECT_LT(all.far[0], 1.0);
}

TEST(TrainModelSelection, ATrainingEndsAtTheShareThatIsAskedFor) {
  const Progressed all = trained(0.4, 200);
  EXPECT_TRUE(all.succeeded);
  ASSERT_TRUE(all.best.is_confirmed());
  EXPECT_GE(all.best.seen.success, 0.4);
  EXPECT_GE(all.best.confirmed.success, 0.4);
  for (std::size_t i = 0; i + 1 < all.curve.size(); ++i) {
    const double success = all.curve[i].evaluation_success;
    EXPECT_FALSE(success >= 0.5) << i << ": it would have been good enough";
  }
}

TEST(TrainModelSelection, AShareOfTheEpisodesIsOneOfWholeNumbers) {
  Evaluation evaluation;
  evaluation.episodes = 100;
  evaluation.successes = 99;
  EXPECT_TRUE(evaluation.passed(0.99));
  EXPECT_FALSE(evaluation.passed(1.0));
  evaluation.successes = 98;
  EXPECT_FALSE(evaluation.passed(0.99));
  evaluation.episodes = 400;
  evaluation.successes = 396;
  EXPECT_TRUE(evaluation.passed(0.99));
}

}  // namespace
}  // namespace eagerx::train

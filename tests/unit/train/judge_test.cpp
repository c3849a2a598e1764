// When policies are evaluated, which is the best, and when one is good.
#include "targets/environments/train/judge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "targets/environments/train/training.hpp"
#include "tests/unit/train/common.hpp"

namespace eagerx::train {
namespace {

/// Episodes of the pendulum have 150 steps, so those of an evaluation have so many.
constexpr double kEvaluation = 100 * 150;

/// The steps after which there are evaluations, if each iteration has so many.
std::vector<double> due(Settings settings, double steps, std::size_t iterations) {
  Team team(1);
  Judge judge(settings, pendulum(), *kernels_here().back(), team, environments::alone());
  std::vector<CurvePoint> curve;
  std::vector<double> result;
  EXPECT_FALSE(judge.is_due(curve)) << "nothing was learnt yet";
  while (curve.size() < iterations) {
    CurvePoint point{};
    point.steps = steps * static_cast<double>(curve.size() + 1);
    point.evaluation_return = std::nan("");
    curve.push_back(point);
    if (!judge.is_due(curve)) continue;
    result.push_back(point.steps);
    curve.back().evaluation_return = 0.0;
    EXPECT_FALSE(judge.is_due(curve)) << "once is enough";
  }
  return result;
}

TEST(TrainJudge, LongIterationsAreFollowedByEvaluationsEvenly) {
  Settings settings;
  settings.evaluation_every = 3;
  EXPECT_EQ(due(settings, 8192, 10), (std::vector<double>{3 * 8192, 6 * 8192, 9 * 8192}));
}

TEST(TrainJudge, EvaluationsTakeNoMoreStepsThanLearningOrAreAtMostATwentiethLate) {
  Settings settings;
  settings.evaluation_every = 5;
  constexpr double kSteps = 512, kFive = 5 * kSteps;
  const std::vector<double> all = due(settings, kSteps, 2000);
  EXPECT_EQ(all.front(), kFive);
  double before = 0.0;
  for (const double now : all) {
    EXPECT_GE(now - before, std::min(kEvaluation, now / 20.0)) << now;
    EXPECT_LT(now - before, std::min(kEvaluation, now / 20.0) + kFive + 1.0) << now;
    before = now;
  }
  EXPECT_EQ(all[10], 11 * kFive) << "while little is learnt it is as `evaluation_every` says";
  EXPECT_EQ(all[all.size() - 1] - all[all.size() - 2], std::ceil(kEvaluation / kFive) * kFive);
}

/// What a training leaves that ends at this share of successes.
Progressed trained(double share, std::uint64_t iterations) {
  const TestFolder folder;
  Options options;
  options.settings = even_settings();
  options.settings.success_share = share;
  options.steps = iterations * kIteration;
  options.output = folder.path("policy.safetensors");
  options.checkpoint = folder.path("checkpoint");
  options.threads = 1;
  options.is_quiet = true;
  Training(options, pendulum()).run(never);
  Team team(1);
  Progressed progressed;
  chosen_algorithm(options.settings, pendulum(), *kernels_here().back(), team,
                   environments::alone())
      ->restore(read_file(options.checkpoint), "checkpoint",
                conditions(options.settings, pendulum().description().hash), progressed);
  return progressed;
}

TEST(TrainJudge, WhereMostEpisodesFailTheBestIsOfThoseThatAllHave) {
  const Progressed early = trained(0.99, 5);
  ASSERT_FALSE(early.best.parameters.empty());
  EXPECT_LT(early.best.seen.successes, 89U);
  EXPECT_FALSE(early.best.is_judged());
}

TEST(TrainJudge, ATrainingEndsAtTheShareThatIsAskedFor) {
  const Progressed all = trained(0.4, 200);
  EXPECT_TRUE(all.succeeded);
  ASSERT_TRUE(all.best.is_judged());
  EXPECT_GE(all.best.seen.successes, 40U);
  EXPECT_GE(all.best.judged.successes, 160U) << "of 400";
  for (std::size_t i = 0; i + 1 < all.curve.size(); ++i) {
    const double success = all.curve[i].evaluation_success;
    EXPECT_FALSE(success >= 0.5) << i << ": it would have been good enough";
  }
}

TEST(TrainJudge, AShareOfTheEpisodesIsOneOfWholeNumbers) {
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

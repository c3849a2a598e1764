// Stages of a task.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "targets/environments/train/training.hpp"
#include "tests/unit/train/common.hpp"

namespace eagerx::train {
namespace {

const Library& with_stages() {
  static const Library library(EAGERX_TEST_STAGES);
  return library;
}

class TrainStages : public testing::TestWithParam<const char*> {
 protected:
  std::string path(const std::string& name) const { return folder_.path(name); }

  static std::uint64_t iterations() { return GetParam() == std::string("ppo") ? 60 : 28; }
  Options options(std::uint64_t iterations) const {
    Options result;
    result.settings = even_settings();
    result.settings.algorithm = GetParam();
    result.output = path("policy.safetensors");
    result.csv = path("curve.csv");
    const Settings& settings = result.settings;
    const bool is_ppo = settings.algorithm == "ppo";
    result.steps = iterations * (is_ppo ? settings.n_envs * settings.n_steps
                                        : settings.sac.n_envs * settings.sac.train_freq);
    result.settings.net_arch = {16, 16};
    result.settings.until_return = 1.0;  // the reward is negative: it uses all steps
    result.threads = 1;
    result.is_quiet = true;
    return result;
  }

 private:
  TestFolder folder_;
};

/// The numbers of the stages of a training's iterations.
std::vector<double> stages_of(const std::vector<CurvePoint>& curve) {
  std::vector<double> stages;
  for (const CurvePoint& point : curve) stages.push_back(point.stage);
  return stages;
}

TEST_P(TrainStages, EndWhereWhatTheyWaitForIsReached) {
  const Options some = options(iterations());
  Training training(some, with_stages());
  training.run(never);
  const std::vector<CurvePoint>& curve = training.curve();
  ASSERT_FALSE(curve.empty());
  EXPECT_EQ(curve.front().stage, 1.0);
  EXPECT_GT(curve.back().stage, 1.0) << "the first one was passed";
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    const CurvePoint& now = curve[i];
    const bool is_evaluated = !std::isnan(now.evaluation_return);
    EXPECT_EQ(is_evaluated && now.stage < 3.0, !std::isnan(now.stage_return)) << i;
    const bool is_reached = now.stage == 1.0   ? now.stage_success >= 0.9
                            : now.stage == 2.0 ? now.stage_return >= -60.0
                                               : false;
    EXPECT_EQ(curve[i + 1].stage, now.stage + (is_reached ? 1.0 : 0.0)) << i;
  }
  const std::string csv = read_file(some.csv);
  EXPECT_NE(csv.find(",stage,stage_success_rate,stage_return\n"), std::string::npos);
}

// Also where the next stage has just begun, and in the middle of its first era.
TEST_P(TrainStages, GoOnFromACheckpointAsOneTraining) {
  Options whole = options(iterations());
  Training training(whole, with_stages());
  training.run(never);
  const std::string policy = read_file(whole.output), curve = read_file(whole.csv);
  const std::vector<double> stages = stages_of(training.curve());
  const auto second =
      static_cast<std::size_t>(std::find(stages.begin(), stages.end(), 2.0) - stages.begin());
  ASSERT_LT(second + 3, stages.size());
  for (const std::size_t count : {second, second + 3}) {
    Options first = whole;
    first.steps = whole.steps / iterations() * count;
    first.checkpoint = path("checkpoint");
    Training(first, with_stages()).run(never);
    Options rest = whole;
    rest.resume = first.checkpoint;
    Training(rest, with_stages()).run(never);
    EXPECT_EQ(read_file(rest.output), policy) << count;
    EXPECT_EQ(read_file(rest.csv), curve) << count;
  }
}

INSTANTIATE_TEST_SUITE_P(Algorithms, TrainStages, testing::Values("ppo", "sac"));

}  // namespace
}  // namespace eagerx::train

// Trainings with soft actor-critic.
#include "targets/environments/train/sac/sac.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "targets/environments/train/training.hpp"
#include "tests/unit/train/common.hpp"
#include "tests/unit/train/sac_common.hpp"

namespace eagerx::train {
namespace {

namespace fs = std::filesystem;

class TrainSac : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.path(name); }

  Options options(std::uint64_t steps) const {
    Options result;
    result.settings.algorithm = "sac";
    result.library = EAGERX_TEST_PENDULUM;
    result.output = path("policy.safetensors");
    result.steps = steps;
    result.threads = 1;
    result.is_quiet = true;
    return result;
  }
  /// Quick, with an era of 16 iterations, and a memory that is full by then.
  Options quick(std::uint64_t iterations) const {
    Options result = options(iterations * 8 * 64);
    result.settings.net_arch = {8, 8};
    result.settings.sac.utd_ratio = 0.125F;
    result.settings.sac.buffer_size = 8500;
    return result;
  }

  static std::string trained(const Options& options) {
    Training(options, pendulum()).run(never);
    return read_file(options.output);
  }

 private:
  TestFolder folder_;
};

TEST_F(TrainSac, AnyNumberOfThreadsAndAnyInstructionsLearnTheSameBits) {
  Options one = quick(4);
  const std::string policy = trained(one);
  for (const unsigned threads : {2U, 3U}) {
    one.threads = threads;
    EXPECT_EQ(trained(one), policy) << threads << " threads";
  }
  for (const Kernels* kernels : kernels_here()) {
    one.kernels = kernels->name;
    EXPECT_EQ(trained(one), policy) << kernels->name;
  }
  one.settings.seed = 2;
  EXPECT_NE(trained(one), policy);
}

TEST_F(TrainSac, WhatGoesOnFromACheckpointIsOneTraining) {
  Options whole = quick(21);
  whole.csv = path("whole.csv");
  const std::string policy = trained(whole);
  const std::string curve = read_file(whole.csv);
  for (const std::uint64_t iterations : {1, 5, 16, 18}) {  // an era begins behind 16
    Options first = quick(iterations);
    first.checkpoint = path("checkpoint");
    trained(first);
    Options second = whole;
    second.resume = first.checkpoint;
    EXPECT_EQ(trained(second), policy) << iterations;
    EXPECT_EQ(read_file(second.csv), curve) << iterations;
  }
}

TEST_F(TrainSac, LogsAreLearntFromAndAreInTheCheckpoint) {
  Options whole = quick(6);
  const std::string without = trained(whole);
  write_file(path("run.csv"), kHeader + kRows);
  whole.replay = {path("run.csv"), path("run.csv")};
  const std::string policy = trained(whole);
  EXPECT_NE(policy, without);
  Options first = quick(2);
  first.replay = whole.replay;
  first.checkpoint = path("checkpoint");
  trained(first);
  Options second = quick(6);
  second.resume = first.checkpoint;
  EXPECT_EQ(trained(second), policy);
  whole.settings.algorithm = "ppo";
  EXPECT_NE(
      said_by([&] { Training(whole, pendulum()); }).find("PPO learns from its own steps only"),
      std::string::npos);
}

TEST_F(TrainSac, LearnsToSwingUp) {
  EXPECT_EQ(Training(options(30'000), pendulum()).run(never), kDone);  // 99 of 100, four times
}

TEST_F(TrainSac, TheLearningRateDecays) {
  const Options constant = quick(21);
  Options decaying = constant;
  decaying.settings.decay_steps = 8 * 64;  // an iteration
  Training first(constant, pendulum()), second(decaying, pendulum());
  first.run(never);
  const std::string policy = read_file(constant.output);
  second.run(never);
  const std::string decayed = read_file(decaying.output);
  EXPECT_NE(decayed, policy);
  const float rate = constant.settings.learning_rate;
  EXPECT_EQ(first.curve().back().step_size, double{rate});
  // The curve has what the next iteration learns with.
  EXPECT_FLOAT_EQ(static_cast<float>(second.curve().front().step_size), rate / 2.0F);
  EXPECT_FLOAT_EQ(static_cast<float>(second.curve().back().step_size), rate / 22.0F);
  Options begun = decaying;
  begun.steps = std::uint64_t{18} * 8 * 64;
  begun.checkpoint = path("checkpoint");
  trained(begun);
  Options rest = decaying;
  rest.resume = begun.checkpoint;
  EXPECT_EQ(trained(rest), decayed);
}

TEST_F(TrainSac, FineTuningBeginsWithWhatWasLearnt) {
  Options first = quick(4);
  first.checkpoint = path("checkpoint");
  trained(first);
  Options second = quick(2);
  second.settings.seed = 3;
  const std::string anew = trained(second);
  second.from = first.checkpoint;
  EXPECT_NE(trained(second), anew);
  second.settings.algorithm = "ppo";
  EXPECT_NE(said_by([&] {
              Training(second, pendulum());
            }).find("is of other networks: algorithm sac (here ppo)"),
            std::string::npos);
  second.from.clear();
  second.resume = first.checkpoint;
  EXPECT_NE(said_by([&] {
              Training(second, pendulum());
            }).find("belongs to another training: algorithm sac (here ppo)"),
            std::string::npos);
}

/// The temperature after some updates with this target entropy, in rewards as they come: what is
/// learnt first is not scaled, then the temperature goes with the scale.
float temperature_for(float entropy, const Library& library) {
  train::Settings settings;
  settings.net_arch = {8};
  settings.sac.learning_starts = 128;
  settings.sac.target_entropy_per_action = entropy;
  ThreadPool pool(1);
  sac::Sac sac(settings, library, *kernels_here().back(), pool, 0);
  sac.begin_era();
  sac.iterate();
  const auto scale = static_cast<float>(sac.model().reward_scale);
  return exp(sac.model().log_temperature.front()) / scale;
}

TEST_F(TrainSac, TheTemperatureGrowsWhereEntropyIsMissing) {
  const float first = train::Settings().sac.initial_ent_coef;
  EXPECT_GT(temperature_for(0.7F, pendulum()), 1.2F * first);  // more than -1…1 can have
  EXPECT_LT(temperature_for(-9.0F, pendulum()), first / 1.2F);
}

/// A critic's values of sixteen states, in unscaled rewards.
Simd value(const sac::Model& model, std::size_t critic) {
  Simds row(model.critic.row());
  std::vector<float> rows;
  Random random({7, 0, 0}, 1);
  for (std::size_t i = 0; i < kLanes * model.actor.inputs(); ++i)
    rows.push_back(random.uniform(-1.0F, 1.0F));
  Normaliser(model.observations).load(rows.data(), row.data());
  row[model.actor.inputs()] = {{0.5F}};
  model.critic.forward(*kernels_here().back(), model.critics[critic].parameters.data(), row.data());
  Simd answer = row[model.critic.output()];
  for (float& x : answer.lane) x /= static_cast<float>(model.reward_scale);
  return answer;
}

void expect_that_answers_stay(double scale_steps) {
  train::Settings settings;
  settings.sac.norm_window_steps = scale_steps;
  settings.net_arch = {8};
  settings.sac.learning_starts = 1;
  settings.sac.utd_ratio = 0.001F;  // one in the second iteration of 512 steps, none in the third
  ThreadPool pool(1);
  sac::Sac sac(settings, pendulum(), *kernels_here().back(), pool, 0);
  sac.begin_era();
  sac.iterate();
  sac.iterate();
  ASSERT_EQ(sac.model().actor_adam.steps, 1U);
  const sac::Model before = sac.model();
  const std::vector<float> policy = sac.deployed_parameters();
  sac.iterate();
  const sac::Model& after = sac.model();
  ASSERT_EQ(after.actor_adam.steps, 1U);
  ASSERT_GT(std::fabs(after.reward_scale / before.reward_scale - 1.0), 0.01);
  ASSERT_GT(std::fabs(after.observations.mean[2] - before.observations.mean[2]), 1e-4);
  for (std::size_t c = 0; c < 2; ++c) {
    const Simd old = value(before, c), now = value(after, c);
    for (std::size_t l = 0; l < kLanes; ++l)
      EXPECT_NEAR(now.lane[l], old.lane[l], 1e-4 + 1e-3 * std::fabs(old.lane[l]));
  }
  const auto weight = [](const sac::Model& model) {
    return std::exp(double{model.log_temperature.front()}) / model.reward_scale;
  };
  EXPECT_NEAR(weight(after) / weight(before), 1.0, 1e-4);
  const std::vector<float> now = sac.deployed_parameters();
  for (std::size_t i = 0; i < policy.size(); ++i) EXPECT_NEAR(now[i], policy[i], 1e-4);
}

TEST_F(TrainSac, WhatIsLearntStaysWhenScalesChange) {
  expect_that_answers_stay(0.0);
}

TEST_F(TrainSac, WhatIsLearntStaysWhenScalesAreForgotten) {
  expect_that_answers_stay(300.0);
}

TEST_F(TrainSac, ScalesForgetWhatWasLongAgo) {
  Statistics all(1), last(1);
  for (const double size : {100.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0}) {
    Sums rows(1);
    for (const double x : {size, -size, size, -size}) rows.add(0, x);
    rows.count = 4.0;
    last.forget_beyond(2.0);
    last.add(rows);
    all.forget_beyond(1e12);
    all.add(rows);
  }
  EXPECT_NEAR(all.scale(0), 0.03, 1e-3);  // a ninth of the rows have 100² of the variance
  EXPECT_GT(last.scale(0), 0.5);          // each time a third of it is left: 10,000 / 3⁸ = 1.5
}

/// Mean size of what a critic says where it learns the next reward alone, with this reward_scale,
/// in deviations of the returns.
float mean_value(float reward_scale) {
  train::Settings settings;
  settings.net_arch = {8};
  settings.gamma = 0.0F;
  settings.learning_rate = 0.01F;
  settings.sac.learning_starts = 1;
  settings.sac.reward_scale = reward_scale;
  ThreadPool pool(1);
  sac::Sac sac(settings, pendulum(), *kernels_here().back(), pool, 0);
  sac.begin_era();
  for (int i = 0; i < 3; ++i) sac.iterate();
  Simd said = value(sac.model(), 0);
  const double scale = sac.model().reward_scale / sac.model().returns.scale(0);
  for (float& x : said.lane) x *= static_cast<float>(scale);
  float sum = 0.0F;
  for (const float x : said.lane) sum += std::fabs(x) / static_cast<float>(kLanes);
  return sum;
}

TEST_F(TrainSac, CriticsLearnScaledRewards) {
  const float plain = mean_value(1.0F);
  EXPECT_GT(mean_value(8.0F), 6.0F * plain);
  EXPECT_LT(mean_value(8.0F), 10.0F * plain);
}

/// The scale that is estimated where the rewards are ±1, the returns 0 ± `deviation`, and this
/// share of the steps ends the task.
double scale_for(double deviation, double ends = 0.0, float reward_scale = 0.0F) {
  train::Settings settings;
  settings.sac.reward_scale = reward_scale;
  settings.net_arch = {8};
  sac::Model model(settings, 3, Head(pendulum().description()));
  Sums returns(1), rewards(2);
  constexpr int kSteps = 1000;
  for (int i = 0; i < kSteps; ++i) {
    const double sign = i % 2 == 0 ? 1.0 : -1.0;
    returns.add(0, sign * deviation);
    rewards.add(0, sign);
    rewards.add(1, i < ends * kSteps ? 0.0 : 1.0);
  }
  returns.count = rewards.count = kSteps;
  model.returns.add(returns);
  model.rewards.add(rewards);
  return model.estimated_scale();
}

TEST_F(TrainSac, CriticsAreFinerWhereReturnsVaryMoreThanIndependentErrors) {
  EXPECT_NEAR(scale_for(5.0), 1.0 / 5.0, 1e-6);
  EXPECT_NEAR(scale_for(10.0), 1.0 / 10.0, 1e-6) << "100 steps of ±1";
  EXPECT_NEAR(scale_for(20.0), 4.0 / 20.0, 1e-6) << "four times that variance";
  const double ends = 0.99 * 0.99 * 0.002 * (1.0 - 0.002) * 30.0 * 30.0;  // γ² V[Γ] E[G²]
  EXPECT_NEAR(scale_for(30.0, 0.002), 9.0 / (1.0 + ends) / 30.0, 1e-6);
  EXPECT_NEAR(scale_for(1000.0), 10.0 / 1000.0, 1e-6) << "not more than ten times";
  EXPECT_NEAR(scale_for(20.0, 0.0, 3.0F), 3.0 / 20.0, 1e-6) << "as `reward_scale` says";
}

/// What is learned with rewards of another unit.
class Unit {
 public:
  explicit Unit(const char* factor) { setenv("EAGERX_TEST_UNIT", factor, 1); }
  Unit(const Unit&) = delete;
  Unit& operator=(const Unit&) = delete;
  ~Unit() { unsetenv("EAGERX_TEST_UNIT"); }
};

TEST_F(TrainSac, TheUnitOfTheRewardDoesNotMatter) {
  const auto trained_in = [&](const char* unit) {
    const Unit scoped(unit);
    const Options options = quick(8);
    Training training(options, pendulum());
    training.run(never);
    return std::pair{read_file(options.output), training.evaluation().mean_return};
  };
  const auto [policy, mean_return] = trained_in("1");
  const auto [same, more] = trained_in("128");
  EXPECT_EQ(same, policy) << "a power of two is exact";
  EXPECT_EQ(more, 128.0 * mean_return);
  for (const char* const unit : {"100", "0.01"}) {
    const double factor = std::stod(unit);
    EXPECT_NEAR(trained_in(unit).second / factor, mean_return, 0.02 * std::fabs(mean_return))
        << unit;
  }
}

TEST_F(TrainSac, ChoicesAreRefused) {
  static const Library choices(EAGERX_TEST_CHOICES);
  EXPECT_EQ(said_by([&] { Training(options(1), choices); }),
            "SAC learns real numbers, and the graph's actions are whole ones");
}

}  // namespace
}  // namespace eagerx::train

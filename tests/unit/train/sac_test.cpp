// Trainings with soft actor-critic.
#include "targets/environments/train/sac/sac.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

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
    result.settings.layers = {8, 8};
    result.settings.sac.updates = 0.125F;
    result.settings.sac.memory = 8500;
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

/// What the temperature has become while the policy should have so much entropy.
float temperature_for(float entropy, const Library& library) {
  train::Settings settings;
  settings.layers = {8};
  settings.sac.random_steps = 128;
  settings.sac.entropy = entropy;
  Team team(1);
  sac::Sac sac(settings, library, *kernels_here().back(), team, 0);
  sac.begin_era();
  sac.iterate();
  return exp(sac.model().log_temperature.front());
}

TEST_F(TrainSac, TheTemperatureGrowsWhereEntropyIsMissing) {
  const float first = train::Settings().sac.first_temperature;
  EXPECT_GT(temperature_for(0.7F, pendulum()), 1.2F * first);  // more than -1…1 can have
  EXPECT_LT(temperature_for(-9.0F, pendulum()), first / 1.2F);
}

TEST_F(TrainSac, ChoicesAreRefused) {
  static const Library choices(EAGERX_TEST_CHOICES);
  EXPECT_EQ(said_by([&] { Training(options(1), choices); }),
            "SAC learns real numbers, and the graph's action is a choice");
}

}  // namespace
}  // namespace eagerx::train

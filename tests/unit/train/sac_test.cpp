// Soft actor-critic: memory, gradients, temperature; and trainings with it.
#include "targets/environments/train/sac/sac.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include "targets/environments/train/checkpoint.hpp"
#include "targets/environments/train/sac/log.hpp"
#include "targets/environments/train/sac/squashed.hpp"
#include "targets/environments/train/training.hpp"

namespace eagerx::train {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kWidth = 2, kNumbers = 2;

train::Settings little() {
  train::Settings settings;
  settings.algorithm = "sac";
  settings.layers = {5};
  settings.sac.memory = 3;
  return settings;
}

Head two_numbers() {
  Description description;
  description.actions.push_back(
      {.name = "u", .dtype = "float32", .size = 2, .low = {-1.0, -1.0}, .high = {1.0, 1.0}});
  return Head(description);
}

TEST(TrainSacMemory, TheOldestGivesWay) {
  sac::Memory memory(1, 1, 3);
  for (int i = 0; i < 5; ++i) {
    const auto x = static_cast<float>(i);
    const float next = x + 0.5F, action = -x;
    memory.add({&x, &next, &action, 10.0F * x, i == 4 ? 0.0F : 1.0F});
    EXPECT_EQ(memory.size(), std::min(i + 1, 3));
    EXPECT_TRUE(memory.is_whole());
  }
  for (std::size_t back = 0; back < 3; ++back) {
    const sac::Transition one = memory.last(back);
    const auto x = static_cast<float>(4 - back);
    EXPECT_EQ(*one.observation, x);
    EXPECT_EQ(*one.next, x + 0.5F);
    EXPECT_EQ(*one.action, -x);
    EXPECT_EQ(one.reward, 10.0F * x);
    EXPECT_EQ(one.goes_on, back == 0 ? 0.0F : 1.0F);
  }
  memory.rows.pop_back();
  EXPECT_FALSE(memory.is_whole());
}

TEST(TrainSacSquashed, ProbabilitiesSumUpToOne) {
  constexpr float kLogDeviation = -0.4F, kMean = 0.3F;
  double sum = 0.0;
  constexpr int kCells = 20000;
  for (int i = 0; i < kCells; ++i) {
    const double action = -1.0 + (i + 0.5) * 2.0 / kCells;
    const double x = std::atanh(action);
    const auto noise = static_cast<float>((x - kMean) / std::exp(double{kLogDeviation}));
    sum += std::exp(sac::log_probability_of(noise, kLogDeviation, static_cast<float>(x))) * 2.0 /
           kCells;
  }
  EXPECT_NEAR(sum, 1.0, 1e-4);
}

TEST(TrainSacSquashed, SlopesOfTanhAreRightWhereItIsOne) {
  for (const float x : {0.0F, 0.7F, -2.0F, 5.0F}) {
    const double exact = std::log(1.0 - std::tanh(double{x}) * std::tanh(double{x}));
    EXPECT_NEAR(sac::log_tanh_slope(x), exact, 1e-5 * (1.0 + std::fabs(exact)));
  }
  EXPECT_NEAR(sac::log_tanh_slope(-40.0F), 2.0 * std::log(2.0) - 80.0, 1e-4);
}

/// Any network of this folder in double, for one sample.
std::vector<double> answers(const Network& network, const std::vector<double>& parameters,
                            std::vector<double> x) {
  for (const auto& layer : network.layers()) {
    std::vector<double> y;
    for (std::size_t j = 0; j < layer.sizes.outputs; ++j) {
      double sum = parameters[layer.bias + j];
      for (std::size_t i = 0; i < x.size(); ++i)
        sum += parameters[layer.weights + j * x.size() + i] * x[i];
      y.push_back(&layer == &network.layers().back() ? sum : std::tanh(sum));
    }
    x = y;
  }
  return x;
}

/// The losses of three transitions, with the noise that a learner draws, in double.
class TrainSacLosses : public testing::Test {
 protected:
  static constexpr float kScale = 0.7F, kTemperature = 0.3F;
  static constexpr double kStep = 1e-5;

  void SetUp() override {
    Random random({11, 0, 0}, 1);
    for (auto* values :
         {&model_.actor_parameters, &model_.critics[0].parameters, &model_.critics[1].parameters,
          &model_.critics[0].target, &model_.critics[1].target}) {
      for (float& x : *values) x += random.normal(0.0F, 0.3F);
    }
    for (int i = 0; i < 3; ++i) {
      float x[kWidth], next[kWidth], action[kNumbers];
      for (auto* row : {x, next}) {
        for (std::size_t k = 0; k < kWidth; ++k) row[k] = random.normal(0.0F, 1.0F);
      }
      for (float& one : action) one = random.uniform(-1.0F, 1.0F);
      model_.memory.add({x, next, action, random.normal(0.0F, 1.0F), i == 1 ? 0.0F : 1.0F});
    }
    for (std::size_t l = 0; l < kLanes; ++l) places_.push_back(l % 3);
    Random noise = random_;
    for (auto* drawn : {&next_noise_, &noise_}) {  // numbers first, then samples
      drawn->resize(kNumbers * kLanes);
      for (double& x : *drawn) x = noise.normal(0.0F, 1.0F);
    }
    learner_.learn({*kernels_here().back(), settings_, model_, Normaliser(model_.observations),
                    kScale, kTemperature},
                   places_, random_);
  }

  struct Drawn {
    std::vector<double> action;
    double log_probability = 0.0;
  };
  Drawn drawn(const std::vector<double>& actor, const std::vector<double>& observation,
              const std::vector<double>& noise, std::size_t lane) const {
    const auto out = answers(model_.actor, actor, observation);
    Drawn result;
    for (std::size_t j = 0; j < kNumbers; ++j) {
      const double log_deviation = -5.0 + 3.5 * (std::tanh(out[kNumbers + j]) + 1.0);
      const double e = noise[j * kLanes + lane];
      const double action = std::tanh(out[j] + std::exp(log_deviation) * e);
      result.action.push_back(action);
      result.log_probability += -0.5 * e * e - log_deviation - 0.5 * std::log(2.0 * M_PI) -
                                std::log(1.0 - action * action);
    }
    return result;
  }
  double value(const std::vector<double>& critic, std::vector<double> observation,
               const std::vector<double>& action) const {
    observation.insert(observation.end(), action.begin(), action.end());
    return answers(model_.critic, critic, observation).front();
  }
  static std::vector<double> to_double(const std::vector<float>& x) { return {x.begin(), x.end()}; }
  static std::vector<double> row(const float* x) { return {x, x + kWidth}; }

  double actor_loss(const std::vector<double>& actor) const {
    double sum = 0.0;
    for (std::size_t l = 0; l < kLanes; ++l) {
      const auto observation = row(model_.memory.at(places_[l]).observation);
      const Drawn one = drawn(actor, observation, noise_, l);
      double least = std::numeric_limits<double>::infinity();
      for (const sac::Critic& critic : model_.critics)
        least = std::min(least, value(to_double(critic.parameters), observation, one.action));
      sum += kTemperature * one.log_probability - least;
    }
    return sum;
  }
  double critic_loss(const std::vector<double>& critic) const {
    double sum = 0.0;
    for (std::size_t l = 0; l < kLanes; ++l) {
      const sac::Transition t = model_.memory.at(places_[l]);
      const Drawn one = drawn(to_double(model_.actor_parameters), row(t.next), next_noise_, l);
      double least = std::numeric_limits<double>::infinity();
      for (const sac::Critic& each : model_.critics)
        least = std::min(least, value(to_double(each.target), row(t.next), one.action));
      const double target = kScale * t.reward + settings_.discount * t.goes_on *
                                                    (least - kTemperature * one.log_probability);
      const std::vector<double> action(t.action, t.action + kNumbers);
      sum += 0.5 * std::pow(value(critic, row(t.observation), action) - target, 2.0);
    }
    return sum;
  }

  template <class Loss>
  static void compare(const std::vector<float>& ours, std::vector<double> at, Loss loss) {
    for (std::size_t i = 0; i < at.size(); ++i) {
      const double before = at[i];
      at[i] = before + kStep;
      const double above = loss(at);
      at[i] = before - kStep;
      const double below = loss(at);
      at[i] = before;
      const double exact = (above - below) / (2.0 * kStep);
      EXPECT_NEAR(ours[i], exact, 2e-4 + 1e-3 * std::fabs(exact)) << "parameter " << i;
    }
  }

  const train::Settings settings_ = little();
  sac::Model model_{settings_, kWidth, two_numbers()};
  std::vector<std::size_t> places_;
  const Random random_{{12, 0, 0}, 1};
  std::vector<double> next_noise_, noise_;  // [numbers][lanes]
  sac::Learner learner_{model_, 1};
};

TEST_F(TrainSacLosses, TheActorsGradientIsTheDifferenceOfLosses) {
  compare(learner_.gradient.actor, to_double(model_.actor_parameters),
          [&](const auto& x) { return actor_loss(x); });
}

TEST_F(TrainSacLosses, TheCriticsGradientsAreDifferencesOfLosses) {
  for (std::size_t c = 0; c < 2; ++c) {
    compare(learner_.gradient.critics[c], to_double(model_.critics[c].parameters),
            [&](const auto& x) { return critic_loss(x); });
  }
}

TEST_F(TrainSacLosses, TheDeployedNetworkHasTheMeans) {
  const Network network = sac::deployed(settings_, model_);
  const auto ours = to_double(sac::deployed_parameters(network, model_));
  const std::vector<double> x = {0.3, -0.8};
  const auto all = answers(model_.actor, to_double(model_.actor_parameters), x);
  EXPECT_EQ(answers(network, ours, x), std::vector<double>(all.begin(), all.begin() + kNumbers));
}

const std::string kHeader =
    "episode,step,time_s,angle[0],angle[1],speed,voltage,task.reward,task.terminated,"
    "task.truncated,task.success,task.angle\n";
/// Two episodes, of which the first ran out of time and the second fell.
const std::string kRows =
    "0,0,0,1,0,0.5,,,,,,\n"
    "0,1,0.1,0.9,0.1,0.25,-1,-2,0,0,0,-2\n"
    "0,2,0.2,0.8,0.2,0.125,4,-3,0,1,0,-3\n"
    "1,0,0,0,1,7,,,,,,\n"
    "1,1,0.1,0.5,0.5,8,0.5,-10,1,0,0,-10\n";

Description pendulum_description() {
  Description result;
  result.observations = {{.name = "angle", .dtype = "float32", .size = 2, .low = {}, .high = {}},
                         {.name = "speed", .dtype = "float32", .low = {}, .high = {}}};
  result.actions = {{.name = "voltage", .dtype = "float32", .low = {-2}, .high = {2}}};
  return result;
}

struct ReadLog {
  sac::Memory memory{3, 1, 100};
  Sums observations{3}, returns{1};
  sac::Log log;
  std::string problem;

  explicit ReadLog(const std::string& text) {
    try {
      log = sac::read_log(text, "run.csv", pendulum_description(), 0.5F, memory, observations,
                          returns);
    } catch (const Problem& what) {
      problem = what.what();
    }
  }
};

TEST(TrainSacLog, RowsBecomeTransitions) {
  const ReadLog read(kHeader + kRows + "1,2,0.2,0.4");  // the program was killed here
  ASSERT_EQ(read.problem, "");
  EXPECT_EQ(read.log.transitions, 3);
  EXPECT_EQ(read.log.left_out, 0);
  ASSERT_EQ(read.memory.size(), 3);
  const sac::Transition first = read.memory.at(0), second = read.memory.at(1),
                        fell = read.memory.at(2);
  EXPECT_EQ(first.observation[2], 0.5F);
  EXPECT_EQ(first.next[0], 0.9F);
  EXPECT_EQ(*first.action, -0.5F);
  EXPECT_EQ(first.reward, -2.0F);
  EXPECT_EQ(second.observation[2], 0.25F);
  EXPECT_EQ(*second.action, 1.0F) << "4 V were more than there may be";
  EXPECT_EQ(second.goes_on, 1.0F) << "it only ran out of time";
  EXPECT_EQ(fell.observation[2], 7.0F);
  EXPECT_EQ(fell.goes_on, 0.0F);
  EXPECT_EQ(read.observations.count, 5);
  EXPECT_EQ(read.returns.sum[0], -2.0 + (-2.0 * 0.5 - 3.0) - 10.0);
}

TEST(TrainSacLog, StepsThatLackNumbersAreLeftOut) {
  std::string rows = kRows;
  rows.replace(rows.find("0.125,4,-3"), 5, "nan");
  const ReadLog read(kHeader + rows + "1,3,0.3,0,0,0,0,0,0,0,0,0\n");
  ASSERT_EQ(read.problem, "");
  EXPECT_EQ(read.log.transitions, 2);
  EXPECT_EQ(read.log.left_out, 2) << "one is nan, one comes after a step that is missing";
}

TEST(TrainSacLog, OtherTablesAreRefused) {
  EXPECT_EQ(ReadLog("").problem, "`run.csv`, line 1: there is no header");
  EXPECT_EQ(ReadLog("a,b\n").problem, "`run.csv`, line 1: there is no column `episode`");
  EXPECT_EQ(ReadLog(kHeader + "0,0\n").problem, "`run.csv`, line 2: 2 cells, not 12");
  std::string wrong = kHeader + kRows;
  wrong.replace(wrong.find("0.25"), 4, "fast");
  EXPECT_EQ(ReadLog(wrong).problem, "`run.csv`, line 3: `fast` is no number");
  wrong = kHeader + kRows;
  wrong.replace(wrong.find("angle[1]"), 8, "tilt");
  EXPECT_EQ(ReadLog(wrong).problem, "`run.csv`, line 1: there are 1 columns of `angle`, not 2");
  EXPECT_EQ(ReadLog(kHeader + "-1,0,0,1,0,0.5,,,,,,\n").problem,
            "`run.csv`, line 2: `-1` is no whole number");
}

class TrainSac : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  static const Library& pendulum() {
    static const Library library(EAGERX_TEST_PENDULUM);
    return library;
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

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
    const Interrupt never = false;
    Training(options, pendulum()).run(never);
    return read_file(options.output);
  }
  template <class Work>
  static std::string said(Work work) {
    try {
      work();
    } catch (const Problem& problem) {
      return problem.what();
    }
    return "nothing";
  }

 private:
  fs::path folder_ = fs::temp_directory_path() / ("eagerx_train_sac_" + std::to_string(getpid()));
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
  EXPECT_NE(said([&] { Training(whole, pendulum()); }).find("PPO learns from its own steps only"),
            std::string::npos);
}

TEST_F(TrainSac, LearnsToSwingUp) {
  const Interrupt never = false;
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
  EXPECT_NE(said([&] {
              Training(second, pendulum());
            }).find("is of other networks: algorithm sac (here ppo)"),
            std::string::npos);
  second.from.clear();
  second.resume = first.checkpoint;
  EXPECT_NE(said([&] {
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
  sac.begin_era(0);
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
  EXPECT_EQ(said([&] { Training(options(1), choices); }),
            "SAC learns real numbers, and the graph's action is a choice");
}

/// A checkpoint that somebody has made, with a right check sum.
TEST_F(TrainSac, AMemoryThatDoesNotFitIsRefused) {
  const train::Settings settings = little();
  const auto restored = [&](sac::Model& model, std::uint32_t iterations) {
    Progressed progressed;
    progressed.iteration = iterations;
    progressed.curve.resize(iterations);
    const std::string bytes = checkpoint_of("graph 0", "interface", model, progressed);
    sac::Model other(settings, kWidth, two_numbers());
    return said([&] { restore(bytes, "it", "graph 0", other, progressed); });
  };
  sac::Model model(settings, kWidth, two_numbers());
  EXPECT_EQ(restored(model, 0), "nothing");
  EXPECT_EQ(restored(model, 1), "`it` is not complete") << "an iteration without transitions";
  model.memory.added = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(restored(model, 0), "`it` is not complete") << "transitions that are not there";
  model.memory.added = 512;
  model.memory.rows.resize(3 * model.memory.row());
  EXPECT_EQ(restored(model, 1), "nothing");
  model.actor_adam.steps = 1;
  EXPECT_EQ(restored(model, 1), "`it` is not complete") << "updates before there may be any";
}

}  // namespace
}  // namespace eagerx::train

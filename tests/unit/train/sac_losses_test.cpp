// Parts of soft actor-critic: memory, distribution of actions, gradients.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "targets/environments/train/checkpoint.hpp"
#include "targets/environments/train/sac/sac.hpp"
#include "targets/environments/train/sac/squashed.hpp"
#include "tests/unit/train/sac_common.hpp"

namespace eagerx::train {
namespace {

constexpr std::size_t kWidth = 2, kNumbers = 2;

train::Settings little() {
  train::Settings settings;
  settings.algorithm = "sac";
  settings.net_arch = {5};
  settings.sac.buffer_size = 3;
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
    EXPECT_EQ(one.continues, back == 0 ? 0.0F : 1.0F);
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

/// The losses of three transitions, with the noise that a learner samples, in double.
class TrainSacLosses : public testing::Test {
 protected:
  static constexpr float kScale = 0.7F, kTemperature = 0.3F;
  static constexpr double kStep = 1e-5;

  void SetUp() override {
    Random random({11, 0, 0}, 1);
    for (auto* values :
         {&model_.actor_parameters, &model_.averaged, &model_.critics[0].parameters,
          &model_.critics[1].parameters, &model_.critics[0].target, &model_.critics[1].target}) {
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
    for (auto* sampled : {&next_noise_, &noise_}) {  // numbers first, then samples
      sampled->resize(kNumbers * kLanes);
      for (double& x : *sampled) x = noise.normal(0.0F, 1.0F);
    }
    learner_.learn({*kernels_here().back(), settings_, model_, Normaliser(model_.observations),
                    kScale, kTemperature},
                   places_, random_);
  }

  struct Sampled {
    std::vector<double> action;
    double log_probability = 0.0;
  };
  Sampled sampled(const std::vector<double>& actor, const std::vector<double>& observation,
                  const std::vector<double>& noise, std::size_t lane) const {
    const auto out = answers(model_.actor, actor, observation);
    Sampled result;
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
      const Sampled one = sampled(actor, observation, noise_, l);
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
      const Sampled one = sampled(to_double(model_.actor_parameters), row(t.next), next_noise_, l);
      double least = std::numeric_limits<double>::infinity();
      for (const sac::Critic& each : model_.critics)
        least = std::min(least, value(to_double(each.target), row(t.next), one.action));
      const double target = kScale * t.reward + settings_.gamma * t.continues *
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
  const auto all = answers(model_.actor, to_double(model_.averaged), x);
  EXPECT_EQ(answers(network, ours, x), std::vector<double>(all.begin(), all.begin() + kNumbers));
}

/// A checkpoint that somebody has made, with a right check sum.
TEST(TrainSacMemory, AMemoryThatDoesNotFitIsRefused) {
  const train::Settings settings = little();
  const auto restored = [&](sac::Model& model, std::uint32_t iterations) {
    Progressed progressed;
    progressed.iteration = iterations;
    progressed.curve.resize(iterations);
    const std::string bytes = checkpoint_of("graph 0", "interface", model, progressed);
    sac::Model other(settings, kWidth, two_numbers());
    return said_by([&] { restore(bytes, "it", "graph 0", other, progressed); });
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

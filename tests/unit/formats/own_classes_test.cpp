// Zips whose policy class is not a library's, and whose actions were normalised in training
// (tests/data/policy/make_own_classes.py), against torch.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "generator/policy/agent/weights.hpp"
#include "generator/policy/formats/golden.hpp"
#include "generator/policy/formats/read.hpp"
#include "generator/policy/network/evaluate.hpp"

namespace eagerx::gen {
namespace {

using testing::HasSubstr;

const std::string kZips = EAGERX_SOURCE_DIR "/tests/data/policy/libraries/";

/// ppo_own_policy.zip, whose class has relu where the library's has tanh.
std::optional<Network> read_own_class(bool has_answers, std::optional<Activation> activation,
                                      Diagnostics& diagnostics) {
  PolicyRequest request;
  request.path = kZips + "ppo_own_policy.zip";
  request.name = "ppo_own_policy.zip";
  request.context.activation = activation;
  request.context.has_answers = has_answers;
  return read_policy(request, diagnostics);
}

TEST(OwnPolicyClass, IsRefusedWithoutKnownAnswers) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read_own_class(false, Activation::relu, diagnostics).has_value());
  const Diagnostic& problem = diagnostics.all().front();
  EXPECT_EQ(problem.code, "E0628");
  EXPECT_THAT(problem.message, HasSubstr("`__main__.CustomActorCriticPolicy`"));
  EXPECT_THAT(problem.message, HasSubstr("`_build_mlp_extractor`"));
  EXPECT_THAT(problem.help.text, HasSubstr("golden: rows.csv"));
}

TEST(OwnPolicyClass, IsReadAsFarAsTorchsAnswersAreThose) {
  const std::string name = "ppo_own_policy_golden.npz";
  for (const auto activation : {std::optional<Activation>(), std::optional(Activation::relu)}) {
    Diagnostics diagnostics;
    const auto network = read_own_class(true, activation, diagnostics);
    ASSERT_TRUE(network.has_value());
    EXPECT_THAT(network->assumed, testing::Contains(HasSubstr("CustomActorCriticPolicy")));
    const auto rows = read_golden(kZips + name, name, {}, diagnostics);
    ASSERT_TRUE(rows.has_value());
    const auto result = compare(*network, *rows, name, {}, diagnostics);
    EXPECT_EQ(result && result->passed(), activation.has_value()) << "tanh is not in this file";
  }
}

/// ppo_normalized.zip with `golden` or without, as an agent whose actions were normalised or not.
std::optional<Network> read_normalized(bool normalizes, bool golden) {
  AgentSpec spec;
  spec.kind = AgentSpec::Kind::policy;
  spec.file.value = "ppo_normalized.zip";
  if (normalizes) spec.normalize_actions = Spanned<bool>{true, {}};
  if (golden) spec.golden = Spanned<std::string>{"ppo_normalized_golden.npz", {}};
  Diagnostics diagnostics;
  auto network = read_weights(spec, kZips + "graph.yaml", diagnostics);
  for (const auto& problem : diagnostics.all()) ADD_FAILURE() << problem.message;
  return network;
}

std::vector<double> answer_to(const Network& network, const std::vector<double>& observation) {
  return evaluate_in_double(network, {observation.begin(), observation.end()});
}

/// The action that reaches the robot with bounds of -2 and 2: Stable-Baselines3's predict() clips
/// to the space of the training, and the environment scales what it is given.
TEST(NormalizedActions, AreClippedThenScaledToTheBounds) {
  const auto plain = read_normalized(false, true);
  ASSERT_TRUE(plain.has_value());
  EXPECT_EQ(plain->action_kind(), ActionKind::raw);
  Diagnostics diagnostics;
  const std::string name = "ppo_normalized_golden.npz";
  const auto rows = read_golden(kZips + name, name, {}, diagnostics);
  ASSERT_TRUE(rows.has_value());
  for (const bool golden : {false, true}) {
    auto network = read_normalized(true, golden);
    ASSERT_TRUE(network.has_value());
    EXPECT_EQ(network->action_kind(), ActionKind::squashed);
    network->contract.action_low = {-2.0};
    network->contract.action_high = {2.0};
    bool clips = false;
    for (std::size_t row = 0; row < rows->observations.size(); ++row) {
      const auto action = action_of(*network, answer_to(*network, rows->observations[row]));
      ASSERT_TRUE(action.has_value());
      for (std::size_t i = 0; i < action->size(); ++i) {
        EXPECT_NEAR((*action)[i], 2.0 * rows->actions[row][i], 1e-6);
        clips = clips || rows->actions[row][i] == 1.0;
      }
    }
    EXPECT_TRUE(clips) << "so that clipping is seen";
  }
}

std::optional<Network> read_some_normalized(const std::string& policy, Diagnostics& diagnostics) {
  PolicyRequest request;
  request.path = kZips + policy;
  request.name = policy;
  request.normalize_path = kZips + "ppo_some_normalized.pkl";
  request.normalize_name = "ppo_some_normalized.pkl";
  return read_policy(request, diagnostics);
}

/// VecNormalize's `norm_obs_keys`: choices and the other parts stay as they are, beyond the clip,
/// too.
TEST(SomeNormalized, OtherPartsStayAsTheyAre) {
  Diagnostics diagnostics;
  const auto network = read_some_normalized("ppo_dict_obs.zip", diagnostics);
  for (const auto& problem : diagnostics.all()) ADD_FAILURE() << problem.message;
  ASSERT_TRUE(network.has_value());
  const std::string name = "ppo_some_normalized_golden.npz";
  const auto rows = read_golden(kZips + name, name, {}, diagnostics);
  const auto result = rows ? compare(*network, *rows, name, {}, diagnostics) : std::nullopt;
  ASSERT_TRUE(result.has_value());
  EXPECT_TRUE(result->passed());
}

TEST(SomeNormalized, OfAnotherPolicyIsRefused) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read_some_normalized("ppo_discrete_obs.zip", diagnostics).has_value());
  EXPECT_EQ(diagnostics.all().front().code, "E0627");
  EXPECT_THAT(diagnostics.all().front().help.text, HasSubstr("`norm_obs_keys`"));
}

}  // namespace
}  // namespace eagerx::gen

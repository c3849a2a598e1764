// Policies as libraries save them (tests/data/policy/make_stable_baselines.py), against torch.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "generator/policy/formats/actor/actor.hpp"
#include "generator/policy/formats/golden.hpp"
#include "generator/policy/formats/read.hpp"
#include "generator/policy/formats/tensors/archive.hpp"
#include "generator/policy/formats/tensors/containers.hpp"
#include "generator/policy/network/evaluate.hpp"
#include "generator/policy/network/problem.hpp"
#include "tests/unit/formats/onnx_builder.hpp"
#include "tests/unit/formats/table_builder.hpp"

namespace eagerx::gen {
namespace {

using test::add_linear;
using test::NamedValues;
using test::read_bad;
using test::read_good;
using test::safetensors;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string kLibraries = EAGERX_SOURCE_DIR "/tests/data/policy/libraries/";

Network read_library(const std::string& name) {
  PolicyRequest request;
  request.path = kLibraries + name;
  request.name = name;
  const bool says_it = name.ends_with(".zip") || name.starts_with("cleanrl");
  if (!says_it) request.context.activation = Activation::elu;
  if (name.starts_with("rl_games_amp")) request.context.activation = Activation::relu;
  if (name.starts_with("safe_control")) request.context.activation = Activation::tanh;
  Diagnostics diagnostics;
  auto network = read_policy(request, diagnostics);
  for (const auto& problem : diagnostics.all()) ADD_FAILURE() << name << ": " << problem.message;
  return network ? *network : Network{{}, {}, {Layer{1, 1, {0}, {0}}}, {}};
}

struct Saved {
  const char* file;
  const char* golden;
  ActionKind action;
  const char* about;
};

class Libraries : public testing::TestWithParam<Saved> {};

TEST_P(Libraries, AnswerAsTorch) {
  const Network network = read_library(GetParam().file);
  EXPECT_EQ(network.action_kind(), GetParam().action);
  EXPECT_THAT(network.format, HasSubstr(GetParam().about));
  Diagnostics diagnostics;
  const std::string name = std::string(GetParam().golden) + "_golden.npz";
  const auto rows = read_golden(kLibraries + name, name, {}, diagnostics);
  const auto result = rows ? compare(network, *rows, name, {}, diagnostics) : std::nullopt;
  for (const auto& problem : diagnostics.all()) ADD_FAILURE() << problem.message;
  ASSERT_TRUE(result.has_value());
  EXPECT_TRUE(result->passed());
  EXPECT_EQ(result->actions.has_value(), !rows->actions.empty());
}

constexpr ActionKind kRaw = ActionKind::raw;
constexpr ActionKind kSquashed = ActionKind::squashed;
constexpr ActionKind kChoice = ActionKind::argmax;

INSTANTIATE_TEST_SUITE_P(
    , Libraries,
    testing::Values(
        Saved{"ppo_cnn.zip", "ppo_cnn", kRaw, "PPO"}, Saved{"a2c_cnn.zip", "a2c_cnn", kRaw, "A2C"},
        Saved{"dqn_cnn.zip", "dqn_cnn", kChoice, "DQN"},
        Saved{"sac_cnn.zip", "sac_cnn", kSquashed, "SAC"},
        Saved{"ppo_sde_squash.zip", "ppo_sde_squash", kSquashed, "PPO"},
        Saved{"maskable_ppo.zip", "maskable_ppo", kChoice, "PPO"},
        Saved{"sac_sde.zip", "sac_sde", kSquashed, "SAC"},
        Saved{"sac_linear.zip", "sac_linear", kSquashed, "SAC"},
        Saved{"crossq.zip", "crossq", kSquashed, "SAC"}, Saved{"td3.zip", "td3", kSquashed, "TD3"},
        Saved{"qrdqn.zip", "qrdqn", kChoice, "QR-DQN"}, Saved{"ars.zip", "ars", kSquashed, "ARS"},
        Saved{"ars_linear.zip", "ars_linear", kRaw, "ARS"},
        Saved{"rsl_rl.pt", "rsl_rl", kRaw, "rsl_rl"},
        Saved{"rsl_rl_legacy.pt", "rsl_rl", kRaw, "torch.save before 1.6, rsl_rl"},
        Saved{"td3_legacy.zip", "td3", kSquashed, "TD3"},
        Saved{"rsl_rl_3.pt", "rsl_rl", kRaw, "rsl_rl"},
        Saved{"rsl_rl_4.pt", "rsl_rl_4", kRaw, "rsl_rl"},
        Saved{"rl_games.pth", "rl_games", kRaw, "rl_games"}, Saved{"skrl.pt", "skrl", kRaw, "skrl"},
        Saved{"cleanrl_td3.pth", "cleanrl_td3", kSquashed, "CleanRL"},
        Saved{"ppo_discrete_obs.zip", "ppo_discrete_obs", kRaw, "PPO"},
        Saved{"ppo_multi_discrete_obs.zip", "ppo_multi_discrete_obs", kChoice, "PPO"},
        Saved{"ppo_multi_binary_obs.zip", "ppo_multi_binary_obs", kRaw, "PPO"},
        Saved{"ppo_dict_obs.zip", "ppo_dict_obs", kRaw, "PPO"},
        Saved{"ppo_multi_discrete.zip", "ppo_multi_discrete", kChoice, "PPO"},
        Saved{"ppo_multi_binary.zip", "ppo_multi_binary", ActionKind::binary, "PPO"},
        Saved{"rl_games_discrete.pth", "rl_games_discrete", kChoice, "rl_games"},
        Saved{"rl_games_amp.pth", "rl_games_amp", kRaw, "rl_games"},
        Saved{"sample_factory.pth", "sample_factory", kRaw, "Sample Factory"},
        Saved{"sample_factory_separate.pth", "sample_factory_separate", kRaw, "Sample Factory"},
        Saved{"safe_control_gym.pt", "safe_control_gym", kRaw, "safe-control-gym"}),
    [](const auto& test) {
      std::string name = test.param.file;
      for (char& c : name) {
        if (c == '.') c = '_';
      }
      return name;
    });

/// A zip with `keywords` among those of its policy.
std::string with_keywords(const std::string& zip, std::string_view keywords) {
  std::ifstream file(kLibraries + zip, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  PolicyProblem problem;
  const auto archive = Archive::open(bytes, problem);
  if (!archive) return {};
  std::vector<test::ZipEntry> entries;
  for (const std::string& name : archive->names()) {
    std::string buffer;
    entries.push_back({name, std::string(archive->read(name, buffer, problem).value_or(""))});
    if (name != "data") continue;
    constexpr std::string_view kKeywords = "\"policy_kwargs\": {";
    std::string& data = entries.back().content;
    data.insert(data.find(kKeywords) + kKeywords.size(), keywords);
  }
  return test::zip(entries);
}

/// crossq.zip with `epsilon` for its batch norms.
std::string crossq_with_epsilon(std::string_view epsilon) {
  return with_keywords("crossq.zip", fmt::format("\"batch_norm_eps\": {}", epsilon));
}

TEST(CrossQ, EpsilonOfItsBatchNorms) {
  const Network usual = read_good(crossq_with_epsilon("1e-3"));
  const Network large = read_good(crossq_with_epsilon("1.0"));
  const std::vector<float>& known = usual.layers.at(1).weights;  // scales of the first batch norm
  const std::vector<float>& scaled = large.layers.at(1).weights;
  ASSERT_EQ(scaled.size(), known.size());
  for (std::size_t i = 0; i < scaled.size(); ++i)
    EXPECT_LT(std::abs(scaled[i]), std::abs(known[i]));
  const std::vector<float> observation(usual.inputs(), 0.5F);
  EXPECT_EQ(evaluate(usual, observation), evaluate(read_library("crossq.zip"), observation));
}

TEST(OwnExtractor, WithTheNameOfALibrarysIsRefusedToo) {
  const std::string keywords =
      R"("features_extractor_class": "<class '__main__.FlattenExtractor'>")";
  EXPECT_THAT(read_bad(with_keywords("crossq.zip", keywords)).message,
              HasSubstr("`__main__.FlattenExtractor`"));
  const std::string usual =
      R"("features_extractor_class": "<class 'stable_baselines3.common.torch_layers.FlattenExtractor'>")";
  read_good(with_keywords("crossq.zip", usual));
}

TEST(Activation, OfAZipIsKnownAndOfTensorsAloneAssumed) {
  PolicyRequest request;
  request.path = EAGERX_SOURCE_DIR "/tests/data/policy/ppo_64.zip";
  request.name = "ppo_64.zip";
  request.context.activation = Activation::relu;
  Diagnostics diagnostics;
  EXPECT_FALSE(read_policy(request, diagnostics).has_value());
  EXPECT_EQ(diagnostics.all().front().code, "E0626") << "Stable-Baselines3's own is tanh";

  std::vector<NamedValues> tensors;
  add_linear(tensors, "mlp_extractor.policy_net.0", 3, 2);
  add_linear(tensors, "action_net", 2, 1);
  EXPECT_THAT(read_good(safetensors(tensors)).assumed, ElementsAre(HasSubstr("activation tanh")));
  const std::string said = R"("activation":"elu")";
  EXPECT_TRUE(read_good(safetensors(tensors, said)).assumed.empty());
}

TEST(Choices, AreNumbersOfTheObservation) {
  const Network one = read_library("ppo_discrete_obs.zip");
  EXPECT_EQ(one.inputs(), 1U);
  EXPECT_THAT(one.contract.choices, ElementsAre(5));
  EXPECT_THAT(one.contract.observation_high, ElementsAre(4.0));
  EXPECT_THAT(read_library("ppo_multi_discrete_obs.zip").contract.choices, ElementsAre(3, 4));
  EXPECT_THAT(read_library("ppo_multi_binary_obs.zip").contract.observation_high,
              ElementsAre(1.0, 1.0, 1.0, 1.0));
  const Network parts = read_library("ppo_dict_obs.zip");
  EXPECT_THAT(parts.contract.choices, ElementsAre(0, 0, 3, 0));
  EXPECT_EQ(parts.contract.observations.at(1).name, "gear");
  EXPECT_FALSE(parts.is_chain());
}

TEST(Choices, SeveralAtOnceHaveTheirOwnOutputs) {
  const Network gears = read_library("ppo_multi_discrete.zip");
  EXPECT_THAT(gears.contract.groups, ElementsAre(3, 2, 4));
  EXPECT_EQ(gears.actions(), 3U);
  EXPECT_EQ(action_of(gears, {0, 2, 1, 5, 5, -3, -2, -1, -4}), (std::vector<double>{1, 0, 2}));
  const Network lamps = read_library("ppo_multi_binary.zip");
  EXPECT_EQ(lamps.actions(), 4U);
  EXPECT_EQ(action_of(lamps, {-1, 0, 1e-9, 3}), (std::vector<double>{0, 0, 1, 1}));
  EXPECT_THAT(read_library("dqn_cnn.zip").contract.groups, testing::SizeIs(1))
      << "what chooses once never chooses several";
}

/// Whether golden rows accept a policy whose first action was changed.
bool passes_with_another_action(const std::string& name) {
  const Network network = read_library(name + ".zip");
  Diagnostics diagnostics;
  auto rows = read_golden(kLibraries + name + "_golden.npz", name, {}, diagnostics);
  if (!rows) return true;
  rows->actions.at(5).at(1) = 1.0 - rows->actions.at(5).at(1);
  return compare(network, *rows, name, {}, diagnostics).has_value();
}

TEST(Choices, AnotherOneIsNotRight) {
  EXPECT_FALSE(passes_with_another_action("ppo_multi_discrete"));
  EXPECT_FALSE(passes_with_another_action("ppo_multi_binary"));
}

TEST(Choices, AreNotNormalised) {
  PolicyRequest request;
  request.path = kLibraries + "ppo_dict_obs.zip";
  request.normalize_path = kLibraries + "../ppo_64_vecnormalize.pkl";
  Diagnostics diagnostics;
  EXPECT_FALSE(read_policy(request, diagnostics).has_value());
  EXPECT_EQ(diagnostics.all().front().code, "E0627");
}

TEST(SampleFactory, SaysWhetherItsOutputsAreScoresOrIsRefused) {
  std::vector<NamedValues> tensors;
  add_linear(tensors, "encoder.encoders.obs.mlp_head.0", 3, 2);
  add_linear(tensors, "action_parameterization.distribution_linear", 2, 4);
  Diagnostic diagnostic = read_bad(safetensors(tensors));
  EXPECT_EQ(diagnostic.code, "E0628");
  EXPECT_THAT(diagnostic.message, HasSubstr("scores of choices, or means"));
  tensors.push_back({"action_parameterization.learned_stddev", {4}, {0, 0, 0, 0}});
  EXPECT_EQ(read_good(safetensors(tensors)).outputs(), 4U);
  add_linear(tensors, "decoder.mlp.0", 2, 2);
  tensors.push_back({"core.core.weight_ih_l0", {4, 1}, std::vector<float>(4)});
  EXPECT_THAT(read_bad(safetensors(tensors)).message, HasSubstr("a memory and a decoder"));
}

TEST(RlGames, SeveralChoicesAtOnceAreRefusedByName) {
  std::vector<NamedValues> tensors;
  add_linear(tensors, "a2c_network.actor_mlp.0", 3, 2);
  add_linear(tensors, "a2c_network.logits.0", 2, 3);
  add_linear(tensors, "a2c_network.logits.1", 2, 3);
  const Diagnostic diagnostic = read_bad(safetensors(tensors));
  EXPECT_EQ(diagnostic.code, "E0628");
  EXPECT_THAT(diagnostic.message, HasSubstr("MultiDiscrete"));
}

TEST(RlGames, StatisticsNextToTheModelCountToo) {
  EXPECT_TRUE(read_library("rl_games_amp.pth").normalization.has_value());
}

TEST(CrossQ, NothingFollowsItsLastBatchNorm) {
  std::vector<NamedValues> tensors;
  add_linear(tensors, "actor.latent_pi.0", 3, 2);  // 1 is the activation
  for (const char* part : {"ra_mean", "ra_var", "scale", "bias"}) {
    tensors.push_back({std::string("actor.latent_pi.2.") + part, {2}, {1.0F, 1.0F}});
  }
  add_linear(tensors, "actor.mu", 2, 1);
  const Network network = read_good(safetensors(tensors));
  EXPECT_EQ(network.layers.front().activation, Activation::relu);
  EXPECT_EQ(network.layers.at(network.layers.size() - 2).activation, Activation::identity);
}

TEST(NatureCnn, KnowsTheSizeOfTheImage) {
  const Network network = read_library("ppo_cnn.zip");
  EXPECT_THAT(network.input_shape, ElementsAre(3, 36, 36));
  ASSERT_EQ(network.layers.size(), 7U);  // pixels, three convolutions, features, two of the policy
  EXPECT_EQ(network.inputs(), 3U * 36 * 36);
  EXPECT_TRUE(std::holds_alternative<Elementwise>(network.layers[0].form));
  EXPECT_TRUE(std::holds_alternative<Convolution>(read_library("a2c_cnn.zip").layers[0].form))
      << "normalize_images=False";
}

TEST(NatureCnn, NeedsTheSizeOfTheImage) {
  std::vector<NamedValues> tensors;
  add_linear(tensors, "action_net", 4, 1);
  tensors.push_back({"features_extractor.cnn.0.weight", {1, 1, 8, 8}, std::vector<float>(64)});
  const Diagnostic diagnostic = read_bad(safetensors(tensors));
  EXPECT_EQ(diagnostic.code, "E0628");
  EXPECT_THAT(diagnostic.message, HasSubstr("does not say how large they are"));
}

/// The problem with the NatureCNN in `tensors` for images of `shape`.
PolicyProblem cnn_problem(const std::vector<NamedValues>& tensors, const Dims& shape, bool scales) {
  const std::string bytes = safetensors(tensors);
  TensorTable table;
  PolicyProblem problem;
  EXPECT_TRUE(read_safetensors_table(bytes, table, problem)) << problem.message;
  PolicyFacts facts;
  facts.image = shape;
  facts.observations = element_count(shape);
  facts.scales_pixels = scales;
  EXPECT_FALSE(make_actor(table, facts, {}, problem).has_value());
  return problem;
}

TEST(NatureCnn, ItsSizesFitInto32Bits) {
  constexpr int kChannels = 4200;  // times 1023 * 1023 places
  std::vector<NamedValues> tensors;
  add_linear(tensors, "action_net", 1, 1);
  const std::string part = "features_extractor.";
  tensors.push_back(
      {part + "cnn.0.weight", {kChannels, 1, 8, 8}, std::vector<float>(kChannels * 64)});
  tensors.push_back({part + "cnn.0.bias", {kChannels}, std::vector<float>(kChannels)});
  tensors.push_back(
      {part + "cnn.2.weight", {1, kChannels, 4, 4}, std::vector<float>(kChannels * 16)});
  tensors.push_back({part + "cnn.2.bias", {1}, {0}});
  tensors.push_back({part + "cnn.4.weight", {1, 1, 3, 3}, std::vector<float>(9)});
  tensors.push_back({part + "cnn.4.bias", {1}, {0}});
  add_linear(tensors, part + "linear.0", 508 * 508, 1);
  EXPECT_EQ(cnn_problem(tensors, {1, 4096, 4096}, false).code, "E0619");
  EXPECT_EQ(cnn_problem(tensors, {1, 4096, 4096}, true).code, "E0619") << "once not scaled";
  EXPECT_EQ(cnn_problem(tensors, {1, 2048, 2048}, false).code, "E0619");
}

TEST(Statistics, OfQuantilesOneMustKnowTheActions) {
  std::vector<NamedValues> tensors;
  add_linear(tensors, "quantile_net.quantile_net.0", 3, 6);
  const Diagnostic diagnostic = read_bad(safetensors(tensors));
  EXPECT_EQ(diagnostic.code, "E0628");
  EXPECT_THAT(diagnostic.message, HasSubstr("for how many actions"));
}

TEST(Statistics, ComeInPairs) {
  std::vector<NamedValues> tensors;
  add_linear(tensors, "a2c_network.actor_mlp.0", 2, 3);
  add_linear(tensors, "a2c_network.mu", 3, 1);
  tensors.push_back({"running_mean_std.running_mean", {2}, {0, 0}});
  const char* elu = R"("activation":"elu")";
  Diagnostic diagnostic = read_bad(safetensors(tensors, elu));
  EXPECT_EQ(diagnostic.code, "E0627");
  EXPECT_THAT(diagnostic.message, HasSubstr("only one of `running_mean_std.running_mean`"));
  tensors.push_back({"running_mean_std.running_var", {2}, {1, -1}});
  diagnostic = read_bad(safetensors(tensors, elu));
  EXPECT_EQ(diagnostic.code, "E0627");
  EXPECT_THAT(diagnostic.message, HasSubstr("below zero"));
  tensors.back() = {"running_mean_std.running_var", {3}, {1, 1, 1}};
  EXPECT_THAT(read_bad(safetensors(tensors, elu)).message, HasSubstr("shape [3] for 2 inputs"));
}

TEST(Statistics, OfABatchNormFitItsLayer) {
  std::vector<NamedValues> tensors;
  add_linear(tensors, "net.0", 2, 3);
  tensors.push_back({"net.1.running_mean", {2}, {0, 0}});
  tensors.push_back({"net.1.running_var", {2}, {1, 1}});
  add_linear(tensors, "net.3", 3, 1);
  const char* relu = R"("activation":"relu","output_activation":"none")";
  Diagnostic diagnostic = read_bad(safetensors(tensors, relu));
  EXPECT_EQ(diagnostic.code, "E0618");
  EXPECT_THAT(diagnostic.message, HasSubstr("`net.1.running_mean` of shape [2] for 3"));
  tensors[2] = {"net.1.running_mean", {3}, {1, 0, 0}};
  tensors[3] = {"net.1.running_var", {3}, {1, 1, -1}};
  EXPECT_THAT(read_bad(safetensors(tensors, relu)).message, HasSubstr("below zero"));
  tensors[3] = {"net.1.running_var", {3}, {4, 1, 1}};
  const Network network = read_good(safetensors(tensors, relu));
  EXPECT_NEAR(evaluate(network, {1, 2}).front(), 1 + 3 + 3, 1e-4);
}

TEST(Squash, FollowsTheMeanOfRecurrentPpoToo) {
  std::vector<NamedValues> tensors;
  add_linear(tensors, "action_net", 1, 1);
  for (const char* side : {"i", "h"}) {
    const std::string name = std::string("lstm_actor.weight_") + side + "h_l0";
    tensors.push_back({name, {4, 1}, std::vector<float>(4, 0.5F)});
    tensors.push_back({std::string("lstm_actor.bias_") + side + "h_l0", {4}, {0, 0, 0, 0}});
  }
  const std::string bytes = safetensors(tensors);
  TensorTable table;
  PolicyProblem problem;
  ASSERT_TRUE(read_safetensors_table(bytes, table, problem)) << problem.message;
  PolicyFacts facts;
  facts.squash = true;  // as `policy_kwargs` says with use_sde
  const auto network = make_actor(table, facts, {}, problem);
  ASSERT_TRUE(network.has_value()) << problem.message;
  EXPECT_EQ(network->action_kind(), ActionKind::squashed);
  EXPECT_EQ(network->layers.back().activation, Activation::tanh);
}

TEST(Torch, StatisticsOfEarlyVersionsHaveSets) {
  PolicyProblem problem;
  for (const char* module : {"__builtin__", "builtins"}) {
    const std::string bytes = fmt::format(
        "\x80\x02"
        "c{}\nset\n]\x85R.",
        module);
    EXPECT_TRUE(read_pickle(bytes, PickleNames::statistics, problem).has_value())
        << problem.message;
    EXPECT_FALSE(read_pickle(bytes, PickleNames::tensors, problem).has_value());
  }
}

}  // namespace
}  // namespace eagerx::gen

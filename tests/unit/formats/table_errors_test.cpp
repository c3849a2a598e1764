// Weight files that lie, and pickles that want to run: one error each, that names the culprit.
#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "generator/policy/formats/actor/actor.hpp"
#include "generator/policy/formats/tensors/containers.hpp"
#include "tests/unit/formats/onnx_builder.hpp"
#include "tests/unit/formats/table_builder.hpp"

namespace eagerx::gen {
namespace {

using test::add_linear;
using test::expect_problem;
using test::NamedValues;
using test::read_bad;
using test::read_good;
using test::safetensors;
using testing::HasSubstr;

std::vector<NamedValues> sac() {
  std::vector<NamedValues> tensors;
  add_linear(tensors, "actor.latent_pi.0", 3, 4);
  add_linear(tensors, "actor.latent_pi.2", 4, 4);
  add_linear(tensors, "actor.mu", 4, 1);
  return tensors;
}

TEST(TableErrors, TheSmallActorIsRead) {
  const Network network = read_good(safetensors(sac()));
  EXPECT_EQ(network.layers.size(), 3U);
  EXPECT_EQ(network.action_kind(), ActionKind::squashed);
}

TEST(TableErrors, ArraysThatAreNotNumPys) {
  const std::string numpy = "\x93NUMPY\x01" + std::string(1, '\0');
  const std::string header = "{'descr': '<f4', 'fortran_order': False, 'shape': (1,), }";
  const auto npz = [](const std::string& array) { return test::zip({{"w1.npy", array}}); };
  expect_problem(read_bad(npz("neither this nor that")), "E0630",
                 "`w1` that is not NumPy's format");
  expect_problem(read_bad(npz(numpy + "\xff\xff" + header)), "E0630", "`w1` that ends early");
  expect_problem(
      read_bad(npz(numpy + test::little(header.size(), 2) + std::string(header.size(), '{'))),
      "E0630", "`w1` whose header cannot be read");
}

TEST(TableErrors, ShapeAgainstData) {
  auto tensors = sac();
  tensors[0].shape = {4, 4};
  expect_problem(read_bad(safetensors(tensors)), "E0614",
                 "`actor.latent_pi.0.weight` of shape [4, 4]");
}

TEST(TableErrors, HugeDimensions) {
  auto tensors = sac();
  tensors[0].shape = {2147483647, 2147483647};
  expect_problem(read_bad(safetensors(tensors)), "E0614", "`actor.latent_pi.0.weight`");
}

TEST(TableErrors, NanWeights) {
  auto tensors = sac();
  tensors[0].values[5] = std::numeric_limits<float>::quiet_NaN();
  expect_problem(read_bad(safetensors(tensors)), "E0616",
                 "NaN in tensor `actor.latent_pi.0.weight`");
}

TEST(TableErrors, MissingTensors) {
  auto tensors = sac();
  tensors.erase(tensors.begin() + 4);
  expect_problem(read_bad(safetensors(tensors)), "E0624", "`actor.mu.weight`");
  tensors = sac();
  tensors.erase(tensors.begin() + 3);
  expect_problem(read_bad(safetensors(tensors)), "E0624", "`actor.latent_pi.2.bias`");
  tensors.clear();
  add_linear(tensors, "actor.latent_pi.0", 3, 4);
  add_linear(tensors, "actor.latent_pi.4", 4, 4);
  add_linear(tensors, "actor.mu", 4, 1);
  expect_problem(read_bad(safetensors(tensors)), "E0624", "`actor.latent_pi.2.weight`");
}

TEST(TableErrors, BoundsOfActionsThatAreTurnedRound) {
  std::vector<NamedValues> tensors;  // CleanRL's TD3
  add_linear(tensors, "fc1", 3, 4);
  add_linear(tensors, "fc2", 4, 4);
  add_linear(tensors, "fc_mu", 4, 1);
  tensors.push_back({"action_scale", {1}, {2.0F}});
  tensors.push_back({"action_bias", {1}, {0.0F}});
  EXPECT_EQ(read_good(safetensors(tensors)).contract.action_low, (std::vector<double>{-2.0}));
  tensors[tensors.size() - 2].values[0] = -2.0F;
  expect_problem(read_bad(safetensors(tensors)), "E0626", "`action_scale` below zero");
}

TEST(TableErrors, TwoActors) {
  auto tensors = sac();
  add_linear(tensors, "mlp_extractor.policy_net.0", 3, 4);
  add_linear(tensors, "action_net", 4, 1);
  expect_problem(read_bad(safetensors(tensors)), "E0625",
                 "two actors: Stable-Baselines3's SAC and");
  tensors.clear();
  add_linear(tensors, "first.0", 3, 1);
  add_linear(tensors, "second.0", 3, 1);
  expect_problem(read_bad(safetensors(tensors)), "E0625", "`first.…` and `second.…`");
}

std::optional<Network> read_actor(const std::string& bytes, const char* actor,
                                  Diagnostics& diagnostics) {
  ReadContext context;
  context.actor = actor;
  context.output_activation = Activation::identity;
  return read_policy_bytes(bytes, "policy.pt", {}, diagnostics, context);
}

TEST(TableErrors, OneOfSeveralActorsMayBeSaid) {
  std::vector<NamedValues> tensors;
  add_linear(tensors, "first.0", 3, 1);
  add_linear(tensors, "agents.second.actor.0", 3, 2);
  tensors.push_back({"agents.second.std", {1}, {1.0F}});
  const std::string bytes = safetensors(tensors);
  expect_problem(read_bad(bytes), "E0625", "two actors");
  Diagnostics diagnostics;
  EXPECT_EQ(read_actor(bytes, "first", diagnostics)->outputs(), 1U);
  const auto second = read_actor(bytes, "agents.second", diagnostics);
  ASSERT_TRUE(second.has_value());
  EXPECT_EQ(second->outputs(), 2U);
  EXPECT_THAT(second->format, HasSubstr("rsl_rl")) << "its names are those behind the prefix";
  EXPECT_TRUE(diagnostics.all().empty());
  EXPECT_FALSE(read_actor(bytes, "third", diagnostics).has_value());
  expect_problem(diagnostics.all().back(), "E0625", "begins with `third.`; its first one is `agen");
  EXPECT_FALSE(read_actor(test::two_layers().bytes(), "first", diagnostics).has_value());
  expect_problem(diagnostics.all().back(), "E0625", "not a table of tensors");
}

TEST(TableErrors, OneTensorOfArsIsItsOldLinearPolicy) {
  const std::string bytes = safetensors({{"action_net.weight", {1, 2}, {1, 2}}});
  expect_problem(read_bad(bytes), "E0750", "what follows its last layer");
  TensorTable table;
  PolicyProblem problem;
  ASSERT_TRUE(read_safetensors_table(bytes, table, problem));
  PolicyFacts facts;
  facts.format = "Stable-Baselines3 1.3.0";
  facts.contract.algorithm = "ARS";
  facts.squash = true;  // of the class ARSPolicy, whose name the LinearPolicy's has in it
  const auto network = make_actor(table, facts, {}, problem);
  ASSERT_TRUE(network.has_value()) << problem.message;
  EXPECT_EQ(network->action_kind(), ActionKind::raw);
  EXPECT_EQ(network->layers.back().activation, Activation::identity);
}

TEST(TableErrors, RlGamesMayScaleItsActions) {
  std::vector<NamedValues> tensors;
  add_linear(tensors, "a2c_network.actor_mlp.0", 2, 3);
  add_linear(tensors, "a2c_network.mu", 3, 1);
  const Network network = read_good(safetensors(tensors, R"("activation":"elu")"));
  EXPECT_FALSE(network.action.has_value()) << "the graph may say `output: squashed`";
  EXPECT_EQ(network.action_kind(), ActionKind::raw);
  EXPECT_THAT(network.assumed, testing::Contains(HasSubstr("`clip_actions`")));
}

TEST(TableErrors, NoActor) {
  std::vector<NamedValues> tensors;
  add_linear(tensors, "embedding", 3, 4);
  expect_problem(read_bad(safetensors(tensors)), "E0624", "no actor among its 2 tensors");
}

TEST(TableErrors, LayersThatDoNotFitTogether) {
  auto tensors = sac();
  tensors[2] = {"actor.latent_pi.2.weight", {4, 5}, std::vector<float>(20, 1.0F)};
  expect_problem(read_bad(safetensors(tensors)), "E0618", "multiplies 4 values");
}

TEST(TableErrors, DescriptionAgainstTensors) {
  expect_problem(read_bad(safetensors(sac(), R"("algo":"PPO")")), "E0626", "of PPO");
  expect_problem(read_bad(safetensors(sac(), R"("obs":"a,b")")), "E0626", "takes 2 numbers");
  expect_problem(read_bad(safetensors(sac(), R"x("obs":"a (2),b (2)")x")), "E0626",
                 "takes 4 numbers");
  for (const char* obs : {"a (0),b", "a (x),b", "a (2", "a (99999999999999999999)"}) {
    expect_problem(read_bad(safetensors(sac(), fmt::format(R"x("obs":"{}")x", obs))), "E0626",
                   "makes no sense");
  }
  expect_problem(read_bad(safetensors(sac(), R"("clip_obs":"-1")")), "E0626", "`clip_obs: -1`");
  expect_problem(read_bad(safetensors(sac(), R"("activation":"snake")")), "E0626",
                 "`activation: snake`");
}

TEST(TableErrors, ObservationsMayHaveSizes) {
  const Network network = read_good(safetensors(sac(), R"x("obs":"angle (2), speed")x"));
  const auto& parts = network.contract.observations;
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].name, "angle");
  EXPECT_EQ(parts[0].size, 2U);
  EXPECT_EQ(parts[1].size, 1U);
}

TEST(TableErrors, UnstatedActivation) {
  std::vector<NamedValues> tensors;
  add_linear(tensors, "actor.0", 3, 4);
  add_linear(tensors, "actor.2", 4, 1);
  expect_problem(read_bad(safetensors(tensors)), "E0629", "which activation");
  const Network network =
      read_good(safetensors(tensors, R"("activation":"elu","output_activation":"none")"));
  EXPECT_EQ(network.layers[0].activation, Activation::elu);
  EXPECT_EQ(network.layers[0].slope, 1.0F);
  EXPECT_EQ(network.layers[1].activation, Activation::identity);
}

TEST(TableErrors, FeaturesExtractor) {
  auto tensors = sac();
  add_linear(tensors, "actor.features_extractor.cnn.0", 3, 3);
  expect_problem(read_bad(safetensors(tensors)), "E0628", "`actor.features_extractor.cnn`");
  tensors = sac();
  add_linear(tensors, "actor.features_extractor.mine", 3, 3);
  expect_problem(read_bad(safetensors(tensors)), "E0628", "`actor.features_extractor.mine.bias`");
}

TEST(TableErrors, LayerNormBetweenLinearAndActivation) {
  std::vector<NamedValues> tensors;
  add_linear(tensors, "net.0", 3, 4);
  tensors.push_back({"net.1.weight", {4}, {1, 2, 3, 4}});
  tensors.push_back({"net.1.bias", {4}, {0, 0, 0, 1}});
  add_linear(tensors, "net.3", 4, 1);
  const Network network =
      read_good(safetensors(tensors, R"("activation":"relu","output_activation":"none")"));
  ASSERT_EQ(network.layers.size(), 2U);
  ASSERT_TRUE(network.layers[0].norm.has_value());
  EXPECT_THAT(network.layers[0].norm->gamma, testing::ElementsAre(1, 2, 3, 4));
  EXPECT_EQ(network.layers[0].activation, Activation::relu);
}

TEST(TableErrors, DqnChoosesByNumber) {
  std::vector<NamedValues> tensors;
  add_linear(tensors, "q_net.q_net.0", 3, 4);
  add_linear(tensors, "q_net.q_net.2", 4, 5);
  add_linear(tensors, "q_net_target.q_net.0", 3, 4);
  add_linear(tensors, "q_net_target.q_net.2", 4, 5);
  EXPECT_EQ(read_good(safetensors(tensors)).action_kind(), ActionKind::argmax);
}

TEST(Pickle, CodeIsRefusedByName) {
  std::string bytes = "\x80\x02";
  bytes += "cos\nsystem\n";
  bytes += std::string("X\x04\0\0\0true\x85R.", 12);
  const Diagnostic diagnostic = read_bad(test::zip({{"archive/data.pkl", bytes}}));
  expect_problem(diagnostic, "E0622", "imports `os.system`");
  EXPECT_THAT(diagnostic.help.text, HasSubstr("it was not run"));
  // The same by protocol 4's way.
  bytes = std::string("\x80\x04\x8c\x08") + "builtins" + "\x8c\x04" + "eval" + "\x93" + ".";
  expect_problem(read_bad(test::zip({{"archive/data.pkl", bytes}})), "E0622",
                 "imports `builtins.eval`");
}

TEST(Pickle, DamageIsRefused) {
  expect_problem(read_bad(test::zip({{"a/data.pkl", "\x80\x02"}})), "E0623", "ends early");
  expect_problem(read_bad(test::zip({{"a/data.pkl", "\x80\x02u."}})), "E0623", "is damaged");
  expect_problem(read_bad(test::zip({{"a/data.pkl", "\x80\x02i."}})), "E0623", "instruction 0x69");
  expect_problem(read_bad(test::zip({{"a/data.pkl", "\x80\x02}."}})), "E0624", "no actor");
}

TEST(Archive, DamageIsRefused) {
  std::string bytes = test::zip({{"a/data.pkl", "\x80\x02}."}});
  bytes[bytes.find("}.")] = ']';
  expect_problem(read_bad(bytes), "E0621", "checksum");
  expect_problem(read_bad(test::zip({{"a/data.pkl", "x"}, {"a/data.pkl", "y"}})), "E0621",
                 "two entries");
  expect_problem(read_bad(test::zip({{"policy.pth", test::zip({{"a/data.pkl", "\x80\x02}."}})}})),
                 "E0621", "`data` is missing");
}

TEST(TableErrors, UnreadTensorsMayBePartOfTheFunction) {
  for (const char* name :
       {"encoder.0.weight", "actor.latent_pi.0.weight_g", "obs_mean", "actor.layer_norm.weight"}) {
    auto tensors = sac();
    tensors.push_back({name, {1}, {1.0F}});
    expect_problem(read_bad(safetensors(tensors)), "E0628", name);
  }
  for (const char* name : {"critic.qf0.0.weight", "actor.log_std.weight", "actor_target.mu.weight",
                           "log_std", "std", "rate"}) {
    auto tensors = sac();
    tensors.push_back({name, {1}, {1.0F}});
    EXPECT_EQ(read_good(safetensors(tensors)).ignored.size(), 1U) << name;
  }
}

TEST(TableErrors, ModuleListsDoNotSayWhatStandsBetween) {
  std::vector<NamedValues> tensors;
  add_linear(tensors, "layers.0", 3, 4);
  add_linear(tensors, "layers.1", 4, 1);
  expect_problem(read_bad(safetensors(tensors, R"("activation":"relu")")), "E0628",
                 "nothing between the layers `layers.0` and `layers.1`");
}

TEST(TableErrors, CriticsAreNoActors) {
  std::vector<NamedValues> tensors;
  add_linear(tensors, "critic.qf0.0", 3, 4);
  add_linear(tensors, "critic.qf0.2", 4, 1);
  const std::string relu = R"("activation":"relu","output_activation":"none")";
  expect_problem(read_bad(safetensors(tensors, relu)), "E0624",
                 "a critic (`critic.qf0.…`) and no actor");
  add_linear(tensors, "net.0", 3, 2);
  EXPECT_EQ(read_good(safetensors(tensors, relu)).outputs(), 2U) << "the one that is none";
}

TEST(TableErrors, NormsWithoutABiasMayBeOfTwoKinds) {
  std::vector<NamedValues> tensors;
  add_linear(tensors, "net.0", 3, 4);
  tensors.push_back({"net.1.weight", {4}, {1, 1, 1, 1}});
  add_linear(tensors, "net.3", 4, 1);
  expect_problem(read_bad(safetensors(tensors, R"("activation":"relu")")), "E0628",
                 "an RMSNorm: `net.1");
}

TEST(TableErrors, NamesLikeThoseOfArsAreNotItsZip) {
  std::vector<NamedValues> tensors;
  add_linear(tensors, "action_net.0", 3, 1);
  expect_problem(read_bad(safetensors(tensors)), "E0750", "what follows its last layer");
  EXPECT_EQ(read_good(safetensors(tensors, R"("squash":"false")")).action_kind(), ActionKind::raw);
  EXPECT_EQ(read_good(safetensors(tensors, R"("output_activation":"tanh")")).action_kind(),
            ActionKind::squashed);
  expect_problem(read_bad(safetensors(tensors, R"("output_activation":"snake")")), "E0626",
                 "`output_activation: snake`");
}

TEST(TableErrors, NothingIsAssumedAfterTheLastLayer) {
  for (const char* base : {"net.0", "actor.0", "actor_mean.0", "actor.mu.0"}) {
    std::vector<NamedValues> tensors;
    add_linear(tensors, base, 3, 1);
    expect_problem(read_bad(safetensors(tensors)), "E0750", "what follows its last layer");
    const Network none = read_good(safetensors(tensors, R"("output_activation":"none")"));
    EXPECT_EQ(none.layers.back().activation, Activation::identity) << base;
    EXPECT_FALSE(none.action.has_value()) << "the file does not say what becomes of its output";
    EXPECT_THAT(none.format, HasSubstr("a torch ")) << "and not who made it: " << base;
    const Network tanh = read_good(safetensors(tensors, R"("output_activation":"tanh")"));
    EXPECT_EQ(tanh.layers.back().activation, Activation::tanh) << base;
    EXPECT_EQ(tanh.action_kind(), ActionKind::squashed) << base;
  }
}

TEST(TableErrors, LibrariesAreNamedByTheirMarks) {
  const auto network = [](const char* base, const char* mark, const char* notes) {
    std::vector<NamedValues> tensors;
    add_linear(tensors, base, 3, 1);
    tensors.push_back({mark, {1}, {1.0F}});
    return read_good(safetensors(tensors, notes));
  };
  for (const char* mark : {"std", "log_std"}) {
    const Network usual = network("actor.0", mark, "");
    EXPECT_THAT(usual.format, HasSubstr("rsl_rl"));
    EXPECT_THAT(usual.assumed, testing::ElementsAre(HasSubstr("nothing after the last layer")));
    const Network given = network("actor.0", mark, R"("output_activation":"tanh")");
    EXPECT_EQ(given.action_kind(), ActionKind::squashed) << "the library leaves the choice";
    EXPECT_TRUE(given.assumed.empty());
  }
  EXPECT_THAT(network("actor_mean.0", "actor_logstd", "").format, HasSubstr("CleanRL's PPO"));
  std::vector<NamedValues> tensors;
  add_linear(tensors, "actor.mu.0", 3, 1);
  add_linear(tensors, "critic.qf0.0", 3, 1);
  EXPECT_EQ(read_good(safetensors(tensors)).action_kind(), ActionKind::squashed);
  expect_problem(read_bad(safetensors(tensors, R"("output_activation":"none")")), "E0626",
                 "after whose last layer comes tanh, but the graph says nothing");
}

}  // namespace
}  // namespace eagerx::gen

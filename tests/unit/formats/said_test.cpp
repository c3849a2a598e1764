// Facts that the graph gives because the file does not contain them: sizes of inputs, the order of
// layers (tests/data/policy/make_inputs.py). Compares with torch.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/policy/formats/golden.hpp"
#include "generator/policy/formats/read.hpp"
#include "generator/policy/network/evaluate.hpp"
#include "tests/unit/formats/table_builder.hpp"

namespace eagerx::gen {
namespace {

using testing::HasSubstr;

constexpr const char* kData = EAGERX_SOURCE_DIR "/tests/data/policy/";

std::optional<Network> read_said(const std::string& file, const ReadContext& context,
                                 Diagnostics& diagnostics) {
  PolicyRequest request;
  request.path = kData + file;
  request.name = file;
  request.context = context;
  return read_policy(request, diagnostics);
}

void expect_torchs_answers(const std::string& file, const std::string& golden,
                           const ReadContext& context = {}) {
  Diagnostics diagnostics;
  const auto network = read_said(file, context, diagnostics);
  const auto rows = read_golden(kData + golden, golden, {}, diagnostics);
  const auto result =
      network && rows ? compare(*network, *rows, golden, {}, diagnostics) : std::nullopt;
  for (const auto& problem : diagnostics.all()) ADD_FAILURE() << file << ": " << problem.message;
  EXPECT_TRUE(result && result->passed()) << file;
}

void expect_said_refused(const std::string& file, const ReadContext& context, const char* code,
                         const char* message, const char* help) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read_said(file, context, diagnostics).has_value()) << file;
  ASSERT_FALSE(diagnostics.all().empty());
  EXPECT_EQ(diagnostics.all().front().code, code);
  EXPECT_THAT(diagnostics.all().front().message, HasSubstr(message));
  EXPECT_THAT(diagnostics.all().front().help.text, HasSubstr(help));
}

ReadContext with_sizes(std::vector<std::int64_t> sizes) {
  ReadContext context;
  context.input_sizes = std::move(sizes);
  return context;
}
ReadContext with_layers(std::vector<std::string> layers) {
  ReadContext context;
  context.layers = std::move(layers);
  return context;
}

TEST(SaidSizes, AreSolvedForWhereTheLayersTellThem) {
  expect_torchs_answers("torchscript/encoded_scripted.pt", "torchscript/encoded_golden.npz");
  Diagnostics diagnostics;
  const auto network = read_said("torchscript/encoded_scripted.pt", {}, diagnostics);
  ASSERT_TRUE(network.has_value());
  EXPECT_EQ(network->contract.observations.at(0).size, 27U);
  EXPECT_EQ(network->contract.observations.at(1).size, 12U);
  EXPECT_TRUE(network->assumed.empty());
}

TEST(SaidSizes, AreAskedForWhereSeveralFit) {
  const char* file = "torchscript/joined_scripted.pt";
  expect_said_refused(file, {}, "E0755", "`command` and `obs` could have", "input_sizes: […, …]");
  expect_torchs_answers(file, "torchscript/joined_golden.npz", with_sizes({3, 7}));
  Diagnostics diagnostics;
  const auto network = read_said(file, with_sizes({3, 7}), diagnostics);
  ASSERT_TRUE(network.has_value());
  EXPECT_EQ(network->contract.observations.at(1).size, 7U);
}

TEST(SaidSizes, ThatDoNotFitAreRefused) {
  const char* file = "torchscript/joined_scripted.pt";
  expect_said_refused(file, with_sizes({3, 8}), "E0618", "multiplies 11 values", "`input_sizes`");
  expect_said_refused(file, with_sizes({10}), "E0755", "takes 2 inputs, not 1: `command`, `obs`",
                      "one size for each");
  expect_said_refused("libraries/named_trunk.pth", with_sizes({4}), "E0626", "is not TorchScript",
                      "leave the graph's `input_sizes` out");
}

TEST(Frozen, TensorsAreConstantsOfTheCode) {
  for (const char* way : {"scripted", "traced", "inference"}) {
    expect_torchs_answers(std::string("torchscript/frozen_") + way + ".pt",
                          "torchscript/frozen_golden.npz");
  }
}

TEST(SaidLayers, AreAskedForInTheOrderOfTheirSizes) {
  expect_said_refused("libraries/named_trunk.pth", {}, "E0629", "`net.0`, `net.2`, `mean_head`",
                      "layers: [net.0, net.2, mean_head], activation: relu");
  expect_said_refused("libraries/named_norms.pth", {}, "E0629", "`bn1`, `fc1`, `fc2`, `out`",
                      "--layers bn1,fc1,fc2,out");
}

TEST(SaidLayers, AreFollowedByOneActivationOrTheirOwn) {
  ReadContext trunk = with_layers({"net.0", "net.2", "mean_head"});
  trunk.activation = Activation::elu;
  trunk.output_activation = Activation::tanh;
  const char* golden = "libraries/named_trunk_golden.npz";
  expect_torchs_answers("libraries/named_trunk.pth", golden, trunk);
  expect_torchs_answers("libraries/named_trunk.pth", golden,
                        with_layers({"net.0", "elu", "net.2", "elu", "mean_head", "tanh"}));
  expect_torchs_answers("libraries/named_norms.pth", "libraries/named_norms_golden.npz",
                        with_layers({"bn1", "fc1", "relu", "fc2", "elu", "out"}));
}

/// Dense layers of these names and sizes, of three inputs.
std::string layers_called(const std::vector<std::string>& names, const std::vector<int>& outputs) {
  std::vector<test::NamedValues> table;
  int inputs = 3;
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::vector<float> weights;
    for (int k = 0; k < inputs * outputs[i]; ++k) weights.push_back(0.125F * static_cast<float>(k));
    table.push_back({names[i] + ".weight", {outputs[i], inputs}, weights});
    table.push_back({names[i] + ".bias", {outputs[i]}, std::vector<float>(outputs[i], 0.5F)});
    inputs = outputs[i];
  }
  return test::safetensors(table);
}

/// Names of tianshou's MLP and Net, and of actors that people write themselves.
TEST(SaidLayers, HaveTheNamesOfAnyLibrary) {
  const std::vector<std::vector<std::string>> all = {
      {"preprocess.model.model.0", "preprocess.model.model.2", "last.model.0"},
      {"fc1", "fc2", "mu"},
      {"net.0", "net.2", "mean_head"}};
  for (const std::vector<std::string>& names : all) {
    const std::string bytes = layers_called(names, {5, 4, 2});
    Diagnostics asked;
    EXPECT_FALSE(read_policy_bytes(bytes, "p", {}, asked));
    EXPECT_EQ(asked.all().front().code, "E0629");
    const std::string listed = names[0] + ", " + names[1] + ", " + names[2];
    EXPECT_THAT(asked.all().front().help.text, HasSubstr("layers: [" + listed + "]"));
    ReadContext context = with_layers(names);
    context.activation = Activation::relu;
    context.output_activation = Activation::identity;
    Diagnostics diagnostics;
    const auto network = read_policy_bytes(bytes, "p", {}, diagnostics, context);
    for (const auto& problem : diagnostics.all()) ADD_FAILURE() << problem.message;
    ASSERT_TRUE(network.has_value()) << listed;
    EXPECT_EQ(network->layers.size(), 3U);
    EXPECT_EQ(network->layers[1].activation, Activation::relu);
  }
}

TEST(SaidLayers, ThatAreNotThereAreRefused) {
  const char* file = "libraries/named_trunk.pth";
  expect_said_refused(file, with_layers({"net.0", "net.1"}), "E0624",
                      "no layer `net.1`: its layers are `mean_head`, `net.0`, `net.2`", "");
  expect_said_refused(file, with_layers({"relu", "net.0"}), "E0624", "no layer `relu`", "");
  expect_said_refused(file, with_layers({"net.2", "mean_head"}), "E0629", "which activation", "");
  ReadContext twice = with_layers({"net.0", "elu", "net.2", "elu", "mean_head"});
  twice.output_activation = Activation::tanh;
  expect_said_refused(file, twice, "E0626", "another activation", "leave `output_activation` out");
  expect_said_refused("ppo_64.onnx", with_layers({"net.0"}), "E0626", "is not a table of tensors",
                      "leave the graph's `layers` out");
  expect_said_refused("torchscript/joined_scripted.pt", with_layers({"actor"}), "E0626",
                      "is TorchScript", "leave the graph's `layers` out");
}

/// rsl_rl's MLP with `state_dependent_std`: the last layer gives [2, actions], row by row, and
/// `deterministic_output` is the first row (rsl_rl 5.4, modules/distribution.py). Names are those
/// of rsl_rl 3 (`actor.`) and from 4 on (`mlp.`). `rows` of the last layer are in the file.
std::string means_and_deviations(const std::string& prefix, int rows) {
  const std::vector<float> first = {0.5F, -1.0F, 0.25F, 2.0F, 1.0F, -0.5F};  // [3, 2]
  const std::vector<float> last = {1.0F, 2.0F, 3.0F, -1.0F, 0.5F, 0.25F,     // means
                                   9.0F, 9.0F, 9.0F, 8.0F,  8.0F, 8.0F};     // deviations
  const std::vector<float> bias = {0.125F, -0.5F, 7.0F, 6.0F};
  const auto begin = [rows](const std::vector<float>& all, int width) {
    return std::vector<float>(all.begin(), all.begin() + std::ptrdiff_t{rows} * width);
  };
  return test::safetensors({{prefix + "0.weight", {3, 2}, first},
                            {prefix + "0.bias", {3}, {0.0F, 0.5F, -0.25F}},
                            {prefix + "2.weight", {rows, 3}, begin(last, 3)},
                            {prefix + "2.bias", {rows}, begin(bias, 1)}});
}

TEST(SaidDeviations, AreLeftOut) {
  ReadContext context;
  context.activation = Activation::relu;
  context.output_activation = Activation::identity;
  for (const char* prefix : {"actor.", "mlp."}) {
    Diagnostics diagnostics;
    context.state_dependent_std = true;
    const auto means =
        read_policy_bytes(means_and_deviations(prefix, 4), "p", {}, diagnostics, context);
    EXPECT_FALSE(read_policy_bytes(means_and_deviations(prefix, 3), "p", {}, diagnostics, context));
    EXPECT_EQ(diagnostics.all().back().code, "E0626");
    EXPECT_THAT(diagnostics.all().back().message, HasSubstr("gives 3 numbers"));
    context.state_dependent_std = false;
    const auto all =
        read_policy_bytes(means_and_deviations(prefix, 4), "p", {}, diagnostics, context);
    ASSERT_TRUE(means && all) << prefix;
    EXPECT_EQ(all->outputs(), 4U);
    // hidden = relu([x0 / 2 - x1, x0 / 4 + 2 x1 + 0.5, x0 - x1 / 2 - 0.25]) = [1.5, 0, 2]
    EXPECT_THAT(evaluate(*means, {2.0F, -0.5F}), testing::ElementsAre(7.625F, -1.5F));
    EXPECT_THAT(evaluate(*all, {2.0F, -0.5F}), testing::ElementsAre(7.625F, -1.5F, 38.5F, 34.0F));
  }
}

}  // namespace
}  // namespace eagerx::gen

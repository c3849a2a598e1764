// Policies that torch exported, recurrent and convolutional: the answers that torch gave in
// float64, sequence by sequence (tests/data/policy/make_architectures.py).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "generator/policy/formats/golden.hpp"
#include "generator/policy/formats/read.hpp"
#include "generator/policy/network/evaluate.hpp"
#include "tests/unit/formats/onnx_builder.hpp"
#include "tests/unit/formats/table_builder.hpp"

namespace eagerx::gen {
namespace {

using testing::HasSubstr;

constexpr const char* kArchitectures = EAGERX_SOURCE_DIR "/tests/data/policy/architectures/";

Network read_architecture(const std::string& file) {
  Diagnostics diagnostics;
  PolicyRequest request;
  request.path = kArchitectures + file;
  request.name = file;
  if (file.ends_with(".npz")) request.context.output_activation = Activation::identity;
  const auto network = read_policy(request, diagnostics);
  for (const auto& problem : diagnostics.all()) ADD_FAILURE() << file << ": " << problem.message;
  return network.value();
}

/// Rows whose answers all have at most twice torch's error, or two roundings.
std::size_t answered(const std::string& file) {
  Diagnostics diagnostics;
  const std::string name = file.substr(0, file.find('.')) + "_golden.npz";
  const auto rows = read_golden(kArchitectures + name, name, {}, diagnostics);
  const auto result = rows ? compare(read_architecture(file), *rows, name, {}, diagnostics)
                           : std::optional<GoldenResult>();
  for (const auto& problem : diagnostics.all()) ADD_FAILURE() << problem.message;
  return result && result->passed() ? result->rows : 0;
}

TEST(Architectures, AnswerAsTorchDoes) {
  for (const char* file : {"gru.onnx", "lstm.onnx", "frames.onnx", "image.onnx", "scaled.onnx",
                           "recurrent_ppo.zip", "gru_state_dict.npz"}) {
    EXPECT_EQ(answered(file), 60U) << file;
  }
}

TEST(Architectures, ValuesMayBeInAFileNextToTheOnnxFile) {
  Diagnostics diagnostics;
  const auto rows =
      read_golden(std::string(kArchitectures) + "scaled_golden.npz", "rows", {}, diagnostics);
  ASSERT_TRUE(rows.has_value());
  EXPECT_TRUE(compare(read_architecture("external.onnx"), *rows, "rows", {}, diagnostics));
  std::ifstream file(std::string(kArchitectures) + "external.onnx", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  EXPECT_FALSE(read_policy_bytes(bytes, "external.onnx", {}, diagnostics).has_value());
  EXPECT_EQ(diagnostics.all().back().code, "E0617");
  EXPECT_THAT(diagnostics.all().back().message, HasSubstr("`external.onnx.data`, which is not"));
}

TEST(Architectures, LayersAreThoseOfTheFile) {
  const Network gru = read_architecture("gru.onnx");
  ASSERT_EQ(gru.layers.size(), 2U);
  EXPECT_TRUE(gru.has_memory());
  EXPECT_EQ(gru.layers[0].remembers(), 8U);
  EXPECT_TRUE(gru.ignored.empty());
  const Network lstm = read_architecture("lstm.onnx");
  ASSERT_EQ(lstm.layers.size(), 4U);
  EXPECT_EQ(lstm.layers[1].remembers(), 16U);
  EXPECT_EQ(lstm.layers[2].remembers(), 16U);
  const Network image = read_architecture("image.onnx");
  EXPECT_EQ(image.input_shape, (std::vector<std::uint32_t>{1, 12, 12}));
  EXPECT_EQ(std::get<Convolution>(image.layers[3].form).groups, 2U);
  EXPECT_EQ(std::get<Pooling>(image.layers[4].form).kind, Pooling::Kind::average_with_padding);
  const Network scaled = read_architecture("scaled.onnx");
  std::size_t norms = 0;
  for (const Layer& layer : scaled.layers) norms += layer.norm ? 1U : 0U;
  EXPECT_EQ(norms, 2U);
  EXPECT_EQ(scaled.layers[4].activation, Activation::gelu);
}

TEST(Architectures, MemoryBeginsWithTheEpisode) {
  const Network network = read_architecture("gru.onnx");
  const std::vector<float> observation = {0.5F, -1.0F, 2.0F};
  Memory<float> memory;
  const auto first = evaluate(network, observation, &memory);
  const auto second = evaluate(network, observation, &memory);
  EXPECT_NE(first, second);
  EXPECT_EQ(evaluate(network, observation), first);
  memory.clear();
  EXPECT_EQ(evaluate(network, observation, &memory), first);
}

/// A file, changed: the bytes of its model.
onnx::ModelProto model_of(const char* file) {
  std::ifstream stream(std::string(kArchitectures) + file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  onnx::ModelProto model;
  EXPECT_TRUE(model.ParseFromString(bytes));
  return model;
}

void expect_refusal(const onnx::ModelProto& model, const char* code, const char* text) {
  const Diagnostic diagnostic = test::read_bad(model.SerializeAsString());
  EXPECT_EQ(diagnostic.code, code) << diagnostic.message;
  EXPECT_THAT(diagnostic.message, HasSubstr(text));
}

onnx::NodeProto& node_of(onnx::ModelProto& model, const char* type) {
  for (onnx::NodeProto& node : *model.mutable_graph()->mutable_node()) {
    if (node.op_type() == type) return node;
  }
  ADD_FAILURE() << "no " << type;
  return *model.mutable_graph()->mutable_node(0);
}

TEST(Architectures, AStateThatDoesNotComeBackIsRefused) {
  onnx::ModelProto model = model_of("gru.onnx");
  model.mutable_graph()->mutable_output()->RemoveLast();
  expect_refusal(model, "E0641", "takes a state as input `h`");
  model = model_of("lstm.onnx");
  auto& outputs = *model.mutable_graph()->mutable_output();
  outputs.SwapElements(1, 2);  // the order of outputs does not matter
  test::read_good(model.SerializeAsString());
  onnx::NodeProto* last = nullptr;  // the layers of the new state the other way round
  for (onnx::NodeProto& node : *model.mutable_graph()->mutable_node()) {
    if (node.op_type() == "Concat") last = &node;
  }
  ASSERT_NE(last, nullptr);
  last->mutable_input()->SwapElements(0, 1);
  expect_refusal(model, "E0641", "takes a state as input `c`");
}

/// ML-Agents' Hallway: `obs_0`, `obs_1` and a memory.
TEST(Architectures, ASecondObservationNextToAMemoryIsNamed) {
  onnx::ModelProto model = model_of("gru.onnx");
  onnx::GraphProto& graph = *model.mutable_graph();
  onnx::ValueInfoProto& input = *graph.add_input();
  input.set_name("obs_1");
  onnx::TypeProto::Tensor& type = *input.mutable_type()->mutable_tensor_type();
  type.set_elem_type(onnx::TensorProto::FLOAT);
  for (const std::int64_t dim : {1, 1}) type.mutable_shape()->add_dim()->set_dim_value(dim);
  const std::string action = graph.output(0).name();
  for (onnx::NodeProto& node : *graph.mutable_node()) {
    for (std::string& output : *node.mutable_output()) {
      if (output == action) output = "before";
    }
  }
  onnx::NodeProto& sum = *graph.add_node();
  sum.set_op_type("Add");
  for (const char* name : {"before", "obs_1"}) sum.add_input(name);
  sum.add_output(action);
  expect_refusal(model, "E0608", "has a memory and several observations: `obs_1`");
}

TEST(Architectures, AStateThatIsAlwaysZeroIsRefused) {
  onnx::ModelProto model = model_of("gru.onnx");
  node_of(model, "GRU").set_input(5, "");
  expect_refusal(model, "E0640", "starts from zeros at every observation");
  auto& shape = *model.mutable_graph()
                     ->mutable_input(0)
                     ->mutable_type()
                     ->mutable_tensor_type()
                     ->mutable_shape();
  shape.mutable_dim(0)->set_dim_param("time");
  shape.mutable_dim(1)->set_dim_param("batch");
  EXPECT_TRUE(test::read_good(model.SerializeAsString()).has_memory());
}

TEST(Architectures, UnusualCellsAreRefused) {
  onnx::ModelProto model = model_of("gru.onnx");
  for (onnx::AttributeProto& attribute : *node_of(model, "GRU").mutable_attribute()) {
    if (attribute.name() == "linear_before_reset") attribute.set_i(0);
  }
  expect_refusal(model, "E0613", "linear_before_reset");
  model = model_of("gru.onnx");
  onnx::AttributeProto& direction = *node_of(model, "GRU").add_attribute();
  direction.set_name("direction");
  direction.set_s("reverse");
  expect_refusal(model, "E0613", "does not run forward");
}

TEST(Architectures, WeightsThatDoNotFitAreRefused) {
  onnx::ModelProto model = model_of("gru.onnx");
  node_of(model, "GRU").mutable_input()->SwapElements(1, 2);
  expect_refusal(model, "E0618", "has weights of shapes [1, 24, 8] and [1, 24, 3] for 3 values");
  model = model_of("image.onnx");
  for (onnx::AttributeProto& attribute : *node_of(model, "Conv").mutable_attribute()) {
    if (attribute.name() == "group") attribute.set_i(3);
  }
  expect_refusal(model, "E0618", "over 1 channels");
  model = model_of("image.onnx");
  for (onnx::AttributeProto& attribute : *node_of(model, "Conv").mutable_attribute()) {
    if (attribute.name() == "dilations") attribute.set_ints(0, 9);
  }
  expect_refusal(model, "E0613", "whose kernel does not fit");
}

TEST(Architectures, KernelsThatTakeForEverAreRefused) {
  test::OnnxBuilder builder(1);
  builder.graph().clear_input();
  builder.add_input("observation", {1, 1, 1, 65535});
  const auto set = [](onnx::NodeProto& node, const char* name, test::Shape values) {
    onnx::AttributeProto& attribute = *node.add_attribute();
    attribute.set_name(name);
    for (const std::int64_t value : values) attribute.add_ints(value);
  };
  onnx::NodeProto& pool = builder.add_node("AveragePool", {"observation"}, "action");
  set(pool, "kernel_shape", {1, 32768});
  expect_refusal(builder.model, "E0619", "moves too many values");
  pool.clear_attribute();
  set(pool, "kernel_shape", {1, 1024});
  builder.add_tensor("w", {64, 1, 1, 1024}, std::vector<float>(65536, 0.5F));
  pool.set_op_type("Conv");
  pool.add_input("w");
  expect_refusal(builder.model, "E0619", "needs more than 1073741824 products in one layer");
}

/// A memory of `hidden` values with as many gates.
void add_memory(std::vector<test::NamedValues>& tensors, const std::string& name, int inputs,
                int hidden, int gates) {
  const auto zeros = [](int count) {
    return std::vector<float>(static_cast<std::size_t>(count), 0.25F);
  };
  const int rows = gates * hidden;
  tensors.push_back({name + ".weight_ih_l0", {rows, inputs}, zeros(rows * inputs)});
  tensors.push_back({name + ".weight_hh_l0", {rows, hidden}, zeros(rows * hidden)});
  tensors.push_back({name + ".bias_ih_l0", {rows}, zeros(rows)});
  tensors.push_back({name + ".bias_hh_l0", {rows}, zeros(rows)});
}

TEST(Architectures, MemoriesAreFoundWhereTheirSizesFit) {
  std::vector<test::NamedValues> tensors;  // rsl_rl's ActorCriticRecurrent
  add_memory(tensors, "memory_a.rnn", 3, 4, 4);
  add_memory(tensors, "memory_c.rnn", 3, 4, 4);
  test::add_linear(tensors, "actor.0", 4, 5);
  test::add_linear(tensors, "actor.2", 5, 2);
  test::add_linear(tensors, "critic.0", 4, 1);
  Network network = test::read_good(test::safetensors(tensors, R"("activation":"elu")"));
  ASSERT_EQ(network.layers.size(), 3U);
  EXPECT_TRUE(network.layers[0].recurrence()->is_lstm);
  EXPECT_EQ(network.layers[1].activation, Activation::elu);

  tensors.clear();  // a memory between two layers
  test::add_linear(tensors, "encoder", 3, 5);
  test::add_linear(tensors, "a_head", 4, 2);
  add_memory(tensors, "gru", 5, 4, 3);
  network = test::read_good(
      test::safetensors(tensors, R"("activation":"relu","output_activation":"none")"));
  ASSERT_EQ(network.layers.size(), 3U);
  EXPECT_EQ(network.layers[0].activation, Activation::relu);
  EXPECT_FALSE(network.layers[1].recurrence()->is_lstm);
  EXPECT_EQ(network.outputs(), 2U);
}

TEST(Architectures, MemoriesThatFitTwiceGoWhereTheirLibraryPutsThem) {
  std::vector<test::NamedValues> tensors;
  add_memory(tensors, "a2c_network.rnn.rnn", 4, 4, 4);
  test::add_linear(tensors, "a2c_network.actor_mlp.0", 4, 4);
  test::add_linear(tensors, "a2c_network.mu", 4, 2);
  const std::string elu = R"("activation":"elu")";
  EXPECT_NE(test::read_good(test::safetensors(tensors, elu)).layers[1].recurrence(), nullptr);
  tensors.push_back({"a2c_network.layer_norm.weight", {4}, {1, 1, 1, 1}});
  EXPECT_EQ(test::read_bad(test::safetensors(tensors, elu)).code, "E0628");

  tensors.clear();
  add_memory(tensors, "memory_a.rnn", 4, 4, 4);
  test::add_linear(tensors, "actor.0", 4, 4);
  test::add_linear(tensors, "actor.2", 4, 4);
  EXPECT_NE(test::read_good(test::safetensors(tensors, elu)).layers[0].recurrence(), nullptr);

  tensors.clear();
  test::add_linear(tensors, "encoder", 4, 4);
  test::add_linear(tensors, "head", 4, 4);
  add_memory(tensors, "gru", 4, 4, 3);
  EXPECT_EQ(test::read_bad(test::safetensors(tensors, elu)).code, "E0625");
}

TEST(Architectures, MemoriesThatDoNotFitAreRefused) {
  std::vector<test::NamedValues> tensors;
  add_memory(tensors, "gru", 5, 4, 3);
  test::add_linear(tensors, "head.0", 3, 1);
  EXPECT_EQ(test::read_bad(test::safetensors(tensors)).code, "E0618");
  tensors.pop_back();
  tensors.pop_back();
  test::add_linear(tensors, "head.0", 4, 1);
  add_memory(tensors, "other", 5, 4, 3);
  EXPECT_EQ(test::read_bad(test::safetensors(tensors)).code, "E0625");
  tensors.resize(tensors.size() - 4);
  tensors[1].shape = {6, 8};
  EXPECT_EQ(test::read_bad(test::safetensors(tensors)).code, "E0618");
  tensors.clear();
  add_memory(tensors, "rnn", 5, 4, 1);  // a plain RNN
  test::add_linear(tensors, "head.0", 4, 1);
  EXPECT_EQ(test::read_bad(test::safetensors(tensors)).code, "E0628");
}

}  // namespace
}  // namespace eagerx::gen

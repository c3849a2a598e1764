// Every way to write a dense layer gives the same layer.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "tests/unit/formats/onnx_builder.hpp"

namespace eagerx::gen {
namespace {

using test::OnnxBuilder;
using test::read_bad;
using test::read_good;
using testing::ElementsAre;

constexpr std::int64_t kOne = 1;

TEST(OnnxOperators, GemmWithTransposedWeights) {
  const Network network = read_good(test::two_layers().bytes());
  ASSERT_EQ(network.layers.size(), 2U);
  EXPECT_THAT(network.layers[0].weights, ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_THAT(network.layers[0].bias, ElementsAre(0.5F, -0.5F, 0.25F));
  EXPECT_EQ(network.layers[0].activation, Activation::relu);
  EXPECT_EQ(network.layers[1].activation, Activation::identity);
  EXPECT_TRUE(network.ignored.empty());
}

TEST(OnnxOperators, GemmWithFactorsAndWithoutBias) {
  OnnxBuilder builder(2);
  builder.add_tensor("w", {2, 3}, {1, 2, 3, 4, 5, 6});
  builder.add_tensor("b", {1, 1}, {8});
  onnx::NodeProto& first = builder.add_node("Gemm", {"observation", "w", "b"}, "g");
  OnnxBuilder::set(first, "alpha", 2.0F);
  OnnxBuilder::set(first, "beta", 0.5F);
  builder.add_tensor("v", {3, 1}, {1, 1, 1});
  builder.add_node("Gemm", {"g", "v"}, "action");
  const Network network = read_good(builder.bytes());
  EXPECT_THAT(network.layers[0].weights, ElementsAre(2, 8, 4, 10, 6, 12));
  EXPECT_THAT(network.layers[0].bias, ElementsAre(4, 4, 4));
  EXPECT_THAT(network.layers[1].bias, ElementsAre(0));
}

TEST(OnnxOperators, CastsOfConstantsRound) {
  OnnxBuilder builder(2);
  builder.add_tensor("c", {1}, {1.75F});
  OnnxBuilder::set(builder.add_node("Cast", {"c"}, "whole"), "to",
                   std::int64_t{onnx::TensorProto::INT64});
  OnnxBuilder::set(builder.add_node("Cast", {"whole"}, "factor"), "to",
                   std::int64_t{onnx::TensorProto::FLOAT});
  builder.add_node("Mul", {"observation", "factor"}, "action");
  EXPECT_EQ(read_bad(builder.bytes()).code, "E0613") << "once times 1.75";
}

TEST(OnnxOperators, GemmOnAColumn) {
  OnnxBuilder builder(2);
  builder.add_node("Transpose", {"observation"}, "column");
  builder.add_tensor("w", {3, 2}, {1, 2, 3, 4, 5, 6});
  builder.add_tensor("b", {3, 1}, {7, 8, 9});
  builder.add_node("Gemm", {"w", "column", "b"}, "action");
  const Network network = read_good(builder.bytes());
  EXPECT_THAT(network.layers[0].weights, ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_THAT(network.layers[0].bias, ElementsAre(7, 8, 9));
}

TEST(OnnxOperators, GemmOfATransposedColumn) {
  OnnxBuilder builder(2);
  builder.add_node("Transpose", {"observation"}, "column");
  builder.add_tensor("w", {2, 1}, {1, 2});
  OnnxBuilder::set(builder.add_node("Gemm", {"column", "w"}, "action"), "transA", kOne);
  EXPECT_THAT(read_good(builder.bytes()).layers[0].weights, ElementsAre(1, 2));
}

TEST(OnnxOperators, MatMulAndAddAreOneLayer) {
  OnnxBuilder builder(2);
  builder.add_tensor("w", {2, 3}, {1, 2, 3, 4, 5, 6});
  builder.add_tensor("b", {3}, {7, 8, 9});
  builder.add_node("MatMul", {"observation", "w"}, "p");
  builder.add_node("Add", {"b", "p"}, "s");
  builder.add_node("Tanh", {"s"}, "action");
  const Network network = read_good(builder.bytes());
  ASSERT_EQ(network.layers.size(), 1U);
  EXPECT_THAT(network.layers[0].weights, ElementsAre(1, 4, 2, 5, 3, 6));
  EXPECT_THAT(network.layers[0].bias, ElementsAre(7, 8, 9));
  EXPECT_EQ(network.layers[0].activation, Activation::tanh);
}

TEST(OnnxOperators, MatMulFromTheLeftAndOfATransposedConstant) {
  OnnxBuilder builder(2);
  builder.graph().mutable_input(0)->mutable_type()->mutable_tensor_type()->clear_shape();
  builder.graph()
      .mutable_input(0)
      ->mutable_type()
      ->mutable_tensor_type()
      ->mutable_shape()
      ->add_dim()
      ->set_dim_value(2);
  builder.add_tensor("w", {3, 2}, {1, 2, 3, 4, 5, 6});
  builder.add_node("MatMul", {"w", "observation"}, "p");
  builder.add_tensor("v", {1, 3}, {1, 2, 3});
  builder.add_node("Transpose", {"v"}, "vt");
  builder.add_node("MatMul", {"p", "vt"}, "action");
  const Network network = read_good(builder.bytes());
  EXPECT_THAT(network.layers[0].weights, ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_THAT(network.layers[1].weights, ElementsAre(1, 2, 3));
}

TEST(OnnxOperators, ShapesThatKeepTheOrderAreHarmless) {
  OnnxBuilder builder(6);
  auto& shape =
      *builder.graph().mutable_input(0)->mutable_type()->mutable_tensor_type()->mutable_shape();
  shape.clear_dim();
  shape.add_dim()->set_dim_param("batch");
  shape.add_dim()->set_dim_value(2);
  shape.add_dim()->set_dim_value(3);
  OnnxBuilder::set(builder.add_node("Cast", {"observation"}, "c"), "to", kOne);
  builder.add_node("Flatten", {"c"}, "f");
  builder.add_node("Dropout", {"f"}, "d");
  builder.add_node("Concat", {"d"}, "one");
  builder.add_integers("axes", {0});
  builder.add_node("Unsqueeze", {"one", "axes"}, "u");
  builder.add_node("Squeeze", {"u", "axes"}, "s");
  builder.add_tensor("w", {1, 6}, {1, 2, 3, 4, 5, 6});
  OnnxBuilder::set(builder.add_node("Gemm", {"s", "w"}, "g"), "transB", kOne);
  builder.add_integers("flat", {-1});
  builder.add_node("Reshape", {"g", "flat"}, "r");
  builder.add_node("Identity", {"r"}, "action");
  const Network network = read_good(builder.bytes());
  EXPECT_EQ(network.inputs(), 6U);
  EXPECT_THAT(network.layers[0].weights, ElementsAre(1, 2, 3, 4, 5, 6));
}

TEST(OnnxOperators, FlattenByShapeArithmetic) {
  OnnxBuilder builder(2);
  builder.add_node("Shape", {"observation"}, "shape");
  builder.add_integers("zero", {0});
  builder.add_node("Gather", {"shape", "zero"}, "batch");
  builder.add_integers("rest", {-1});
  builder.add_node("Concat", {"batch", "rest"}, "wanted");
  builder.add_node("Reshape", {"observation", "wanted"}, "flat");
  builder.add_tensor("w", {2, 1}, {1, 2});
  builder.add_node("Gemm", {"flat", "w"}, "action");
  EXPECT_THAT(read_good(builder.bytes()).layers[0].weights, ElementsAre(1, 2));
}

TEST(OnnxOperators, OldOpsetsKeepAxesAndBoundsInAttributes) {
  OnnxBuilder builder(2, 9);
  builder.add_tensor("w", {2, 1}, {1, 2});
  builder.add_node("Gemm", {"observation", "w"}, "g");
  OnnxBuilder::set(builder.add_node("Clip", {"g"}, "c"), "min", 0.0F);
  builder.add_node("Squeeze", {"c"}, "action");
  EXPECT_EQ(read_good(builder.bytes()).layers[0].activation, Activation::relu);
}

TEST(OnnxOperators, OtherActivations) {
  OnnxBuilder builder(1);
  const char* before = "observation";
  const std::vector<std::pair<const char*, Activation>> kinds = {
      {"Elu", Activation::elu},
      {"LeakyRelu", Activation::leaky_relu},
      {"Sigmoid", Activation::sigmoid},
      {"Softplus", Activation::softplus},
      {"Gelu", Activation::gelu}};
  builder.add_tensor("w", {1, 1}, {1});
  for (const auto& [type, kind] : kinds) {
    builder.add_node("MatMul", {before, "w"}, (std::string(type) + "_p").c_str());
    auto& node = builder.add_node(type, {(std::string(type) + "_p").c_str()}, type);
    if (kind == Activation::elu) OnnxBuilder::set(node, "alpha", 0.5F);
    before = type;
  }
  builder.add_node("Identity", {before}, "action");
  const Network network = read_good(builder.bytes());
  ASSERT_EQ(network.layers.size(), kinds.size());
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    EXPECT_EQ(network.layers[i].activation, kinds[i].second);
  }
  EXPECT_EQ(network.layers[0].slope, 0.5F);
  EXPECT_EQ(network.layers[1].slope, 0.01F);
}

TEST(OnnxOperators, SiluAndLayerNorm) {
  OnnxBuilder builder(2);
  builder.add_tensor("w", {2, 2}, {1, 2, 3, 4});
  builder.add_tensor("gamma", {2}, {5, 6});
  builder.add_tensor("beta", {2}, {7, 8});
  builder.add_node("MatMul", {"observation", "w"}, "p");
  OnnxBuilder::set(builder.add_node("LayerNormalization", {"p", "gamma", "beta"}, "n"), "epsilon",
                   0.5F);
  builder.add_node("Sigmoid", {"n"}, "gate");
  builder.add_node("Mul", {"n", "gate"}, "action");
  const Network network = read_good(builder.bytes());
  ASSERT_EQ(network.layers.size(), 1U);
  EXPECT_EQ(network.layers[0].activation, Activation::silu);
  ASSERT_TRUE(network.layers[0].norm.has_value());
  EXPECT_THAT(network.layers[0].norm->gamma, ElementsAre(5, 6));
  EXPECT_THAT(network.layers[0].norm->beta, ElementsAre(7, 8));
  EXPECT_EQ(network.layers[0].norm->epsilon, 0.5F);
  EXPECT_TRUE(network.ignored.empty());
}

TEST(OnnxOperators, ClipBetweenBoundsIsVisible) {
  OnnxBuilder builder = test::two_layers();
  builder.add_tensor("low", {}, {-1});
  builder.add_tensor("high", {}, {1});
  builder.add_node("Clip", {"action", "low", "high"}, "clipped");
  builder.graph().mutable_output(0)->set_name("clipped");
  const Network network = read_good(builder.bytes());
  ASSERT_EQ(network.layers.size(), 4U);
  EXPECT_EQ(std::get<Elementwise>(network.layers[2].form).operation,
            Elementwise::Operation::at_least);
  EXPECT_THAT(network.layers[2].bias, ElementsAre(-1));
  EXPECT_EQ(std::get<Elementwise>(network.layers[3].form).operation,
            Elementwise::Operation::at_most);
}

TEST(OnnxOperators, HalvesAreExact) {
  OnnxBuilder builder = test::two_layers();
  onnx::TensorProto& bias = *builder.graph().mutable_initializer(1);
  bias.clear_float_data();
  bias.set_data_type(onnx::TensorProto::FLOAT16);
  for (const int bits : {0x3c00, 0xc000, 0x3555}) bias.add_int32_data(bits);
  EXPECT_THAT(read_good(builder.bytes()).layers[0].bias, ElementsAre(1.0F, -2.0F, 0x1.554p-2F));
  bias.clear_int32_data();
  bias.set_data_type(onnx::TensorProto::BFLOAT16);
  bias.set_raw_data(std::string("\x80\x3f\x00\xc0\xab\x3e", 6));
  EXPECT_THAT(read_good(builder.bytes()).layers[0].bias, ElementsAre(1.0F, -2.0F, 0x1.56p-2F));
}

TEST(OnnxOperators, ConstantMinusDataIsExact) {
  OnnxBuilder builder = test::two_layers();
  builder.add_tensor("one", {1, 1}, {1});
  builder.add_node("Sub", {"one", "action"}, "rest");
  builder.graph().mutable_output(0)->set_name("rest");
  const Network network = read_good(builder.bytes());
  ASSERT_EQ(network.layers.size(), 4U);
  EXPECT_THAT(network.layers[2].bias, ElementsAre(-1));
  EXPECT_THAT(network.layers[3].bias, ElementsAre(1));
}

TEST(OnnxOperators, PartsOfAnObservationAreReordered) {
  OnnxBuilder builder(4);
  builder.add_integers("one", {1});
  builder.add_integers("end", {4});
  builder.add_integers("two", {2});
  builder.add_node("Slice", {"observation", "one", "end", "one", "two"}, "odd");
  builder.add_tensor("w", {2, 1}, {1, 2});
  builder.add_node("MatMul", {"odd", "w"}, "action");
  const Network network = read_good(builder.bytes());
  EXPECT_EQ(network.inputs(), 4U);
  EXPECT_THAT(std::get<Reorder>(network.layers[0].form).from, ElementsAre(1, 3));
}

TEST(OnnxOperators, ValuesAsRawData) {
  OnnxBuilder builder = test::two_layers();
  onnx::TensorProto& weights = *builder.graph().mutable_initializer(2);
  weights.clear_float_data();
  weights.set_raw_data(std::string("\x00\x00\x80\x3f\x00\x00\x00\x80\x00\x00\x20\xc1", 12));
  const Network network = read_good(builder.bytes());
  EXPECT_THAT(network.layers[1].weights, ElementsAre(1.0F, -0.0F, -10.0F));
}

TEST(OnnxOperators, Float64WeightsThatFitAreExact) {
  OnnxBuilder builder = test::two_layers();
  onnx::TensorProto& bias = *builder.graph().mutable_initializer(1);
  bias.clear_float_data();
  bias.set_data_type(onnx::TensorProto::DOUBLE);
  for (const double value : {0.5, -2.0, 1024.0}) bias.add_double_data(value);
  EXPECT_THAT(read_good(builder.bytes()).layers[0].bias, ElementsAre(0.5F, -2.0F, 1024.0F));
}

TEST(OnnxOperators, ConstantNodesAndSharedTensors) {
  OnnxBuilder builder(2);
  onnx::NodeProto& constant = *builder.graph().add_node();
  constant.set_op_type("Constant");
  constant.add_output("w");
  onnx::AttributeProto& value = *constant.add_attribute();
  value.set_name("value");
  value.set_type(onnx::AttributeProto::TENSOR);
  value.mutable_t()->set_data_type(onnx::TensorProto::FLOAT);
  value.mutable_t()->add_dims(2);
  value.mutable_t()->add_dims(2);
  for (const float number : {1.0F, 2.0F, 3.0F, 4.0F}) value.mutable_t()->add_float_data(number);
  builder.add_node("Identity", {"w"}, "w_again");
  builder.add_node("MatMul", {"observation", "w"}, "p");
  builder.add_node("MatMul", {"p", "w_again"}, "action");
  const Network network = read_good(builder.bytes());
  EXPECT_EQ(network.layers[0].weights, network.layers[1].weights);
}

TEST(OnnxOperators, SymbolicBatchIsOne) {
  OnnxBuilder builder = test::two_layers();
  builder.graph()
      .mutable_input(0)
      ->mutable_type()
      ->mutable_tensor_type()
      ->mutable_shape()
      ->mutable_dim(0)
      ->set_dim_param("batch_size");
  EXPECT_EQ(read_good(builder.bytes()).inputs(), 2U);
}

TEST(OnnxOperators, UnusedPartsAreListed) {
  OnnxBuilder builder = test::two_layers();
  builder.add_tensor("spare", {2}, {std::numeric_limits<float>::quiet_NaN(), 0});
  builder.add_input("unused", {1, 4});
  builder.graph().add_output()->set_name("h1");
  EXPECT_THAT(read_good(builder.bytes()).ignored,
              ElementsAre("output `h1`", "tensor `spare` [2]", "input `unused`"));
}

}  // namespace
}  // namespace eagerx::gen

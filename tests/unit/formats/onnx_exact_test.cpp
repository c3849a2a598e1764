// Files that are rare but right give the numbers that ONNX says, or are refused: what a reader
// assumes instead would be another policy.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "generator/policy/network/evaluate.hpp"
#include "tests/unit/formats/onnx_builder.hpp"

namespace eagerx::gen {
namespace {

using test::OnnxBuilder;
using test::read_bad;
using test::read_good;
using testing::ElementsAre;
using testing::FloatNear;
using testing::HasSubstr;
using testing::Pointwise;

void set_input(OnnxBuilder& builder, test::Shape shape) {
  builder.graph().clear_input();
  builder.add_input("observation", shape);
}

void add_list(onnx::NodeProto& node, const char* name, test::Shape values) {
  onnx::AttributeProto& attribute = *node.add_attribute();
  attribute.set_name(name);
  attribute.set_type(onnx::AttributeProto::INTS);
  for (const std::int64_t value : values) attribute.add_ints(value);
}

/// An INT64 constant without an axis.
void add_scalar(OnnxBuilder& builder, const char* name, std::int64_t value) {
  builder.add_integers(name, {value}).clear_dims();
}

/// A node whose result is unknown.
void add_unknown(OnnxBuilder& builder, const char* name) {
  add_scalar(builder, "limit", 1);
  builder.add_node("Range", {"limit", "limit", "limit"}, name);
}

void expect_misused(OnnxBuilder& builder, const char* text) {
  const Diagnostic diagnostic = read_bad(builder.bytes());
  EXPECT_EQ(diagnostic.code, "E0613") << diagnostic.message;
  EXPECT_THAT(diagnostic.message, HasSubstr(text));
}

TEST(OnnxExact, BetaIsOfTheBiasInTheSameNode) {
  OnnxBuilder builder(2);
  builder.add_tensor("w", {2, 2}, {1, 0, 0, 1});
  builder.add_tensor("b", {2}, {1, 2});
  OnnxBuilder::set(builder.add_node("Gemm", {"observation", "w"}, "g"), "beta", 0.0F);
  builder.add_node("Add", {"g", "b"}, "action");
  EXPECT_THAT(evaluate(read_good(builder.bytes()), {1, 1}), ElementsAre(2, 3));
}

TEST(OnnxExact, PaddingOfOldOpsetsIsZero) {
  OnnxBuilder builder(1, 10);
  set_input(builder, {1, 1, 3});
  auto& pad = builder.add_node("Pad", {"observation"}, "p");
  add_list(pad, "pads", {0, 0, 1, 0, 0, 1});
  OnnxBuilder::set(pad, "value", 0.0F);
  builder.add_tensor("w", {1, 1, 3}, {1, 1, 1});
  builder.add_node("Conv", {"p", "w"}, "action");
  EXPECT_THAT(evaluate(read_good(builder.bytes()), {1, 1, 1}), ElementsAre(2, 3, 2));
  builder.graph().mutable_node(0)->mutable_attribute(1)->set_f(5.0F);
  expect_misused(builder, "other than with zeros");
}

TEST(OnnxExact, ScalarIndicesTakeTheirAxisAway) {
  OnnxBuilder builder(1);
  set_input(builder, {1, 2, 2});
  builder.graph().add_node()->set_op_type("Constant");
  builder.graph().mutable_node(0)->add_output("one");
  OnnxBuilder::set(*builder.graph().mutable_node(0), "value_int", std::int64_t{1});
  add_scalar(builder, "zero", 0);
  add_scalar(builder, "two", 2);
  builder.add_node("Shape", {"observation"}, "shape");  // 2 - 1 is a scalar, too
  builder.add_node("Gather", {"shape", "two"}, "width");
  builder.add_node("Sub", {"width", "one"}, "last");
  const char* parts[] = {"a", "b", "c"};
  const char* indices[] = {"zero", "one", "last"};
  for (std::size_t i = 0; i < 3; ++i) {
    auto& gather = builder.add_node("Gather", {"observation", indices[i]}, parts[i]);
    OnnxBuilder::set(gather, "axis", std::int64_t{2});
  }
  auto& concat = builder.add_node("Concat", {"a", "b", "c"}, "columns");
  OnnxBuilder::set(concat, "axis", std::int64_t{-1});
  builder.add_node("Neg", {"columns"}, "action");
  EXPECT_THAT(evaluate(read_good(builder.bytes()), {1, 2, 3, 4}),
              ElementsAre(-1, -3, -2, -4, -2, -4));
}

TEST(OnnxExact, TablesOfIntegersAreNoShapes) {
  OnnxBuilder builder(2);
  auto& table = builder.add_integers("table", {1, 2, 2, 1});
  table.clear_dims();
  table.add_dims(2);
  table.add_dims(2);
  add_scalar(builder, "one", 1);
  builder.add_node("Gather", {"table", "one"}, "row");  // [2, 1], not 2
  builder.add_node("Reshape", {"observation", "row"}, "action");
  expect_misused(builder, "on values that are not a shape");
}

TEST(OnnxExact, SliceOfUnknownAxesOrStepsIsRefused) {
  for (const bool axes : {true, false}) {
    OnnxBuilder builder(2);
    builder.add_integers("start", {0});
    builder.add_integers("end", {2});
    builder.add_integers("one", {1});
    add_unknown(builder, "unknown");
    auto& node = builder.add_node("Slice", {"observation", "start", "end", "one", "one"}, "action");
    node.set_input(axes ? 3 : 4, "unknown");
    const Diagnostic diagnostic = read_bad(builder.bytes());
    EXPECT_THAT(diagnostic.message, HasSubstr("needs operator `Range`"));
  }
}

TEST(OnnxExact, SplitIntoUnknownOrManySizesIsRefused) {
  OnnxBuilder builder(140);
  std::vector<std::int64_t> sizes(70, 2);
  sizes.front() = 3;
  sizes.back() = 1;
  builder.add_integers("sizes", sizes);
  auto& node = builder.add_node("Split", {"observation", "sizes"}, "p0");
  OnnxBuilder::set(node, "axis", std::int64_t{1});
  for (int i = 1; i < 70; ++i) node.add_output("p" + std::to_string(i));
  builder.add_node("Relu", {"p1"}, "action");
  expect_misused(builder, "into sizes that are not constant, or too many");
}

TEST(OnnxExact, ReductionOverUnknownAxesHasNoShape) {
  OnnxBuilder builder(2);
  add_unknown(builder, "unknown");
  builder.add_node("ReduceMax", {"observation", "unknown"}, "most");
  builder.add_node("Sub", {"observation", "most"}, "order");
  OnnxBuilder::set(builder.add_node("ArgMax", {"order"}, "action"), "axis", std::int64_t{1});
  EXPECT_EQ(read_bad(builder.bytes()).code, "E0612");
}

TEST(OnnxExact, NumbersThatAreLeftOutAreZero) {
  OnnxBuilder builder(2);
  auto& curve = builder.add_node("LeakyRelu", {"observation"}, "action");
  onnx::AttributeProto& alpha = *curve.add_attribute();
  alpha.set_name("alpha");
  alpha.set_type(onnx::AttributeProto::FLOAT);
  EXPECT_EQ(read_good(builder.bytes()).layers[0].slope, 0.0F);
  alpha.clear_type();  // nothing at all
  EXPECT_EQ(read_good(builder.bytes()).layers[0].slope, 0.01F);
}

TEST(OnnxExact, IntegersBecomeReals) {
  for (const bool like : {false, true}) {
    OnnxBuilder builder(2);
    add_scalar(builder, "one", 1);
    add_scalar(builder, "two", 2);
    builder.add_tensor("real", {}, {7}).set_data_type(onnx::TensorProto::FLOAT);
    for (const auto& [from, to] : {std::pair{"one", "a"}, std::pair{"two", "b"}}) {
      if (like) {
        builder.add_node("CastLike", {from, "real"}, to);
      } else {
        OnnxBuilder::set(builder.add_node("Cast", {from}, to), "to",
                         std::int64_t{onnx::TensorProto::DOUBLE});
      }
    }
    builder.add_node("Div", {"a", "b"}, "half");
    builder.add_node("Mul", {"observation", "half"}, "action");
    EXPECT_THAT(evaluate(read_good(builder.bytes()), {1, 3}), ElementsAre(0.5F, 1.5F));
  }
}

TEST(OnnxExact, MaximumOfOneIsItself) {
  OnnxBuilder builder(2);
  builder.add_tensor("c", {2}, {-1, -2});
  builder.add_node("Max", {"c"}, "most");
  builder.add_node("Add", {"observation", "most"}, "action");
  EXPECT_THAT(evaluate(read_good(builder.bytes()), {1, 1}), ElementsAre(0, -1));
}

TEST(OnnxExact, OuterProductsAreRefused) {
  OnnxBuilder builder(2);
  builder.add_tensor("gamma", {2}, {1, 1});
  builder.add_tensor("column", {2, 1}, {1, 2});
  builder.add_node("LayerNormalization", {"observation", "gamma"}, "n");
  builder.add_node("Add", {"n", "column"}, "action");
  expect_misused(builder, "operator `Add`");
  OnnxBuilder silu(2);
  silu.add_node("Sigmoid", {"observation"}, "gate");
  silu.add_node("Transpose", {"gate"}, "column");
  silu.add_node("Mul", {"observation", "column"}, "action");
  expect_misused(silu, "on shapes that do not fit");
}

TEST(OnnxExact, InfiniteBoundsAreNone) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  OnnxBuilder builder(2);
  builder.add_tensor("low", {}, {-1});
  builder.add_tensor("high", {}, {kInfinity});
  builder.add_node("Clip", {"observation", "low", "high"}, "action");
  EXPECT_THAT(evaluate(read_good(builder.bytes()), {-3, 3}), ElementsAre(-1, 3));
  builder.graph().mutable_initializer(1)->set_float_data(0, -kInfinity);
  EXPECT_EQ(read_bad(builder.bytes()).code, "E0616") << "all becomes minus infinity";
}

TEST(OnnxExact, NumbersAddedToAVarianceAddUp) {
  OnnxBuilder builder(2);
  builder.add_tensor("two", {}, {2});
  builder.add_tensor("e1", {}, {0.5F});
  builder.add_tensor("e2", {}, {0.25F});
  builder.add_integers("axes", {-1});
  builder.model.mutable_opset_import(0)->set_version(18);
  builder.add_node("ReduceMean", {"observation", "axes"}, "mean");
  builder.add_node("Sub", {"observation", "mean"}, "d");
  builder.add_node("Pow", {"d", "two"}, "dd");
  builder.add_node("ReduceMean", {"dd", "axes"}, "variance");
  builder.add_node("Add", {"variance", "e1"}, "v1");
  builder.add_node("Add", {"e2", "v1"}, "v2");
  builder.add_node("Sqrt", {"v2"}, "deviation");
  builder.add_node("Div", {"d", "deviation"}, "action");
  const Network network = read_good(builder.bytes());
  ASSERT_TRUE(network.layers[0].norm.has_value());
  EXPECT_EQ(network.layers[0].norm->epsilon, 0.75F);
}

TEST(OnnxExact, MishIsWhatOlderExportersWriteOut) {
  const std::vector<float> x = {-3.0F, -0.5F, 0.0F, 1.0F, 30.0F};
  OnnxBuilder whole(5, 18);
  whole.add_node("Mish", {"observation"}, "action");
  OnnxBuilder parts(5);
  parts.add_node("Softplus", {"observation"}, "soft");
  parts.add_node("Tanh", {"soft"}, "gate");
  parts.add_node("Mul", {"observation", "gate"}, "action");
  const std::vector<float> answer = evaluate(read_good(whole.bytes()), x);
  EXPECT_EQ(answer, evaluate(read_good(parts.bytes()), x));
  // x tanh(ln(1 + e^x)), calculated in float64 by Python.
  EXPECT_THAT(answer,
              Pointwise(FloatNear(1e-6F), {-0.14564746F, -0.22074377F, 0.0F, 0.86509839F, 30.0F}));
}

}  // namespace
}  // namespace eagerx::gen

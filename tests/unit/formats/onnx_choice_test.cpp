// Exports that end with a choice, take an observation in several inputs, or split what a layer
// gives.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/policy/network/evaluate.hpp"
#include "tests/unit/formats/onnx_builder.hpp"

namespace eagerx::gen {
namespace {

using test::OnnxBuilder;
using test::read_bad;
using test::read_good;
using testing::ElementsAre;
using testing::HasSubstr;

/// observation [1, 2] -> Gemm (4 outputs) -> scores.
OnnxBuilder scores() {
  OnnxBuilder builder(2);
  builder.add_tensor("w", {4, 2}, {1, 0, 0, 1, 1, 1, -1, 2});
  builder.add_tensor("b", {4}, {0, 1, 2, 3});
  OnnxBuilder::set(builder.add_node("Gemm", {"observation", "w", "b"}, "scores"), "transB",
                   std::int64_t{1});
  return builder;
}

onnx::NodeProto& along(onnx::NodeProto& node, std::int64_t axis) {
  OnnxBuilder::set(node, "axis", axis);
  return node;
}

TEST(OnnxChoice, ArgMaxBehindSoftmaxIsAChoiceAmongTheScores) {
  OnnxBuilder builder = scores();
  builder.add_integers("axes", {1});
  builder.add_node("ReduceLogSumExp", {"scores", "axes"}, "sum");
  builder.add_node("Sub", {"scores", "sum"}, "logits");
  along(builder.add_node("Softmax", {"logits"}, "probabilities"), 1);
  auto& choice = along(builder.add_node("ArgMax", {"probabilities"}, "index"), 1);
  OnnxBuilder::set(choice, "keepdims", std::int64_t{0});
  OnnxBuilder::set(builder.add_node("Cast", {"index"}, "action"), "to",
                   std::int64_t{onnx::TensorProto::INT64});
  const Network network = read_good(builder.bytes());
  EXPECT_EQ(network.action_kind(), ActionKind::argmax);
  ASSERT_EQ(network.layers.size(), 1U);
  EXPECT_THAT(evaluate(network, {1, 1}), ElementsAre(1, 2, 4, 4));
}

TEST(OnnxChoice, AValueOfTheStateKeepsTheOrder) {
  OnnxBuilder builder = scores();
  builder.add_tensor("v", {2, 1}, {1, 1});
  builder.add_node("MatMul", {"observation", "v"}, "value");
  builder.add_node("Add", {"value", "scores"}, "sum");
  along(builder.add_node("ArgMax", {"sum"}, "action"), 1);
  EXPECT_EQ(read_good(builder.bytes()).action_kind(), ActionKind::argmax);
}

TEST(OnnxChoice, AValueOfTheStateIsAddedWhereNoChoiceFollows) {
  OnnxBuilder builder = scores();
  builder.add_tensor("v", {2, 1}, {1, 1});
  builder.add_node("MatMul", {"observation", "v"}, "value");
  builder.add_node("Add", {"value", "scores"}, "action");
  EXPECT_THAT(evaluate(read_good(builder.bytes()), {1, 1}), ElementsAre(3, 4, 6, 6));
}

TEST(OnnxChoice, WhatIsNotPickedMayBeAnything) {
  OnnxBuilder builder(2);
  builder.add_tensor("zero", {}, {0});
  builder.add_tensor("one", {2}, {1, 1});
  builder.add_node("Sub", {"observation", "observation"}, "zeros");
  builder.add_node("Div", {"observation", "zeros"}, "infinite");
  builder.add_node("Greater", {"observation", "zero"}, "above");
  builder.add_node("Where", {"above", "one", "infinite"}, "picked");
  builder.add_node("Where", {"above", "picked", "one"}, "action");
  EXPECT_THAT(evaluate(read_good(builder.bytes()), {3, -2}), ElementsAre(1, 1));
}

/// Multi-branch agents of ML-Agents: each branch has an ArgMax of its own.
TEST(OnnxChoice, SeveralChoicesSideBySide) {
  OnnxBuilder builder = scores();
  builder.add_integers("sizes", {1, 3});
  along(builder.add_node("Split", {"scores", "sizes"}, "first"), 1).add_output("second");
  along(builder.add_node("ArgMax", {"second"}, "index_b"), 1);
  along(builder.add_node("ArgMax", {"first"}, "index_a"), 1);
  along(builder.add_node("Concat", {"index_b", "index_a"}, "action"), 1);
  const Network network = read_good(builder.bytes());
  EXPECT_EQ(network.action_kind(), ActionKind::argmax);
  EXPECT_THAT(network.contract.groups, ElementsAre(3U, 1U));
  EXPECT_THAT(evaluate(network, {1, 1}), ElementsAre(2, 4, 4, 1)) << "the scores of b, then of a";
  builder.graph().mutable_node(4)->set_input(1, "scores");
  EXPECT_EQ(read_bad(builder.bytes()).code, "E0613");
}

TEST(OnnxChoice, NothingIsCalculatedFromAChoice) {
  OnnxBuilder builder = scores();
  along(builder.add_node("ArgMax", {"scores"}, "index"), 1);
  builder.add_node("Relu", {"index"}, "action");
  const Diagnostic diagnostic = read_bad(builder.bytes());
  EXPECT_EQ(diagnostic.code, "E0613");
  EXPECT_THAT(diagnostic.message, HasSubstr("whose result is not the action"));
}

TEST(OnnxChoice, ProbabilitiesAreNoAction) {
  OnnxBuilder builder = scores();
  along(builder.add_node("Softmax", {"scores"}, "action"), 1);
  const Diagnostic diagnostic = read_bad(builder.bytes());
  EXPECT_EQ(diagnostic.code, "E0613");
  EXPECT_THAT(diagnostic.message, HasSubstr("without an ArgMax"));
}

TEST(OnnxChoice, MeanOfQuantiles) {
  OnnxBuilder builder = scores();
  builder.add_integers("shape", {-1, 2, 2});
  builder.add_node("Reshape", {"scores", "shape"}, "quantiles");
  builder.add_integers("axes", {1});
  OnnxBuilder::set(builder.add_node("ReduceMean", {"quantiles", "axes"}, "action"), "keepdims",
                   std::int64_t{0});
  EXPECT_THAT(evaluate(read_good(builder.bytes()), {1, 1}), ElementsAre(2.5F, 3));
}

TEST(OnnxChoice, SplitIntoMeanAndDeviation) {
  OnnxBuilder builder = scores();
  builder.add_integers("sizes", {1, 3});
  auto& split = along(builder.add_node("Split", {"scores", "sizes"}, "deviation"), 1);
  split.add_output("action");
  EXPECT_THAT(evaluate(read_good(builder.bytes()), {1, 1}), ElementsAre(2, 4, 4));
  builder = scores();
  auto& halves = along(builder.add_node("Split", {"scores"}, "action"), 1);
  halves.add_output("deviation");
  EXPECT_THAT(evaluate(read_good(builder.bytes()), {1, 1}), ElementsAre(1, 2));
  halves.mutable_attribute(0)->set_i(3);
  EXPECT_EQ(read_bad(builder.bytes()).code, "E0613");
}

TEST(OnnxChoice, InputsSideBySideAreOneObservation) {
  OnnxBuilder builder(1);
  builder.add_input("speed", {1, 1});
  along(builder.add_node("Concat", {"observation", "speed"}, "both"), -1);
  builder.add_tensor("w", {1, 2}, {1, 10});
  OnnxBuilder::set(builder.add_node("Gemm", {"both", "w"}, "action"), "transB", std::int64_t{1});
  const Network network = read_good(builder.bytes());
  ASSERT_EQ(network.contract.observations.size(), 2U);
  EXPECT_EQ(network.contract.observations[1].name, "speed");
  ASSERT_EQ(network.layers.size(), 1U);
  EXPECT_THAT(evaluate(network, {2, 3}), ElementsAre(32));
}

TEST(OnnxChoice, ConcatInAnotherOrder) {
  OnnxBuilder builder(1);
  builder.add_input("speed", {1, 1});
  along(builder.add_node("Concat", {"speed", "observation"}, "both"), 1);
  builder.add_tensor("w", {1, 2}, {1, 10});
  OnnxBuilder::set(builder.add_node("Gemm", {"both", "w"}, "action"), "transB", std::int64_t{1});
  EXPECT_THAT(evaluate(read_good(builder.bytes()), {2, 3}), ElementsAre(23));
}

TEST(OnnxChoice, ConstantsAreCalculated) {
  OnnxBuilder builder(2);
  builder.add_tensor("variance", {2}, {3, 8});
  builder.add_tensor("one", {}, {1});
  builder.add_node("Add", {"variance", "one"}, "sum");
  builder.add_node("Sqrt", {"sum"}, "deviation");
  builder.add_node("Div", {"observation", "deviation"}, "action");
  EXPECT_THAT(evaluate(read_good(builder.bytes()), {2, 3}), ElementsAre(1, 1));
}

}  // namespace
}  // namespace eagerx::gen

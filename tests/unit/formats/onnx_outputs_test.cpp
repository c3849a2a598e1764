// Which output of an ONNX file is the action.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/policy/network/evaluate.hpp"
#include "tests/unit/formats/onnx_builder.hpp"
#include "tests/unit/formats/table_builder.hpp"

namespace eagerx::gen {
namespace {

using test::expect_problem;
using test::OnnxBuilder;
using test::read_bad;
using test::read_good;
using testing::ElementsAre;
using testing::HasSubstr;

void add_output(OnnxBuilder& builder, const char* name, test::Shape shape) {
  onnx::ValueInfoProto& output = *builder.graph().add_output();
  output.set_name(name);
  auto& type = *output.mutable_type()->mutable_tensor_type();
  for (const std::int64_t dim : shape) type.mutable_shape()->add_dim()->set_dim_value(dim);
}

/// observation [1, 2] -> y = 2 x [1, 2] -> a matrix -> `name` [1, 1].
OnnxBuilder normalised_first(const char* name) {
  OnnxBuilder builder(2);
  builder.graph().clear_output();
  builder.add_tensor("two", {1, 2}, {2, 2});
  builder.add_tensor("w", {2, 1}, {1, -1});
  builder.add_node("Mul", {"observation", "two"}, "seen");
  builder.add_node("MatMul", {"seen", "w"}, name);
  add_output(builder, "seen", {1, 2});
  add_output(builder, name, {1, 1});
  return builder;
}

std::optional<Network> read_output(const std::string& bytes, const char* output,
                                   Diagnostics& diagnostics) {
  ReadContext context;
  context.output_name = output;
  return read_policy_bytes(bytes, "policy.onnx", {}, diagnostics, context);
}

TEST(OnnxOutputs, AnObservationInFrontOfTheActionIsNotTaken) {
  const Diagnostic problem = read_bad(normalised_first("done").bytes());
  expect_problem(problem, "E0751", "2 outputs");
  EXPECT_THAT(problem.message, HasSubstr("`seen` [1, 2], `done` [1, 1]"));
  EXPECT_EQ(read_good(normalised_first("actions").bytes()).outputs(), 1U)
      << "it has the name of one";
}

TEST(OnnxOutputs, TheGraphMaySayWhich) {
  const std::string bytes = normalised_first("done").bytes();
  Diagnostics diagnostics;
  const auto done = read_output(bytes, "done", diagnostics);
  ASSERT_TRUE(done.has_value());
  EXPECT_THAT(evaluate(*done, {3, 1}), ElementsAre(4));
  EXPECT_THAT(done->ignored, testing::Contains("output `seen`"));
  const auto seen = read_output(bytes, "seen", diagnostics);
  ASSERT_TRUE(seen.has_value());
  EXPECT_EQ(seen->outputs(), 2U);
  EXPECT_TRUE(diagnostics.all().empty());
  EXPECT_FALSE(read_output(bytes, "nowhere", diagnostics).has_value());
  expect_problem(diagnostics.all().back(), "E0751",
                 "no output `nowhere`: it has `seen` [1, 2], `d");
  EXPECT_FALSE(read_output(test::zip({}), "done", diagnostics).has_value());
  EXPECT_FALSE(read_output(test::safetensors({}), "done", diagnostics).has_value());
  expect_problem(diagnostics.all().back(), "E0751", "no outputs with names");
}

/// two_layers() and a second head of `values` numbers, whose weights are called `weight`.
OnnxBuilder two_heads(const char* output, const char* weight, int values) {
  OnnxBuilder builder = test::two_layers();
  builder.graph().mutable_output(0)->set_name("first");
  builder.graph().mutable_node(2)->set_output(0, "first");
  builder.add_tensor(weight, {values, 3}, std::vector<float>(static_cast<std::size_t>(3 * values)));
  OnnxBuilder::set(builder.add_node("Gemm", {"h1", weight}, output), "transB", std::int64_t{1});
  add_output(builder, output, {1, values});
  return builder;
}

TEST(OnnxOutputs, ValuesAndDeviationsAreKnown) {
  EXPECT_EQ(read_good(two_heads("value", "w3", 1).bytes()).outputs(), 1U);
  EXPECT_EQ(read_good(two_heads("77", "value_net.weight", 1).bytes()).outputs(), 1U);
  EXPECT_EQ(read_good(two_heads("log_std", "w3", 4).bytes()).outputs(), 1U);
  expect_problem(read_bad(two_heads("77", "w3", 4).bytes()), "E0751", "`first`, `77` [1, 4]");
  EXPECT_EQ(read_good(two_heads("mu", "w3", 4).bytes()).outputs(), 4U);
}

TEST(OnnxOutputs, OfMlAgentsTheDeterministicActionIsTaken) {
  OnnxBuilder builder = test::two_layers();
  builder.graph().clear_output();
  builder.add_tensor("version", {1}, {3});
  builder.add_tensor("twice", {1}, {2});
  builder.add_node("Identity", {"version"}, "version_number");
  builder.add_node("Identity", {"version"}, "memory_size");
  builder.add_node("Tanh", {"action"}, "deterministic_continuous_actions");
  builder.add_node("Mul", {"action", "twice"}, "continuous_actions");
  for (const char* name : {"version_number", "memory_size", "continuous_actions"}) {
    add_output(builder, name, {1, 1});
  }
  EXPECT_EQ(read_good(builder.bytes()).layers.back().activation, Activation::identity);
  add_output(builder, "deterministic_continuous_actions", {1, 1});
  EXPECT_EQ(read_good(builder.bytes()).layers.back().activation, Activation::tanh);
  builder.add_node("Neg", {"action"}, "deterministic_discrete_actions");
  add_output(builder, "deterministic_discrete_actions", {1, 1});
  EXPECT_EQ(read_bad(builder.bytes()).code, "E0751") << "two actions";
}

TEST(OnnxOutputs, WeightsThatLeadNowhereAreRefused) {
  OnnxBuilder builder = test::two_layers();
  builder.add_tensor("head.weight", {4, 3}, std::vector<float>(12));
  expect_problem(read_bad(builder.bytes()), "E0752", "none of its outputs: `head.weight` [4, 3]");
  Diagnostics diagnostics;
  EXPECT_TRUE(read_output(builder.bytes(), "action", diagnostics).has_value()) << "it was said";
  builder.graph().mutable_initializer()->rbegin()->set_name("a.log_std.weight");
  EXPECT_THAT(read_good(builder.bytes()).ignored, ElementsAre("tensor `a.log_std.weight` [4, 3]"));
}

}  // namespace
}  // namespace eagerx::gen

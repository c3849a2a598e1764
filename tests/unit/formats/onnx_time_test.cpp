// Sequences of any length: the answer to the newest observation, or nothing else than it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/unit/formats/onnx_builder.hpp"

namespace eagerx::gen {
namespace {

using test::OnnxBuilder;
using test::read_bad;
using test::read_good;
using testing::HasSubstr;

void set(onnx::NodeProto& node, const char* name, test::Shape values) {
  onnx::AttributeProto& attribute = *node.add_attribute();
  attribute.set_name(name);
  attribute.set_type(onnx::AttributeProto::INTS);
  for (const std::int64_t value : values) attribute.add_ints(value);
}

/// observation [batch, time, 2] -> LSTM from zeros -> steps [batch, time, 3], newest [1, batch, 3].
OnnxBuilder sequence() {
  OnnxBuilder builder(2);
  auto& shape =
      *builder.graph().mutable_input(0)->mutable_type()->mutable_tensor_type()->mutable_shape();
  shape.clear_dim();
  shape.add_dim()->set_dim_param("batch");
  shape.add_dim()->set_dim_param("time");
  shape.add_dim()->set_dim_value(2);
  builder.add_tensor("wi", {1, 12, 2}, std::vector<float>(24, 0.5F));
  builder.add_tensor("wh", {1, 12, 3}, std::vector<float>(36, 0.25F));
  builder.add_tensor("w", {3, 1}, {1, 2, 3});
  builder.add_integers("zero", {0});
  builder.add_integers("one", {1});
  builder.add_integers("two", {2});
  builder.add_integers("newest", {-1});
  builder.add_integers("end", {std::int64_t{1} << 40U});
  set(builder.add_node("Transpose", {"observation"}, "x"), "perm", {1, 0, 2});
  auto& lstm = builder.add_node("LSTM", {"x", "wi", "wh"}, "y");
  lstm.add_output("h");
  OnnxBuilder::set(lstm, "hidden_size", std::int64_t{3});
  builder.add_node("Squeeze", {"y", "one"}, "by_time");
  set(builder.add_node("Transpose", {"by_time"}, "steps"), "perm", {1, 0, 2});
  return builder;
}

/// A node with `axis`, from `before` to the layer that gives the action.
std::string bytes_with(const char* type, test::Names inputs, std::int64_t axis) {
  OnnxBuilder builder = sequence();
  OnnxBuilder::set(builder.add_node(type, inputs, "some"), "axis", axis);
  builder.add_node("MatMul", {"some", "w"}, "action");
  return builder.bytes();
}

void expect_refused(const std::string& bytes, const char* type) {
  const Diagnostic diagnostic = read_bad(bytes);
  EXPECT_EQ(diagnostic.code, "E0613") << diagnostic.message;
  EXPECT_THAT(diagnostic.message, HasSubstr(std::string("operator `") + type));
  EXPECT_THAT(diagnostic.message, HasSubstr("over the steps of a sequence"));
}

TEST(OnnxTime, TheNewestStepIsTheAction) {
  for (const std::string& bytes :
       {bytes_with("Gather", {"steps", "newest"}, 1),
        bytes_with("Gather", {"by_time", "newest"}, 0),
        bytes_with("Slice", {"steps", "newest", "end", "one"}, 0),
        bytes_with("Gather", {"h", "zero"}, 0), bytes_with("Squeeze", {"h", "zero"}, 0),
        bytes_with("Identity", {"steps"}, 0), bytes_with("Gather", {"by_time", "zero"}, 1),
        bytes_with("Flatten", {"by_time"}, 2)}) {
    EXPECT_TRUE(read_good(bytes).has_memory());
  }
}

TEST(OnnxTime, OtherStepsAreRefused) {
  expect_refused(bytes_with("Gather", {"steps", "zero"}, 1), "Gather");
  expect_refused(bytes_with("Slice", {"steps", "zero", "one", "one"}, 0), "Slice");
  expect_refused(bytes_with("Squeeze", {"by_time", "zero"}, 0), "Squeeze");
  expect_refused(bytes_with("Concat", {"by_time", "by_time"}, 0), "Concat");
  expect_refused(bytes_with("Flatten", {"steps"}, 1), "Flatten");
}

/// The matrix that leads to no output of such a graph has a name that says why.
void leave_out_w(OnnxBuilder& builder) {
  for (onnx::TensorProto& tensor : *builder.graph().mutable_initializer()) {
    if (tensor.name() == "w") tensor.set_name("critic.w");
  }
}

TEST(OnnxTime, MeansOverStepsAreRefused) {
  for (const std::int64_t axis : {0, 1}) {
    OnnxBuilder builder = sequence();
    auto& mean = builder.add_node("ReduceMean", {"steps"}, "some");
    set(mean, "axes", {axis});
    builder.add_node("Neg", {"some"}, "action");
    leave_out_w(builder);
    if (axis == 1) {
      expect_refused(builder.bytes(), "ReduceMean");
    } else {
      EXPECT_TRUE(read_good(builder.bytes()).has_memory()) << "over the batch, which is one";
    }
  }
}

TEST(OnnxTime, ImagesOfStepsAreRefused) {
  OnnxBuilder builder = sequence();
  set(builder.add_node("Transpose", {"steps"}, "image"), "perm", {0, 2, 1});
  builder.add_node("GlobalMaxPool", {"image"}, "action");
  expect_refused(builder.bytes(), "GlobalMaxPool");
}

TEST(OnnxTime, RowsOfStepsAreHarmlessOneLongRowIsNot) {
  for (const bool rows : {true, false}) {
    OnnxBuilder builder = sequence();
    builder.add_integers(
        "rows", rows ? std::vector<std::int64_t>{-1, 3} : std::vector<std::int64_t>{1, -1});
    builder.add_node("Reshape", {"steps", "rows"}, "some");
    builder.add_node("Gemm", {"some", "w"}, "action");
    if (rows) {
      EXPECT_TRUE(read_good(builder.bytes()).has_memory());
    } else {
      expect_refused(builder.bytes(), "Reshape");
    }
  }
}

TEST(OnnxTime, DirectionsMayBeMerged) {
  OnnxBuilder builder = sequence();
  set(builder.add_node("Transpose", {"y"}, "by_batch"), "perm", {0, 2, 1, 3});
  builder.add_integers("merged", {0, 0, -1});
  builder.add_node("Reshape", {"by_batch", "merged"}, "some");
  builder.add_node("LSTM", {"some", "wh3", "wh"}, "y2");
  builder.add_tensor("wh3", {1, 12, 3}, std::vector<float>(36, 0.5F));
  builder.add_node("Squeeze", {"y2", "one"}, "flat");
  builder.add_node("MatMul", {"flat", "w"}, "action");
  EXPECT_EQ(read_good(builder.bytes()).layers.size(), 3U);
}

TEST(OnnxTime, ACellMayNotRunOverTheBatch) {
  OnnxBuilder builder = sequence();
  builder.add_node("LSTM", {"steps", "wh", "wh"}, "y2");
  builder.add_node("Squeeze", {"y2", "one"}, "flat");
  builder.add_node("MatMul", {"flat", "w"}, "action");
  const Diagnostic diagnostic = read_bad(builder.bytes());
  EXPECT_THAT(diagnostic.message, HasSubstr("does not run along the time"));
}

TEST(OnnxTime, ChoicesAreMadeStepByStep) {
  OnnxBuilder builder = sequence();
  auto& sum = builder.add_node("ReduceLogSumExp", {"steps"}, "sum");
  set(sum, "axes", {-1});
  builder.add_node("Sub", {"steps", "sum"}, "logits");
  leave_out_w(builder);
  OnnxBuilder::set(builder.add_node("ArgMax", {"logits"}, "action"), "axis", std::int64_t{-1});
  EXPECT_EQ(read_good(builder.bytes()).action_kind(), ActionKind::argmax);
}

}  // namespace
}  // namespace eagerx::gen

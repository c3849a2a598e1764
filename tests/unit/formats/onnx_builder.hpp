// Small ONNX models, built node by node. Tests change the parts afterwards as they like.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "generator/policy/formats/onnx/onnx.pb.h"
#include "generator/policy/formats/read.hpp"

namespace eagerx::gen::test {

using Shape = std::initializer_list<std::int64_t>;
using Names = std::initializer_list<const char*>;

/// A model with input `observation` [1, inputs] and output `action`.
class OnnxBuilder {
 public:
  explicit OnnxBuilder(std::int64_t inputs, std::int64_t opset = 17) {
    model.set_ir_version(8);
    model.add_opset_import()->set_version(opset);
    add_input("observation", {1, inputs});
    graph().add_output()->set_name("action");
  }

  onnx::GraphProto& graph() { return *model.mutable_graph(); }

  onnx::ValueInfoProto& add_input(const char* name, Shape shape) {
    onnx::ValueInfoProto& input = *graph().add_input();
    input.set_name(name);
    onnx::TypeProto::Tensor& type = *input.mutable_type()->mutable_tensor_type();
    type.set_elem_type(onnx::TensorProto::FLOAT);
    for (const std::int64_t dim : shape) type.mutable_shape()->add_dim()->set_dim_value(dim);
    return input;
  }

  onnx::TensorProto& add_tensor(const char* name, Shape shape, const std::vector<float>& values) {
    onnx::TensorProto& tensor = *graph().add_initializer();
    tensor.set_name(name);
    tensor.set_data_type(onnx::TensorProto::FLOAT);
    for (const std::int64_t dim : shape) tensor.add_dims(dim);
    for (const float value : values) tensor.add_float_data(value);
    return tensor;
  }

  onnx::TensorProto& add_integers(const char* name, const std::vector<std::int64_t>& values) {
    onnx::TensorProto& tensor = *graph().add_initializer();
    tensor.set_name(name);
    tensor.set_data_type(onnx::TensorProto::INT64);
    tensor.add_dims(static_cast<std::int64_t>(values.size()));
    for (const std::int64_t value : values) tensor.add_int64_data(value);
    return tensor;
  }

  onnx::NodeProto& add_node(const char* type, Names inputs, const char* output) {
    onnx::NodeProto& node = *graph().add_node();
    node.set_op_type(type);
    node.set_name(std::string("/") + type);
    for (const char* input : inputs) node.add_input(input);
    node.add_output(output);
    return node;
  }

  static void set(onnx::NodeProto& node, const char* name, std::int64_t value) {
    onnx::AttributeProto& attribute = *node.add_attribute();
    attribute.set_name(name);
    attribute.set_type(onnx::AttributeProto::INT);
    attribute.set_i(value);
  }
  static void set(onnx::NodeProto& node, const char* name, float value) {
    onnx::AttributeProto& attribute = *node.add_attribute();
    attribute.set_name(name);
    attribute.set_type(onnx::AttributeProto::FLOAT);
    attribute.set_f(value);
  }

  [[nodiscard]] std::string bytes() const { return model.SerializeAsString(); }

  onnx::ModelProto model;
};

/// observation [1, 2] -> Gemm "hidden" (3 outputs) -> Relu -> Gemm (1 output) -> action.
inline OnnxBuilder two_layers() {
  OnnxBuilder builder(2);
  builder.add_tensor("w1", {3, 2}, {1, 2, 3, 4, 5, 6});
  builder.add_tensor("b1", {3}, {0.5F, -0.5F, 0.25F});
  builder.add_tensor("w2", {1, 3}, {-1, 2, -3});
  builder.add_tensor("b2", {1}, {0.125F});
  OnnxBuilder::set(builder.add_node("Gemm", {"observation", "w1", "b1"}, "g1"), "transB",
                   std::int64_t{1});
  builder.add_node("Relu", {"g1"}, "h1");
  OnnxBuilder::set(builder.add_node("Gemm", {"h1", "w2", "b2"}, "action"), "transB",
                   std::int64_t{1});
  return builder;
}

/// The network in `bytes`; a test failure with the diagnostic if there is none.
inline Network read_good(const std::string& bytes) {
  Diagnostics diagnostics;
  std::optional<Network> network = read_policy_bytes(bytes, "policy.onnx", {}, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    ADD_FAILURE() << diagnostic.code << ": " << diagnostic.message;
  }
  return network ? *network : Network{{}, {}, {Layer{}}, {}};
}

/// The only diagnostic that `bytes` give; a test failure if there is not exactly one.
inline Diagnostic read_bad(const std::string& bytes) {
  Diagnostics diagnostics;
  const Span mention{FileId{3}, 7, 11, 4};
  const std::optional<Network> network =
      read_policy_bytes(bytes, "policy.onnx", mention, diagnostics);
  EXPECT_FALSE(network.has_value());
  EXPECT_EQ(diagnostics.all().size(), 1U);
  if (diagnostics.all().empty()) return {};
  EXPECT_EQ(diagnostics.all().front().span.line, mention.line);
  return diagnostics.all().front();
}

/// The code, and a part of the message.
inline void expect_problem(const Diagnostic& diagnostic, const char* code, const char* part) {
  EXPECT_EQ(diagnostic.code, code) << diagnostic.message;
  EXPECT_THAT(diagnostic.message, testing::HasSubstr(part));
}

}  // namespace eagerx::gen::test

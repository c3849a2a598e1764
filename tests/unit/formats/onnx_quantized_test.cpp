// Networks of QuantizeLinear and DequantizeLinear, against whole-number arithmetic.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "generator/policy/network/evaluate.hpp"
#include "tests/unit/formats/onnx_builder.hpp"

namespace eagerx::gen {
namespace {

using test::OnnxBuilder;
using test::read_bad;
using test::read_good;
using testing::ElementsAre;
using testing::HasSubstr;

void add_whole(OnnxBuilder& builder, const char* name, onnx::TensorProto::DataType type,
               std::initializer_list<std::int64_t> shape, const std::vector<std::int32_t>& values) {
  onnx::TensorProto& tensor = builder.add_tensor(name, shape, {});
  tensor.set_data_type(type);
  for (const std::int32_t value : values) tensor.add_int32_data(value);
}

/// observation -> uint8 -> Gemm of int8, a scale for each row, bias of int32 -> Relu -> int8.
OnnxBuilder quantized_layer() {
  OnnxBuilder builder(2, 13);
  builder.add_tensor("x_scale", {}, {0.25F});
  add_whole(builder, "x_zero", onnx::TensorProto::UINT8, {}, {100});
  builder.add_node("QuantizeLinear", {"observation", "x_scale", "x_zero"}, "x_whole");
  builder.add_node("DequantizeLinear", {"x_whole", "x_scale", "x_zero"}, "x");
  builder.add_tensor("w_scale", {3}, {0.5F, 0.25F, 0.125F});
  add_whole(builder, "w_zero", onnx::TensorProto::INT8, {3}, {0, 1, -2});
  add_whole(builder, "w_whole", onnx::TensorProto::INT8, {3, 2}, {1, -2, 127, -128, 5, 6});
  OnnxBuilder::set(builder.add_node("DequantizeLinear", {"w_whole", "w_scale", "w_zero"}, "w"),
                   "axis", std::int64_t{0});
  builder.add_tensor("b_scale", {}, {0.0625F});
  add_whole(builder, "b_whole", onnx::TensorProto::INT32, {3}, {16, -1000, 70000});
  builder.add_node("DequantizeLinear", {"b_whole", "b_scale"}, "b");
  OnnxBuilder::set(builder.add_node("Gemm", {"x", "w", "b"}, "g"), "transB", std::int64_t{1});
  builder.add_node("Relu", {"g"}, "h");
  builder.add_tensor("y_scale", {}, {8.0F});
  add_whole(builder, "y_zero", onnx::TensorProto::INT8, {}, {-100});
  builder.add_node("QuantizeLinear", {"h", "y_scale", "y_zero"}, "y_whole");
  builder.add_node("DequantizeLinear", {"y_whole", "y_scale", "y_zero"}, "action");
  return builder;
}

double nearest(double x) {
  return std::nearbyint(x);  // halves to even
}

std::vector<float> wanted(const std::vector<float>& observation) {
  constexpr std::int32_t kWeights[3][2] = {{1, -2}, {126, -129}, {7, 8}};  // without zero points
  constexpr double kScales[3] = {0.5, 0.25, 0.125};
  constexpr double kBias[3] = {1.0, -62.5, 4375.0};
  std::vector<float> action;
  for (std::size_t row = 0; row < 3; ++row) {
    double sum = kBias[row];
    for (std::size_t i = 0; i < 2; ++i) {
      const double whole =
          std::clamp(nearest(static_cast<double>(observation[i]) / 0.25) + 100, 0.0, 255.0) - 100;
      sum += whole * 0.25 * kWeights[row][i] * kScales[row];
    }
    const double whole = std::clamp(nearest(std::max(sum, 0.0) / 8) - 100, -128.0, 127.0) + 100;
    action.push_back(static_cast<float>(whole * 8));
  }
  return action;
}

TEST(OnnxQuantized, RoundsAsWholeNumbersDo) {
  const Network network = read_good(quantized_layer().bytes());
  for (const std::vector<float>& observation : {std::vector{0.0F, 0.0F},
                                                {1.0F, -2.5F},
                                                {0.125F, 0.375F} /* halves */,
                                                {-30.0F, 50.0F} /* beyond the range */,
                                                {-0.125F, 12.125F},
                                                {1e9F, -1e9F}}) {
    EXPECT_EQ(evaluate(network, observation), wanted(observation))
        << observation[0] << ", " << observation[1];
  }
}

TEST(OnnxQuantized, RealWeightsAreRoundedOnce) {
  OnnxBuilder builder(2, 13);
  builder.add_tensor("scale", {}, {0.5F});
  builder.add_tensor("real", {2, 1}, {0.74F, 1000.0F});
  builder.add_node("QuantizeLinear", {"real", "scale"}, "whole");  // uint8, without a zero point
  builder.add_node("DequantizeLinear", {"whole", "scale"}, "w");
  builder.add_node("MatMul", {"observation", "w"}, "action");
  const Network network = read_good(builder.bytes());
  ASSERT_EQ(network.layers.size(), 1U);
  EXPECT_THAT(network.layers[0].weights, ElementsAre(0.5F, 127.5F));
}

TEST(OnnxQuantized, WholeNumbersOfTheNetworkMayBeMoved) {
  OnnxBuilder builder(2, 13);
  builder.add_tensor("scale", {}, {0.5F});
  builder.add_integers("shape", {2, 1});
  builder.add_node("QuantizeLinear", {"observation", "scale"}, "whole");
  builder.add_node("Reshape", {"whole", "shape"}, "column");
  builder.add_node("DequantizeLinear", {"column", "scale"}, "action");
  EXPECT_THAT(evaluate(read_good(builder.bytes()), {0.8F, -3.0F}), ElementsAre(1.0F, 0.0F));
}

TEST(OnnxQuantized, RoundFloorAndCeil) {
  const std::vector<float> observation = {-2.5F, -0.4F, 0.5F, 1.5F, 2.7F};
  const auto of = [&observation](const char* type) {
    OnnxBuilder builder(5, 13);
    builder.add_node(type, {"observation"}, "action");
    return evaluate(read_good(builder.bytes()), observation);
  };
  EXPECT_THAT(of("Round"), ElementsAre(-2.0F, -0.0F, 0.0F, 2.0F, 3.0F));
  EXPECT_THAT(of("Floor"), ElementsAre(-3.0F, -1.0F, 0.0F, 1.0F, 2.0F));
  EXPECT_THAT(of("Ceil"), ElementsAre(-2.0F, -0.0F, 1.0F, 2.0F, 3.0F));
}

TEST(OnnxQuantized, WhatIsRefusedSaysWhy) {
  OnnxBuilder rows(2, 13);
  rows.add_tensor("scales", {2}, {0.5F, 0.25F});
  rows.add_node("QuantizeLinear", {"observation", "scales"}, "whole");
  rows.add_node("DequantizeLinear", {"whole", "scales"}, "action");
  EXPECT_THAT(read_bad(rows.bytes()).message,
              HasSubstr("several scales of what is not a constant"));

  OnnxBuilder wide(2, 13);
  wide.add_tensor("scale", {}, {0.5F});
  add_whole(wide, "zero", onnx::TensorProto::INT32, {}, {0});
  wide.add_node("QuantizeLinear", {"observation", "scale", "zero"}, "whole");
  wide.add_node("DequantizeLinear", {"whole", "scale", "zero"}, "action");
  EXPECT_THAT(read_bad(wide.bytes()).message, HasSubstr("other than int8, uint8 and int16"));

  OnnxBuilder computed(2, 13);
  computed.add_node("QuantizeLinear", {"observation", "observation"}, "action");
  EXPECT_THAT(read_bad(computed.bytes()).message, HasSubstr("are not constants"));

  OnnxBuilder misfit(2, 13);
  misfit.add_tensor("scales", {3}, {1, 1, 1});
  add_whole(misfit, "w_whole", onnx::TensorProto::INT8, {2, 2}, {1, 2, 3, 4});
  misfit.add_node("DequantizeLinear", {"w_whole", "scales"}, "w");
  misfit.add_node("MatMul", {"observation", "w"}, "action");
  EXPECT_THAT(read_bad(misfit.bytes()).message, HasSubstr("one per channel"));
}

}  // namespace
}  // namespace eagerx::gen

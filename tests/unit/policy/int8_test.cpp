// Weights of eight bits: rounding, the bits of the program, the error that is told.
#include "generator/policy/int8.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <eagerx/policy/int8.hpp>

namespace eagerx::gen {
namespace {

constexpr std::size_t kInputs = 7;
constexpr std::size_t kOutputs = 6;

/// One layer with weights that need rounding.
Network one_layer() {
  DenseLayer layer;
  layer.inputs = kInputs;
  layer.outputs = kOutputs;
  for (std::size_t i = 0; i < kInputs * kOutputs; ++i) {
    layer.weights.push_back(0.37F * static_cast<float>(i % 11) - 1.7F);
  }
  for (std::size_t i = 0; i < kOutputs; ++i) layer.bias.push_back(0.1F * static_cast<float>(i));
  layer.activation = Activation::tanh;
  Network network;
  network.layers.push_back(layer);
  return network;
}

TEST(Int8Weights, AreRoundedToTheNearestOfEachOutputsScale) {
  const Network given = one_layer();
  const Network rounded = with_int8_weights(given);
  const DenseLayer& layer = rounded.layers.front();
  for (std::size_t out = 0; out < kOutputs; ++out) {
    int largest = 0;
    for (std::size_t in = 0; in < kInputs; ++in) {
      const std::size_t i = out * kInputs + in;
      largest = std::max(largest, std::abs(int{layer.rounded[i]}));
      EXPECT_NEAR(layer.weights[i], static_cast<float>(layer.rounded[i]) * layer.scales[out],
                  0.5001F * layer.scales[out]);
    }
    EXPECT_EQ(largest, 127);
  }
}

TEST(Int8Weights, AnswerWithTheBitsOfTheProgram) {
  const Network rounded = with_int8_weights(one_layer());
  const DenseLayer& layer = rounded.layers.front();
  eagerx::Int8Weights<kInputs, kOutputs> program{};
  const std::vector<int> stored = int8_stored(layer);
  ASSERT_EQ(stored.size(), sizeof program.w);
  for (std::size_t i = 0; i < stored.size(); ++i) {
    program.w[i] = static_cast<std::int8_t>(stored[i]);
  }
  for (std::size_t out = 0; out < kOutputs; ++out) {
    program.scale[out] = layer.scales[out];
    program.b[out] = layer.bias[out];
  }
  const float x[kInputs] = {0.3F, -1.25F, 0.0F, 2.5F, -0.125F, 1e-4F, 0.7F};
  float y[kOutputs];
  eagerx::dense<eagerx::Activation::tanh>(program, x, y);
  const std::vector<float> ours = evaluate(rounded, std::vector<float>(x, x + kInputs));
  for (std::size_t out = 0; out < kOutputs; ++out) {
    EXPECT_EQ(std::bit_cast<std::uint32_t>(ours[out]), std::bit_cast<std::uint32_t>(y[out]));
  }
}

TEST(Int8Weights, TellWhatRoundingCosts) {
  const Network given = one_layer();
  const RoundingError error = rounding_error(given, with_int8_weights(given), nullptr);
  EXPECT_EQ(error.rows, 256U);
  EXPECT_FALSE(error.golden);
  EXPECT_GT(error.largest, 0.0);
  EXPECT_LE(error.mean, error.largest);
  EXPECT_LT(error.largest, 0.05);
  EXPECT_EQ(rounding_error(given, given, nullptr).largest, 0.0);
}

}  // namespace
}  // namespace eagerx::gen

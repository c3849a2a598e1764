// Weights of eight bits: rounding, the bits of the program, the reported error.
#include "generator/policy/network/int8.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <eagerx/policy/convolution.hpp>
#include <eagerx/policy/int8.hpp>
#include <eagerx/policy/recurrent.hpp>

#include "generator/policy/network/evaluate.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kInputs = 7;
constexpr std::size_t kOutputs = 6;

/// One layer with weights that need rounding.
Network one_layer() {
  Layer layer;
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
  const Layer& layer = rounded.layers.front();
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
  const Layer& layer = rounded.layers.front();
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

/// Rows `first` to `first` + Out of rounded weights as the program stores them.
template <std::size_t In, std::size_t Out>
eagerx::Int8Weights<In, Out> stored(const Int8Rows& rows, std::size_t first = 0) {
  Layer part;
  part.inputs = In;
  part.outputs = Out;
  part.rounded.assign(rows.rounded + first * In, rows.rounded + (first + Out) * In);
  eagerx::Int8Weights<In, Out> program{};
  const std::vector<int> values = int8_stored(part);
  for (std::size_t i = 0; i < values.size(); ++i) {
    program.w[i] = static_cast<std::int8_t>(values[i]);
  }
  for (std::size_t out = 0; out < Out; ++out) {
    program.scale[out] = rows.scales[first + out];
    program.b[out] = rows.bias[first + out];
  }
  return program;
}

std::vector<float> numbers(std::size_t count, float seed) {
  std::vector<float> values;
  for (std::size_t i = 0; i < count; ++i) {
    seed = 3.7F * seed * (1.0F - seed);  // chaotic, in 0…1
    values.push_back(2.0F * seed - 1.0F);
  }
  return values;
}

template <std::size_t N>
void expect_same_bits(const std::vector<float>& ours, const float (&program)[N]) {
  ASSERT_EQ(ours.size(), N);
  for (std::size_t i = 0; i < N; ++i) {
    EXPECT_EQ(std::bit_cast<std::uint32_t>(ours[i]), std::bit_cast<std::uint32_t>(program[i]));
  }
}

TEST(Int8Weights, OfMemoriesAnswerWithTheBitsOfTheProgram) {
  constexpr std::size_t kHidden = 5;
  for (const bool is_lstm : {false, true}) {
    const std::size_t rows = (is_lstm ? 4 : 3) * kHidden;
    Layer layer;
    layer.inputs = kInputs;
    layer.outputs = kHidden;
    layer.weights = numbers(rows * kInputs, 0.3F);
    layer.bias = numbers(rows, 0.4F);
    layer.form = Recurrence{is_lstm, numbers(rows * kHidden, 0.6F), numbers(rows, 0.7F), {}, {}};
    Network given;
    given.layers.push_back(layer);
    const Network rounded = with_int8_weights(given);
    const Layer& r = rounded.layers.front();
    const Recurrence& cell = *r.recurrence();
    const Int8Rows input{r.rounded.data(), r.scales.data(), r.bias.data(), rows};
    const Int8Rows hidden{cell.hidden_rounded.data(), cell.hidden_scales.data(),
                          cell.hidden_bias.data(), rows};
    eagerx::GruWeights<kInputs, kHidden, eagerx::Int8Weights> gru{};
    if (!is_lstm) {
      gru = {stored<kInputs, 3 * kHidden>(input), stored<kHidden, 3 * kHidden>(hidden)};
    }
    eagerx::LstmWeights<kInputs, kHidden, eagerx::Int8Weights> lstm{};
    if (is_lstm) {
      lstm = {stored<kInputs, 4 * kHidden>(input), stored<kHidden, 4 * kHidden>(hidden)};
    }
    eagerx::GruMemory<kHidden> gru_memory{};
    eagerx::LstmMemory<kHidden> lstm_memory{};
    Memory<float> memory;
    for (int step = 0; step < 4; ++step) {
      const std::vector<float> observation =
          numbers(kInputs, 0.21F + 0.1F * static_cast<float>(step));
      float x[kInputs];
      std::copy(observation.begin(), observation.end(), x);
      float y[kHidden];
      if (is_lstm) {
        eagerx::lstm(lstm, x, lstm_memory, y);
      } else {
        eagerx::gru(gru, x, gru_memory, y);
      }
      expect_same_bits(evaluate(rounded, observation, &memory), y);
    }
    const RoundingError error = rounding_error(given, rounded, nullptr);
    EXPECT_GT(error.largest, 0.0);
    EXPECT_LT(error.largest, 0.05);
    EXPECT_LT(int8_bytes(r), (rows * (kInputs + kHidden + 2)) * sizeof(float));
  }
}

TEST(Int8Weights, OfConvolutionsAnswerWithTheBitsOfTheProgram) {
  static constexpr eagerx::Kernel kKernel = {.channels = 4,
                                             .height = 5,
                                             .width = 4,
                                             .rows = 2,
                                             .columns = 3,
                                             .stride_down = 2,
                                             .pad_left = 1,
                                             .out_height = 2,
                                             .out_width = 3};
  constexpr std::size_t kChannels = 6;
  constexpr std::size_t kPatch = 2 * 2 * 3;
  Convolution form;
  form.kernel = {4, 5, 4, 2, 3, 2, 1, 0, 1, 1, 1, 2, 3};
  form.groups = 2;
  form.channels = kChannels;
  Layer layer;
  layer.inputs = kKernel.inputs();
  layer.outputs = kChannels * kKernel.places();
  layer.weights = numbers(kChannels * kPatch, 0.3F);
  layer.bias = numbers(kChannels, 0.4F);
  layer.form = form;
  layer.activation = Activation::relu;
  Network given;
  given.layers.push_back(layer);
  const Network rounded = with_int8_weights(given);
  const Layer& r = rounded.layers.front();
  const Int8Rows rows{r.rounded.data(), r.scales.data(), r.bias.data(), kChannels};
  const eagerx::ConvolutionWeights<kKernel, kChannels, 2, eagerx::Int8Weights> program{
      {stored<kPatch, 3>(rows), stored<kPatch, 3>(rows, 3)}};
  const std::vector<float> image = numbers(kKernel.inputs(), 0.8F);
  float x[kKernel.inputs()];
  std::copy(image.begin(), image.end(), x);
  float y[kChannels * kKernel.places()];
  eagerx::convolve<eagerx::Activation::relu>(program, x, y);
  expect_same_bits(evaluate(rounded, image), y);
  EXPECT_LT(rounding_error(given, rounded, nullptr).largest, 0.1);
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

// Recurrent, convolutional and elementwise layers against plain loops in the documented order:
// every bit. tests/unit/formats/architectures_test.cpp compares networks of them with torch.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <eagerx/policy/convolution.hpp>
#include <eagerx/policy/elementwise.hpp>
#include <eagerx/policy/recurrent.hpp>
#include <limits>

#include "tests/support/plain_sum.hpp"

namespace {

using eagerx::Activation;
using eagerx::DenseWeights;

/// Numbers of mixed sign, the same on every machine.
class MixedNumbers {
 public:
  float next() {
    state_ = state_ * 1664525U + 1013904223U;
    return static_cast<float>(state_ >> 8U) * 0x1p-23F - 1.0F;
  }
  template <std::size_t N>
  void fill(float (&values)[N]) {
    for (float& value : values) value = next();
  }

 private:
  std::uint32_t state_ = 1;
};

/// Weights as a matrix, [Out][In], and as they are stored.
template <std::size_t In, std::size_t Out>
struct Matrix {
  float w[Out][In];
  float b[Out];
  DenseWeights<In, Out> stored{};

  explicit Matrix(MixedNumbers& numbers) {
    for (std::size_t out = 0; out < Out; ++out) {
      numbers.fill(w[out]);
      b[out] = stored.b[out] = numbers.next();
      for (std::size_t in = 0; in < In; ++in) {
        stored.w[DenseWeights<In, Out>::index(out, in)] = w[out][in];
      }
    }
  }
  [[nodiscard]] float sum(std::size_t out, const float* x) const {
    return eagerx::test::plain_sum(w[out], x, In, b[out], out, Out);
  }
};

std::uint32_t bits(float x) {
  return std::bit_cast<std::uint32_t>(x);
}

float sigmoid(float x) {
  return eagerx::policy::activated<Activation::sigmoid>(x, 0.0F);
}

TEST(PolicyLayers, GruIsTorchsFormula) {
  constexpr std::size_t kIn = 5;
  constexpr std::size_t kHidden = 11;
  MixedNumbers numbers;
  const Matrix<kIn, 3 * kHidden> input(numbers);
  const Matrix<kHidden, 3 * kHidden> hidden(numbers);
  const eagerx::GruWeights<kIn, kHidden> layer{input.stored, hidden.stored};
  eagerx::GruMemory<kHidden> memory{};
  float h[kHidden] = {};
  for (int step = 0; step < 20; ++step) {
    float x[kIn];
    float y[kHidden];
    numbers.fill(x);
    eagerx::gru(layer, x, memory, y);
    float next[kHidden];
    for (std::size_t k = 0; k < kHidden; ++k) {
      const float r = sigmoid(input.sum(k, x) + hidden.sum(k, h));
      const float z = sigmoid(input.sum(kHidden + k, x) + hidden.sum(kHidden + k, h));
      const float n =
          eagerx::tanh(input.sum(2 * kHidden + k, x) + r * hidden.sum(2 * kHidden + k, h));
      next[k] = n + z * (h[k] - n);
      EXPECT_EQ(bits(y[k]), bits(next[k]));
      EXPECT_EQ(bits(memory.h[k]), bits(next[k]));
    }
    std::copy(next, next + kHidden, h);
  }
}

TEST(PolicyLayers, LstmIsTorchsFormula) {
  constexpr std::size_t kIn = 9;
  constexpr std::size_t kHidden = 6;
  MixedNumbers numbers;
  const Matrix<kIn, 4 * kHidden> input(numbers);
  const Matrix<kHidden, 4 * kHidden> hidden(numbers);
  const eagerx::LstmWeights<kIn, kHidden> layer{input.stored, hidden.stored};
  eagerx::LstmMemory<kHidden> memory{};
  float h[kHidden] = {};
  float c[kHidden] = {};
  for (int step = 0; step < 20; ++step) {
    float x[kIn];
    float y[kHidden];
    numbers.fill(x);
    eagerx::lstm(layer, x, memory, y);
    float next[kHidden];
    for (std::size_t k = 0; k < kHidden; ++k) {
      const auto gate = [&](std::size_t g) {
        return input.sum(g * kHidden + k, x) + hidden.sum(g * kHidden + k, h);
      };
      c[k] = sigmoid(gate(1)) * c[k] + sigmoid(gate(0)) * eagerx::tanh(gate(2));
      next[k] = sigmoid(gate(3)) * eagerx::tanh(c[k]);
      EXPECT_EQ(bits(y[k]), bits(next[k]));
      EXPECT_EQ(bits(memory.c[k]), bits(c[k]));
    }
    std::copy(next, next + kHidden, h);
  }
}

TEST(PolicyLayers, HistoryIsOldestFirstAndBeginsWithZeros) {
  eagerx::HistoryMemory<4> memory{};
  for (int step = 0; step < 5; ++step) {
    const float x[2] = {static_cast<float>(step + 1), static_cast<float>(-step - 1)};
    float y[6];
    eagerx::history(x, memory, y);
    for (int frame = 0; frame < 3; ++frame) {
      const int number = std::max(step + frame - 1, 0);  // of its step, from 1 on; 0: before
      EXPECT_EQ(y[2 * frame], static_cast<float>(number));
      EXPECT_EQ(y[2 * frame + 1], static_cast<float>(-number));
    }
  }
}

constexpr eagerx::Kernel kKernel = {.channels = 4,
                                    .height = 7,
                                    .width = 9,
                                    .rows = 3,
                                    .columns = 2,
                                    .stride_down = 2,
                                    .stride_right = 1,
                                    .pad_top = 1,
                                    .pad_left = 2,
                                    .dilation_down = 1,
                                    .dilation_right = 3,
                                    .out_height = 4,
                                    .out_width = 10};

/// The value of the image at a place that may lie in the padding.
float at(const float* x, std::size_t channel, int y, int column) {
  const bool inside = y >= 0 && y < 7 && column >= 0 && column < 9;
  return inside
             ? x[(channel * 7 + static_cast<std::size_t>(y)) * 9 + static_cast<std::size_t>(column)]
             : 0.0F;
}

TEST(PolicyLayers, ConvolutionIsCrossCorrelation) {
  MixedNumbers numbers;
  const Matrix<12, 3> first(numbers);
  const Matrix<12, 3> second(numbers);
  const eagerx::ConvolutionWeights<kKernel, 6, 2> layer{{first.stored, second.stored}};
  float x[kKernel.inputs()];
  float y[6 * kKernel.places()];
  numbers.fill(x);
  eagerx::convolve<Activation::relu>(layer, x, y);
  for (int out = 0; out < 6; ++out) {
    for (int place = 0; place < 40; ++place) {
      float patch[12];
      for (int i = 0; i < 12; ++i) {
        const int channel = out / 3 * 2 + i / 6;
        patch[i] = at(x, static_cast<std::size_t>(channel), place / 10 * 2 + i % 6 / 2 - 1,
                      place % 10 + i % 2 * 3 - 2);
      }
      const auto& group = out < 3 ? first : second;
      const float sum = group.sum(static_cast<std::size_t>(out % 3), patch);
      EXPECT_EQ(bits(y[out * 40 + place]), bits(sum < 0.0F ? 0.0F : sum));
    }
  }
}

TEST(PolicyLayers, PoolsLookAtWhatIsInside) {
  constexpr eagerx::Kernel kPool = {.channels = 1,
                                    .height = 2,
                                    .width = 3,
                                    .rows = 2,
                                    .columns = 2,
                                    .stride_down = 2,
                                    .stride_right = 2,
                                    .pad_top = 0,
                                    .pad_left = 1,
                                    .out_height = 1,
                                    .out_width = 2};
  const float x[6] = {-1.0F, 2.0F, 3.0F, -4.0F, 5.0F, -6.0F};
  float y[2];
  eagerx::max_pool<kPool>(x, y);
  EXPECT_EQ(y[0], -1.0F);
  EXPECT_EQ(y[1], 5.0F);
  eagerx::average_pool<kPool, false>(x, y);
  EXPECT_EQ(y[0], -2.5F);
  EXPECT_EQ(y[1], 1.0F);
  eagerx::average_pool<kPool, true>(x, y);
  EXPECT_EQ(y[0], -1.25F);
  float broken[6] = {0, 0, 0, 0, 0, 0};
  broken[1] = std::numeric_limits<float>::quiet_NaN();
  eagerx::max_pool<kPool>(broken, y);
  EXPECT_EQ(y[0], 0.0F);
  EXPECT_NE(y[1], y[1]);
}

TEST(PolicyLayers, ConstantsAreOneForAllOrOneForEach) {
  const float x[3] = {1.0F, -2.0F, std::numeric_limits<float>::quiet_NaN()};
  const float one[1] = {0.5F};
  const float each[3] = {2.0F, 4.0F, 8.0F};
  float y[3];
  eagerx::policy::add(one, x, y);
  EXPECT_EQ(y[1], -1.5F);
  eagerx::policy::subtract(each, x, y);
  EXPECT_EQ(y[1], -6.0F);
  eagerx::policy::multiply(each, x, y);
  EXPECT_EQ(y[1], -8.0F);
  eagerx::policy::divide(each, x, y);
  EXPECT_EQ(y[1], -0.5F);
  eagerx::policy::at_least(one, x, y);
  EXPECT_EQ(y[0], 1.0F);
  EXPECT_EQ(y[1], 0.5F);
  EXPECT_NE(y[2], y[2]);
  eagerx::policy::at_most(one, x, y);
  EXPECT_EQ(y[0], 0.5F);
  EXPECT_NE(y[2], y[2]);
  const std::uint16_t from[2] = {1, 0};
  float swapped[2];
  eagerx::policy::reorder(from, x, swapped);
  EXPECT_EQ(swapped[0], -2.0F);
  eagerx::policy::apply<Activation::relu>(x, y);
  EXPECT_EQ(y[1], 0.0F);
}

}  // namespace

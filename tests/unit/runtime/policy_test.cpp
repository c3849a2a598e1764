// The layers of eagerx/policy.hpp against plain loops in the documented order: every bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <eagerx/policy.hpp>
#include <eagerx/policy/fast.hpp>
#include <eagerx/policy/int8.hpp>
#include <limits>
#include <memory>
#include <utility>

#include "tests/support/plain_sum.hpp"

namespace {

using eagerx::Activation;
using eagerx::DenseWeights;
using eagerx::test::plain_sum;

float plain_activation(Activation activation, float y) {
  if (activation == Activation::relu) return y < 0.0F ? 0.0F : y;
  return activation == Activation::tanh ? eagerx::tanh(y) : y;
}

/// Lanes against one number at a time, and both against `exact` in float64.
template <Activation A, class Exact>
void compare_activation(double largest_error, Exact&& exact) {
  constexpr float kSlope = 0.5F;
  for (int i = -3000; i < 3000; ++i) {
    float y[11];
    float x[11];
    for (int k = 0; k < 11; ++k) y[k] = x[k] = static_cast<float>(i * 11 + k) * 0x1p-10F;
    eagerx::activate<A>(y, kSlope);
    for (int k = 0; k < 11; ++k) {
      const float one = eagerx::policy::activated<A>(x[k], kSlope);
      ASSERT_EQ(std::bit_cast<std::uint32_t>(y[k]), std::bit_cast<std::uint32_t>(one)) << x[k];
      const double wanted = exact(static_cast<double>(x[k]));
      ASSERT_NEAR(static_cast<double>(one), wanted,
                  largest_error * (1.0 + (wanted < 0 ? -wanted : wanted)))
          << x[k];
    }
  }
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float result = eagerx::policy::activated<A>(nan, kSlope);
  EXPECT_NE(result, result);
}

/// Numbers of mixed sign and size, the same on every machine.
class Numbers {
 public:
  explicit Numbers(std::uint32_t seed) : state_(seed * 2654435761U + 1U) {}
  float next() {
    state_ = state_ * 1664525U + 1013904223U;
    const float unit = static_cast<float>(state_ >> 8U) * 0x1p-24F - 0.5F;
    return (state_ & 0x80U) != 0 ? unit * 16.0F : unit * 0.01F;
  }

 private:
  std::uint32_t state_;
};

/// The bits of a result; one NaN for all NaNs, whose sign and payload are the machine's.
std::uint32_t bits_of(float x) {
  return x != x ? 0x7fc00000U : std::bit_cast<std::uint32_t>(x);
}

template <Activation A, std::size_t In, std::size_t Out>
void compare(const float (&row_major)[Out * In], const float (&bias)[Out], const float (&x)[In]) {
  const auto layer = std::make_unique<DenseWeights<In, Out>>();
  for (std::size_t out = 0; out < Out; ++out) {
    layer->b[out] = bias[out];
    for (std::size_t in = 0; in < In; ++in) {
      layer->w[DenseWeights<In, Out>::index(out, in)] = row_major[out * In + in];
    }
  }
  float y[Out];
  eagerx::dense<A>(*layer, x, y);
  for (std::size_t out = 0; out < Out; ++out) {
    const float expected =
        plain_activation(A, plain_sum(row_major + out * In, x, In, bias[out], out, Out));
    EXPECT_EQ(bits_of(y[out]), bits_of(expected))
        << In << " inputs, output " << out << " of " << Out << ": " << y[out] << " instead of "
        << expected;
  }
}

template <std::size_t In, std::size_t Out>
void compare_random() {
  static float weights[Out * In];
  float bias[Out];
  float x[In];
  Numbers numbers(static_cast<std::uint32_t>(In * 1000 + Out));
  for (int round = 0; round < 20; ++round) {
    for (float& w : weights) w = numbers.next();
    for (float& b : bias) b = numbers.next();
    for (float& value : x) value = numbers.next();
    compare<Activation::identity, In, Out>(weights, bias, x);
    compare<Activation::relu, In, Out>(weights, bias, x);
    compare<Activation::tanh, In, Out>(weights, bias, x);
  }
}

template <std::size_t In, std::size_t... Out>
void compare_outputs(std::index_sequence<Out...> /*outputs*/) {
  (compare_random<In, Out>(), ...);
}

using ManyOutputs = std::index_sequence<1, 2, 3, 4, 5, 7, 8, 9, 12, 15, 16, 17, 24, 31, 33, 64, 65>;

TEST(Policy, IsThePlainLoopToTheBitForFewInputs) {
  compare_outputs<1>(ManyOutputs{});
  compare_outputs<3>(ManyOutputs{});
  compare_outputs<7>(ManyOutputs{});
}

TEST(Policy, IsThePlainLoopToTheBitAroundOneGroupOfInputs) {
  compare_outputs<8>(ManyOutputs{});
  compare_outputs<9>(ManyOutputs{});
}

TEST(Policy, IsThePlainLoopToTheBitForManyInputs) {
  compare_outputs<17>(ManyOutputs{});
  compare_outputs<64>(ManyOutputs{});
  compare_random<256, 256>();
  compare_random<400, 300>();
}

TEST(Policy, TreatsSpecialNumbersAsThePlainLoop) {
  constexpr std::size_t kIn = 11;
  constexpr std::size_t kOut = 21;
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kTiny = std::numeric_limits<float>::denorm_min();
  const float special[] = {
      0.0F,  -0.0F, kInfinity, -kInfinity, std::numeric_limits<float>::quiet_NaN(),
      kTiny, 1.0F,  0x1p-126F, 3.0e38F,    -1.0F};
  constexpr std::size_t kSpecials = sizeof(special) / sizeof(special[0]);
  float weights[kOut * kIn];
  float bias[kOut];
  float x[kIn];
  for (std::size_t round = 0; round < 200; ++round) {
    for (std::size_t i = 0; i < kOut * kIn; ++i) weights[i] = special[(i * 7 + round) % kSpecials];
    for (std::size_t i = 0; i < kOut; ++i) bias[i] = special[(i * 3 + round / 10) % kSpecials];
    for (std::size_t i = 0; i < kIn; ++i) x[i] = special[(i + round / 3) % kSpecials];
    compare<Activation::identity, kIn, kOut>(weights, bias, x);
    compare<Activation::relu, kIn, kOut>(weights, bias, x);
    compare<Activation::tanh, kIn, kOut>(weights, bias, x);
  }
}

TEST(Policy, KeepsMinusZeroOfTheBias) {
  static constexpr DenseWeights<1, 8> kLayer = {{}, {-0.0F, -0.0F, 0.0F}};
  const float x[] = {-1.0F};  // every product is -0
  float y[8];
  eagerx::dense<Activation::identity>(kLayer, x, y);
  EXPECT_EQ(bits_of(y[0]), 0x80000000U);
  EXPECT_EQ(bits_of(y[2]), 0U);
}

TEST(Policy, ShowsABrokenObservationThroughRelu) {
  static constexpr DenseWeights<1, 1> kLayer = {{1.0F}, {0.0F}};
  const float x[] = {std::numeric_limits<float>::quiet_NaN()};
  float y[1] = {};
  eagerx::dense<Activation::relu>(kLayer, x, y);
  EXPECT_TRUE(y[0] != y[0]);
}

TEST(Policy, PadsOnlyTheLastPanel) {
  static_assert(sizeof(DenseWeights<64, 64>) == (64 * 64 + 64) * sizeof(float));
  static_assert(DenseWeights<64, 1>::kPadded == 1);
  static_assert(DenseWeights<64, 3>::kPadded == 4);
  static_assert(DenseWeights<64, 13>::kPadded == 16);
  using Weights = DenseWeights<3, 10>;
  EXPECT_EQ(Weights::index(7, 2), 2U * 8U + 7U);
  EXPECT_EQ(Weights::index(9, 2), 3U * 8U + 2U * 2U + 1U);
}

TEST(Activations, AreExactAndTheSameInLanes) {
  constexpr double kError = 2.5e-7;  // relative to the larger of 1 and the value
  compare_activation<Activation::elu>(kError,
                                      [](double x) { return x < 0 ? 0.5 * std::expm1(x) : x; });
  compare_activation<Activation::leaky_relu>(kError, [](double x) { return x < 0 ? 0.5 * x : x; });
  compare_activation<Activation::silu>(kError, [](double x) { return x / (1 + std::exp(-x)); });
  compare_activation<Activation::gelu>(
      kError, [](double x) { return 0.5 * x * std::erfc(-x * std::sqrt(0.5)); });
  compare_activation<Activation::gelu_tanh>(kError, [](double x) {
    return 0.5 * x * (1 + std::tanh(std::sqrt(2 / 3.141592653589793) * (x + 0.044715 * x * x * x)));
  });
  compare_activation<Activation::softplus>(
      kError, [](double x) { return x > 20 ? x : std::log1p(std::exp(x)); });
  compare_activation<Activation::sigmoid>(kError, [](double x) { return 1 / (1 + std::exp(-x)); });
}

TEST(LayerNorm, NormalisesAllValues) {
  const eagerx::NormWeights<4> norm = {{1, 2, 3, 4}, {0, 0, 0, 0.5F}, 0.0F};
  float y[4] = {1, 3, 1, 3};
  eagerx::layer_norm(norm, y);
  EXPECT_EQ(y[0], -1.0F);
  EXPECT_EQ(y[1], 2.0F);
  EXPECT_EQ(y[2], -3.0F);
  EXPECT_EQ(y[3], 4.5F);
}

TEST(Choice, IsTheFirstOfTheLargest) {
  EXPECT_EQ(eagerx::argmax({1.0F, 3.0F, 3.0F, 2.0F}), 1U);
  EXPECT_EQ(eagerx::argmax({-1.0F}), 0U);
}

/// A layer with weights of eight bits against sums in 64 bits: every bit.
template <Activation A, std::size_t In, std::size_t Out>
void compare_int8(std::uint32_t seed) {
  const auto layer = std::make_unique<eagerx::Int8Weights<In, Out>>();
  Numbers numbers(seed);
  for (std::size_t out = 0; out < Out; ++out) {
    layer->b[out] = numbers.next();
    layer->scale[out] = 0.01F * numbers.next();
    for (std::size_t in = 0; in < In; ++in) {
      // Every other seed has the largest weights there are, so that sums come close to 32 bits.
      layer->w[layer->index(out, in)] =
          static_cast<std::int8_t>(seed % 2 == 0 ? 127.0F : numbers.next() * 15.0F);
    }
  }
  float x[In];
  for (float& value : x) value = seed % 2 == 0 ? 3.0F : numbers.next();
  float y[Out];
  eagerx::dense<A>(*layer, x, y, 0.5F);

  const auto limit = static_cast<float>(eagerx::policy::int8_limit(In));
  float largest = 0.0F;
  for (const float value : x) largest = std::max(largest, std::fabs(value));
  const float factor = limit / largest;
  for (std::size_t out = 0; out < Out; ++out) {
    std::int64_t sum = 0;
    for (std::size_t in = 0; in < In; ++in) {
      const auto q = static_cast<std::int64_t>(std::nearbyintf(x[in] * factor));
      ASSERT_LE(std::abs(q), eagerx::policy::int8_limit(In));
      sum += q * layer->w[layer->index(out, in)];
    }
    ASSERT_LE(std::abs(sum), std::numeric_limits<std::int32_t>::max());
    const float scaled = layer->scale[out] * (largest / limit);
    const float wanted = layer->b[out] + scaled * static_cast<float>(sum);
    EXPECT_EQ(bits_of(y[out]), bits_of(eagerx::policy::activated<A>(wanted, 0.5F))) << out;
  }
}

TEST(Int8, BitsOfPlainLoops) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    compare_int8<Activation::relu, 3, 64>(seed);
    compare_int8<Activation::tanh, 64, 17>(seed);
    compare_int8<Activation::identity, 9, 3>(seed);
    compare_int8<Activation::elu, 1, 1>(seed);
    compare_int8<Activation::identity, 1030, 6>(seed);
  }
}

TEST(Int8, WhatIsNoNumberShowsInAllOutputs) {
  eagerx::Int8Weights<5, 3> layer{};
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    const float x[5] = {1.0F, -2.0F, bad, 0.5F, 3.0F};
    float y[3];
    eagerx::dense<Activation::relu>(layer, x, y);
    for (const float value : y) EXPECT_NE(value, value);
  }
}

TEST(Int8, ZeroGivesTheBias) {
  eagerx::Int8Weights<5, 2> layer{};
  layer.b[1] = 0.25F;
  const float x[5] = {};
  float y[2];
  eagerx::dense<Activation::identity>(layer, x, y);
  EXPECT_EQ(y[0], 0.0F);
  EXPECT_EQ(y[1], 0.25F);
}

/// The fast profile against float64; hashes and bits are never compared.
template <Activation A, std::size_t In, std::size_t Out>
void compare_fast(std::uint32_t seed) {
  const auto layer = std::make_unique<DenseWeights<In, Out>>();
  Numbers numbers(seed);
  float x[In];
  for (float& value : x) value = 0.1F * numbers.next();
  for (std::size_t out = 0; out < Out; ++out) {
    layer->b[out] = numbers.next();
    for (std::size_t in = 0; in < In; ++in) layer->w[layer->index(out, in)] = numbers.next();
  }
  float y[Out];
  eagerx::fast_dense<A>(*layer, x, y, 0.5F);
  for (std::size_t out = 0; out < Out; ++out) {
    double sum = static_cast<double>(layer->b[out]);
    double size = std::fabs(sum);
    for (std::size_t in = 0; in < In; ++in) {
      const double product =
          static_cast<double>(layer->w[layer->index(out, in)]) * static_cast<double>(x[in]);
      sum += product;
      size += std::fabs(product);
    }
    const double wanted = A == Activation::tanh   ? std::tanh(sum)
                          : A == Activation::relu ? std::max(sum, 0.0)
                                                  : sum;
    EXPECT_NEAR(static_cast<double>(y[out]), wanted, 1e-6 * size + 4e-7) << out;
  }
}

TEST(Fast, CloseToFloat64) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    compare_fast<Activation::relu, 3, 64>(seed);
    compare_fast<Activation::tanh, 64, 64>(seed);
    compare_fast<Activation::tanh, 64, 1>(seed);
    compare_fast<Activation::identity, 41, 1>(seed);
    compare_fast<Activation::tanh, 31, 13>(seed);
    compare_fast<Activation::relu, 400, 300>(seed);
  }
}

TEST(Fast, NanStaysNan) {
  DenseWeights<2, 9> layer{};
  const float x[2] = {std::numeric_limits<float>::quiet_NaN(), 1.0F};
  float y[9];
  eagerx::fast_dense<Activation::tanh>(layer, x, y);
  for (const float value : y) EXPECT_NE(value, value);
  eagerx::fast_dense<Activation::relu>(layer, x, y);
  for (const float value : y) EXPECT_NE(value, value);
}

}  // namespace

// The layers of eagerx/policy.hpp against plain loops in the documented order: every bit.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <eagerx/agent.hpp>
#include <eagerx/policy.hpp>
#include <limits>
#include <span>
#include <utility>

#include "tests/support/plain_sum.hpp"
#include "tests/unit/runtime/numbers.hpp"

namespace {

using eagerx::Activation;
using eagerx::DenseWeights;
using eagerx::test::bits_of;
using eagerx::test::Numbers;
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

/// The outputs `y` [outputs] of a layer with `row_major` [outputs, inputs], `bias` and `x`. Not a
/// template: it is compiled once for all sizes.
void expect_plain(Activation activation, std::span<const float> row_major,
                  std::span<const float> bias, std::span<const float> x, std::span<const float> y) {
  for (std::size_t out = 0; out < y.size(); ++out) {
    const float expected = plain_activation(
        activation,
        plain_sum(row_major.data() + out * x.size(), x.data(), x.size(), bias[out], out, y.size()));
    EXPECT_EQ(bits_of(y[out]), bits_of(expected))
        << x.size() << " inputs, output " << out << " of " << y.size() << ": " << y[out]
        << " instead of " << expected;
  }
}

template <Activation A, std::size_t In, std::size_t Out>
void compare(const float (&row_major)[Out * In], const float (&bias)[Out], const float (&x)[In]) {
  static DenseWeights<In, Out> layer;
  for (std::size_t out = 0; out < Out; ++out) {
    layer.b[out] = bias[out];
    for (std::size_t in = 0; in < In; ++in) {
      layer.w[DenseWeights<In, Out>::index(out, in)] = row_major[out * In + in];
    }
  }
  float y[Out];
  eagerx::dense<A>(layer, x, y);
  expect_plain(A, row_major, bias, x, y);
}

template <std::size_t In, std::size_t Out, Activation... A>
void compare_random() {
  static float weights[Out * In];
  float bias[Out];
  float x[In];
  Numbers numbers(static_cast<std::uint32_t>(In * 1000 + Out));
  for (int round = 0; round < 20; ++round) {
    for (float& w : weights) w = numbers.next();
    for (float& b : bias) b = numbers.next();
    for (float& value : x) value = numbers.next();
    (compare<A, In, Out>(weights, bias, x), ...);
  }
}

template <std::size_t In, Activation... A, std::size_t... Out>
void compare_outputs(std::index_sequence<Out...> /*outputs*/) {
  (compare_random<In, Out, A...>(), ...);
}

using ManyOutputs = std::index_sequence<1, 2, 3, 4, 5, 7, 8, 9, 12, 15, 16, 17, 24, 31, 33, 64, 65>;

// Activations see outputs only, so all of them with one number of inputs are enough.
TEST(Policy, IsThePlainLoopToTheBitForFewInputs) {
  compare_outputs<1, Activation::identity>(ManyOutputs{});
  compare_outputs<3, Activation::identity, Activation::relu, Activation::tanh>(ManyOutputs{});
  compare_outputs<7, Activation::identity>(ManyOutputs{});
}

TEST(Policy, IsThePlainLoopToTheBitAroundOneGroupOfInputs) {
  compare_outputs<8, Activation::relu>(ManyOutputs{});
  compare_outputs<9, Activation::identity>(ManyOutputs{});
}

TEST(Policy, IsThePlainLoopToTheBitForManyInputs) {
  compare_outputs<17, Activation::identity>(ManyOutputs{});
  compare_outputs<64, Activation::relu>(ManyOutputs{});
  compare_random<256, 256, Activation::identity, Activation::relu, Activation::tanh>();
  compare_random<400, 300, Activation::identity, Activation::relu, Activation::tanh>();
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

TEST(Choice, OfSeveralNumbersEachHasItsOwnOutputs) {
  using Gears = eagerx::Array<std::int64_t, 3>;
  constexpr eagerx::Space<Gears> kSpace{{0, 0, 2}, {2, 1, 4}};
  constexpr float kScores[] = {1.0F, 3.0F, 3.0F, -2.0F, -1.0F, 0.5F, 0.0F, 0.5F, 9.0F};
  constexpr std::int64_t kWanted[] = {1, 1, 2};
  std::size_t at = 0;
  const Gears gears = eagerx::choices(kSpace, kScores, at);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(eagerx::element(gears, i), kWanted[i]) << i;
  EXPECT_EQ(at, 8U);
}

TEST(Choice, OfBitsIsWhatIsAboveZero) {
  using Lamps = eagerx::Array<std::int8_t, 4>;
  constexpr float kScores[] = {7.0F, -1.0F, 0.0F, 1e-30F, 2.0F};
  std::size_t at = 1;
  const Lamps lamps = eagerx::bits<Lamps>(kScores, at);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(eagerx::element(lamps, i), i < 2 ? 0 : 1) << i;
  EXPECT_EQ(at, 5U);
}

}  // namespace

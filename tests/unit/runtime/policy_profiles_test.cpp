// Layers with weights of eight bits against sums in 64 bits, and the fast profile against float64.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <eagerx/policy.hpp>
#include <eagerx/policy/fast.hpp>
#include <eagerx/policy/int8.hpp>
#include <limits>
#include <memory>

#include "tests/unit/runtime/numbers.hpp"

namespace {

using eagerx::Activation;
using eagerx::DenseWeights;
using eagerx::test::bits_of;
using eagerx::test::Numbers;

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

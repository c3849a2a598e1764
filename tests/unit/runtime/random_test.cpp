// eagerx/random.hpp: known answers, independence of the key's parts, ranges and distributions.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <eagerx/random.hpp>
#include <iterator>
#include <limits>
#include <set>
#include <vector>

namespace eagerx {
namespace {

using Block = std::array<std::uint32_t, 4>;

// From kat_vectors of the Random123 distribution (D. E. Shaw Research), lines "philox4x32 10".
static_assert(philox4x32({0, 0, 0, 0}, {0, 0}) ==
              Block{0x6627e8d5U, 0xe169c58dU, 0xbc57ac4cU, 0x9b00dbd8U});
static_assert(philox4x32({0xffffffffU, 0xffffffffU, 0xffffffffU, 0xffffffffU},
                         {0xffffffffU, 0xffffffffU}) ==
              Block{0x408f276dU, 0x41c83b0eU, 0xa20bc7c6U, 0x6d5451fdU});
static_assert(philox4x32({0x243f6a88U, 0x85a308d3U, 0x13198a2eU, 0x03707344U},
                         {0xa4093822U, 0x299f31d0U}) ==
              Block{0xd16cfe09U, 0x94fdccebU, 0x5001e420U, 0x24126ea1U});

// From the FNV reference test vectors (draft-eastlake-fnv), 32-bit FNV-1a.
static_assert(entity_id("") == 0x811c9dc5U);
static_assert(entity_id("a") == 0xe40c292cU);
static_assert(entity_id("foobar") == 0xbf9cf968U);

TEST(Random, WordsAreTheBlocksOfItsCounter) {
  constexpr EpisodeKey kKey{0x0123456789abcdefU, 7, 8};
  Random random(kKey, 9);
  for (std::uint32_t sample = 0; sample < 3; ++sample) {
    for (const std::uint32_t word : philox4x32({7, 8, 9, sample}, {0x89abcdefU, 0x01234567U})) {
      EXPECT_EQ(random.bits32(), word);
    }
  }
}

TEST(Random, EveryPartOfTheKeyGivesOtherNumbers) {
  std::set<std::uint32_t> first_words;
  for (const EpisodeKey key :
       {EpisodeKey{1, 2, 3}, EpisodeKey{2, 2, 3}, EpisodeKey{1ULL + (1ULL << 32U), 2, 3},
        EpisodeKey{1, 3, 3}, EpisodeKey{1, 2, 4}, EpisodeKey{1, 3, 2}}) {
    for (const char* name : {"pendulum/model_state", "pendulum/model_parameters"}) {
      first_words.insert(Random(key, entity_id(name)).bits32());
    }
  }
  EXPECT_EQ(first_words.size(), 12U);
}

TEST(Random, StepsHaveBlocksOfTheirOwn) {
  constexpr EpisodeKey kKey{5, 6, 7};
  EXPECT_EQ(Random::of_step(kKey, 8, 3, 2).bits32(), Random(kKey, 8, 6).bits32());
  std::set<std::uint32_t> first_words;
  const std::uint64_t steps[] = {0, 1, 1ULL << 31U, (1ULL << 31U) + 1, 1ULL << 32U, 1ULL << 33U};
  for (const std::uint64_t step : steps)
    first_words.insert(Random::of_step(kKey, 8, step, 2).bits32());
  EXPECT_EQ(first_words.size(), std::size(steps));
}

TEST(Random, CopiesSampleTheSame) {
  Random one({5, 6, 7}, 8);
  one.bits32();
  Random other = one;
  for (int i = 0; i < 10; ++i) EXPECT_EQ(one.uniform(0.0, 1.0), other.uniform(0.0, 1.0));
}

template <class T>
class RandomReal : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(RandomReal, Reals);

TYPED_TEST(RandomReal, UniformStaysInItsBounds) {
  using T = TypeParam;
  using Limits = std::numeric_limits<T>;
  const std::array<std::array<T, 2>, 9> bounds = {{{T(-2), T(2)},
                                                   {T(0), T(1)},
                                                   {T(1), T(1) + Limits::epsilon()},
                                                   {T(-0.1), T(0.3)},
                                                   {Limits::lowest(), Limits::max()},
                                                   {Limits::max() / 2, Limits::max()},
                                                   {T(0), Limits::denorm_min()},
                                                   {-Limits::min(), Limits::min()},
                                                   {T(999.9), T(1000)}}};
  Random random({1, 0, 0}, 0);
  for (const auto& [low, high] : bounds) {
    for (int i = 0; i < 20'000; ++i) {
      const T x = random.uniform(low, high);
      ASSERT_GE(x, low);
      ASSERT_LE(x, high);
    }
  }
}

TYPED_TEST(RandomReal, UniformOfEqualBoundsIsTheBound) {
  using T = TypeParam;
  Random random({2, 0, 0}, 0);
  for (const T x : {T(0), T(0.1), T(-3.3), std::numeric_limits<T>::max(),
                    std::numeric_limits<T>::denorm_min()}) {
    for (int i = 0; i < 100; ++i) EXPECT_EQ(random.uniform(x, x), x);
  }
}

// Sums of n independent numbers: each bound is more than five standard deviations away.
TYPED_TEST(RandomReal, UniformIsUniform) {
  using T = TypeParam;
  constexpr int kCount = 160'000;
  std::array<int, 16> bins{};
  Random random({3, 0, 0}, 0);
  for (int i = 0; i < kCount; ++i) {
    ++bins[static_cast<std::size_t>((random.uniform(T(-4), T(4)) + T(4)) * T(2))];
  }
  for (const int count : bins) EXPECT_NEAR(count, kCount / 16, 500);
}

TYPED_TEST(RandomReal, NormalHasItsMoments) {
  using T = TypeParam;
  constexpr int kCount = 400'000;
  Random random({4, 0, 0}, 0);
  std::array<double, 5> moments{};
  int beyond_two = 0;
  for (int i = 0; i < kCount; ++i) {
    const double z = (static_cast<double>(random.normal(T(3), T(2))) - 3.0) / 2.0;
    double power = 1;
    for (double& moment : moments) {
      moment += power / kCount;
      power *= z;
    }
    beyond_two += std::abs(z) > 2 ? 1 : 0;
  }
  EXPECT_NEAR(moments[1], 0, 0.01);
  EXPECT_NEAR(moments[2], 1, 0.015);
  EXPECT_NEAR(moments[3], 0, 0.04);
  EXPECT_NEAR(moments[4], 3, 0.1);
  EXPECT_NEAR(beyond_two, 0.0455 * kCount, 700);
}

TYPED_TEST(RandomReal, NormalWithoutDeviationIsItsMean) {
  Random random({5, 0, 0}, 0);
  for (int i = 0; i < 1000; ++i) {
    EXPECT_EQ(random.normal(TypeParam(1.5), TypeParam(0)), TypeParam(1.5));
  }
}

TYPED_TEST(RandomReal, LogUniformIsUniformInTheLogarithm) {
  using T = TypeParam;
  constexpr int kCount = 60'000;
  Random random({6, 0, 0}, 0);
  std::array<int, 6> decades{};
  for (int i = 0; i < kCount; ++i) {
    const T x = random.log_uniform(T(0.001), T(1000));
    ASSERT_GE(x, T(0.001));
    ASSERT_LE(x, T(1000));
    const auto decade = static_cast<std::size_t>(std::log10(static_cast<double>(x)) + 3.0);
    ++decades[decade < 6 ? decade : 5];
  }
  for (const int count : decades) EXPECT_NEAR(count, kCount / 6, 500);
  EXPECT_EQ(random.log_uniform(T(0.3), T(0.3)), T(0.3));
}

template <class T>
class RandomInteger : public testing::Test {};
using Integers = testing::Types<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t,
                                std::int32_t, std::uint32_t, std::int64_t, std::uint64_t>;
TYPED_TEST_SUITE(RandomInteger, Integers);

TYPED_TEST(RandomInteger, WholeRangeAndEnds) {
  using T = TypeParam;
  using Limits = std::numeric_limits<T>;
  Random random({7, 0, 0}, 0);
  int upper_half = 0;
  for (int i = 0; i < 40'000; ++i) {
    upper_half += random.uniform(Limits::min(), Limits::max()) > Limits::max() / 2 ? 1 : 0;
    ASSERT_GE(random.uniform(T(Limits::max() - 2), Limits::max()), Limits::max() - 2);
    ASSERT_LE(random.uniform(Limits::min(), T(Limits::min() + 2)), Limits::min() + 2);
    ASSERT_EQ(random.uniform(Limits::max(), Limits::max()), Limits::max());
    ASSERT_EQ(random.uniform(Limits::min(), Limits::min()), Limits::min());
  }
  const double expected = Limits::is_signed ? 0.25 : 0.5;
  EXPECT_NEAR(upper_half, expected * 40'000, 600);
}

TYPED_TEST(RandomInteger, EveryValueEquallyOften) {
  using T = TypeParam;
  constexpr int kCount = 70'000;
  Random random({8, 0, 0}, 0);
  std::array<int, 7> counts{};
  for (int i = 0; i < kCount; ++i)
    ++counts[static_cast<std::size_t>(random.uniform(T(10), T(16)) - 10)];
  for (const int count : counts) EXPECT_NEAR(count, kCount / 7, 500);
}

// With 3/4 of 2^32 (or of 2^63), taking the remainder would sample the lower third twice as often.
TEST(Random, LargeRangesAreUnbiased) {
  constexpr int kCount = 90'000;
  Random random({9, 0, 0}, 0);
  int lowest_third = 0;
  int lowest_third_64 = 0;
  for (int i = 0; i < kCount; ++i) {
    lowest_third += random.below(0xc0000000U) < 0x40000000U ? 1 : 0;
    lowest_third_64 += random.uniform<std::uint64_t>(0, 0x5fffffffffffffffU) < 0x2000000000000000U;
  }
  EXPECT_NEAR(lowest_third, kCount / 3, 800);
  EXPECT_NEAR(lowest_third_64, kCount / 3, 800);
}

TEST(Random, RangesJustBeyondThirtyTwoBits) {
  Random random({10, 0, 0}, 0);
  constexpr std::int64_t kSpan = std::int64_t{1} << 32U;
  int above = 0;
  for (int i = 0; i < 10'000; ++i) {
    const std::int64_t x = random.uniform<std::int64_t>(-1, kSpan);
    ASSERT_GE(x, -1);
    ASSERT_LE(x, kSpan);
    above += x >= kSpan / 2 ? 1 : 0;
  }
  EXPECT_NEAR(above, 5000, 300);
}

TEST(Random, Bool) {
  Random random({11, 0, 0}, 0);
  int heads = 0;
  for (int i = 0; i < 10'000; ++i) {
    heads += random.uniform(false, true) ? 1 : 0;
    ASSERT_TRUE(random.uniform(true, true));
    ASSERT_FALSE(random.uniform(false, false));
  }
  EXPECT_NEAR(heads, 5000, 300);
}

TEST(Random, BelowOneIsZero) {
  Random random({12, 0, 0}, 0);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(random.below(1), 0U);
}

// A change of these numbers changes every recorded run.
TEST(Random, SamplesStayTheSame) {
  Random random({42, 1, 2}, entity_id("pendulum/model_state"));
  EXPECT_EQ(random.bits32(), 0xbda37762U);
  EXPECT_EQ(random.uniform(-1.0F, 1.0F), 0x1.394aep-3F);
  EXPECT_EQ(random.uniform(-1.0, 1.0), -0x1.000c6310bec2cp-2);
  EXPECT_EQ(random.normal(0.0F, 1.0F), 0x1.54186cp-1F);
  EXPECT_EQ(random.normal(0.0, 1.0), -0x1.5044c0369a497p+0);
  EXPECT_EQ(random.uniform(-100, 100), -25);
}

}  // namespace
}  // namespace eagerx

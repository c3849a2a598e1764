// The integer addition of doubles that boards without a double unit use, against the host's own.
#include "targets/common/soft_double_add.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <eagerx/random.hpp>

namespace eagerx::board {
namespace {

std::uint64_t bits_of(double x) {
  return std::bit_cast<std::uint64_t>(x);
}
double from_bits(std::uint64_t x) {
  return std::bit_cast<double>(x);
}

/// Empty if equal (all NaN are), otherwise what differs.
std::string difference(std::uint64_t a, std::uint64_t b) {
  const double native = from_bits(a) + from_bits(b);
  const std::uint64_t soft = add_doubles(a, b);
  const bool equal = std::isnan(native) ? std::isnan(from_bits(soft)) : soft == bits_of(native);
  if (equal) return "";
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), "%a + %a = %a, not %a", from_bits(a), from_bits(b),
                native, from_bits(soft));
  return text.data();
}

std::uint64_t random_bits(Random& random) {
  const std::uint64_t high = random.bits32();
  return (high << 32U) | random.bits32();
}

TEST(SoftDoubleAdd, ArbitraryBitPatterns) {
  Random random({1, 0, 0}, 0);
  for (int i = 0; i < 1'000'000; ++i) {
    const std::uint64_t a = random_bits(random);
    ASSERT_EQ(difference(a, random_bits(random)), "");
  }
}

// Where the sum depends on alignment, cancellation and rounding: exponents up to 70 apart.
TEST(SoftDoubleAdd, ExponentsClose) {
  Random random({2, 0, 0}, 0);
  for (int i = 0; i < 3'000'000; ++i) {
    const std::uint64_t a = random_bits(random);
    const std::uint64_t other = random_bits(random);
    const std::uint64_t apart = random.below(71);
    const std::uint64_t exponent = ((a >> 52U) - apart) & 0x7ffU;
    const std::uint64_t b = (other & ~(std::uint64_t{0x7ff} << 52U)) | (exponent << 52U);
    ASSERT_EQ(difference(a, b), "");
    ASSERT_EQ(difference(b, a), "");
  }
}

// The case libgcc 12.2 rounds wrongly: exponents 33 apart, a difference that loses a binary place.
TEST(SoftDoubleAdd, ThirtyThreeApart) {
  Random random({3, 0, 0}, 0);
  int lost_a_place = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    // a is just above a power of two, so that a - b falls below it.
    const double a =
        from_bits(bits_of(1.0) | (random_bits(random) >> (64 - random.uniform(1, 20))));
    const double b = std::ldexp(from_bits(bits_of(1.0) | (random_bits(random) >> 12U)), -33);
    lost_a_place += a - b < 1.0 ? 1 : 0;
    ASSERT_EQ(difference(bits_of(a), bits_of(-b)), "");
    ASSERT_EQ(difference(bits_of(-a), bits_of(b)), "");
  }
  EXPECT_GT(lost_a_place, 100'000);
}

TEST(SoftDoubleAdd, SubnormalsAndSmallNormals) {
  Random random({4, 0, 0}, 0);
  constexpr std::uint64_t kSign = std::uint64_t{1} << 63U;
  for (int i = 0; i < 1'000'000; ++i) {
    const std::uint64_t a = (random_bits(random) >> 9U) ^ (random.below(2) == 0 ? 0 : kSign);
    const std::uint64_t b = (random_bits(random) >> 12U) ^ (random.below(2) == 0 ? 0 : kSign);
    ASSERT_EQ(difference(a, b), "");
  }
}

TEST(SoftDoubleAdd, SpecialValues) {
  const std::array<double, 16> values = {0.0,
                                         -0.0,
                                         1.0,
                                         -1.0,
                                         0x1p-1074,
                                         -0x1p-1074,
                                         0x1p-1022,
                                         -0x1p-1022,
                                         0x1p1023,
                                         -0x1p1023,
                                         INFINITY,
                                         -INFINITY,
                                         0x1.fffffffffffffp1023,
                                         -0x1.fffffffffffffp1023,
                                         NAN,
                                         -NAN};
  for (const double a : values) {
    for (const double b : values) {
      EXPECT_EQ(difference(bits_of(a), bits_of(b)), "");
      const std::uint64_t expected = bits_of(a - b);
      const std::uint64_t soft = subtract_doubles(bits_of(a), bits_of(b));
      EXPECT_TRUE(std::isnan(a - b) ? std::isnan(from_bits(soft)) : soft == expected);
    }
  }
}

}  // namespace
}  // namespace eagerx::board

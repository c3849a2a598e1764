#include "generator/frontend/read/rational.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <random>

namespace eagerx::gen {
namespace {

constexpr std::int64_t kMax = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t kMin = std::numeric_limits<std::int64_t>::min();

void expect_parsed(const char* text, std::int64_t num, std::int64_t den) {
  const auto parsed = Rational::parse(text);
  ASSERT_TRUE(parsed.has_value()) << text;
  EXPECT_EQ(parsed->num(), num) << text;
  EXPECT_EQ(parsed->den(), den) << text;
}

TEST(Rational, Parses) {
  expect_parsed("30", 30, 1);
  expect_parsed("29.97", 2997, 100);
  expect_parsed("0.07", 7, 100);
  expect_parsed("-0.5", -1, 2);
  expect_parsed("+.25", 1, 4);
  expect_parsed("2.", 2, 1);
  expect_parsed("1e-3", 1, 1000);
  expect_parsed("1.5E+3", 1500, 1);
  expect_parsed("1/3", 1, 3);
  expect_parsed("-30000/1001", -30000, 1001);
  expect_parsed("2/-4", -1, 2);
  expect_parsed("0", 0, 1);
  expect_parsed("0e999", 0, 1);
  expect_parsed("-0.000", 0, 1);
  expect_parsed("0.10000000000000000000000000000000000000000000000000", 1, 10);
  expect_parsed("100000000000000000000000000000e-28", 10, 1);
  expect_parsed("5e-19", 1, 2000000000000000000);
  expect_parsed("9223372036854775807", kMax, 1);
  expect_parsed("-9223372036854775808", kMin, 1);
  expect_parsed("922337203685477580.7", kMax, 10);
  expect_parsed("1e0000000000000000000000002", 100, 1);
}

TEST(Rational, RefusesWhatIsNoNumberOrDoesNotFit) {
  for (const char* text : {"",
                           "-",
                           ".",
                           "1/",
                           "/3",
                           "1/0",
                           "1/2/3",
                           "1 /3",
                           "1.5/2",
                           "010",
                           "1e",
                           ".inf",
                           ".nan",
                           "0x1",
                           "1_0",
                           "9223372036854775808",
                           "1e19",
                           "1e-19",
                           "1e99",
                           "1e-99",
                           "1e999999999999999999999",
                           "1e-999999999999999999999",
                           "a",
                           "0.12345678901234567890123456789012345678901234567890"}) {
    EXPECT_EQ(Rational::parse(text), std::nullopt) << text;
  }
}

TEST(Rational, Prints) {
  EXPECT_EQ(Rational(30).to_string(), "30");
  EXPECT_EQ(Rational(2997, 100).to_string(), "29.97");
  EXPECT_EQ(Rational(30, 7).to_string(), "30/7");
  EXPECT_EQ(Rational(-1, 8).to_string(), "-0.125");
  EXPECT_EQ(Rational(-5, 1).to_string(), "-5");
  EXPECT_EQ(Rational(1, 1000).to_string(), "0.001");
  EXPECT_EQ(Rational(kMin).to_string(), "-9223372036854775808");
  EXPECT_EQ(Rational(kMin, 5).to_string(), "-1844674407370955161.6");
  EXPECT_EQ(Rational(1, std::int64_t{1} << 62U).to_string(), "1/4611686018427387904");
  EXPECT_EQ(Rational(1, 0).to_string(), "overflow");
}

TEST(Rational, LowestTerms) {
  EXPECT_EQ(Rational(6, -4).num(), -3);
  EXPECT_EQ(Rational(6, -4).den(), 2);
  EXPECT_EQ(Rational(0, -4).den(), 1);
  EXPECT_EQ(Rational(kMin, kMin), Rational(1));
  EXPECT_TRUE(Rational(1, kMin).overflowed());  // the denominator would be 2^63
  EXPECT_EQ(Rational(2, kMin), Rational(-1, std::int64_t{1} << 62U));
}

TEST(Rational, FloorAndCeil) {
  const struct {
    Rational value;
    std::int64_t floor;
    std::int64_t ceil;
  } cases[] = {{{7, 2}, 3, 4}, {{-7, 2}, -4, -3}, {5, 5, 5},
               {-5, -5, -5},   {0, 0, 0},         {{-1, 3}, -1, 0}};
  for (const auto& test : cases) {
    EXPECT_EQ(test.value.floor(), test.floor) << test.value.to_string();
    EXPECT_EQ(test.value.ceil(), test.ceil) << test.value.to_string();
  }
}

TEST(Rational, OverflowStays) {
  const Rational big(kMax);
  const Rational bad = big + 1;
  EXPECT_TRUE(bad.overflowed());
  EXPECT_TRUE((bad - bad).overflowed());
  EXPECT_TRUE((bad * 0).overflowed());
  EXPECT_TRUE((Rational(1) / bad).overflowed());
  EXPECT_TRUE(gcd(bad, 1).overflowed());
  EXPECT_TRUE(lcm(1, bad).overflowed());
  EXPECT_TRUE((-bad).overflowed());
  EXPECT_TRUE((-Rational(kMin)).overflowed());
  EXPECT_TRUE((big * big).overflowed());
  EXPECT_TRUE((Rational(1) / 0).overflowed());
  EXPECT_TRUE(lcm(big, kMax - 1).overflowed());
  EXPECT_FALSE(bad == bad);
  EXPECT_FALSE(bad < 1);
  EXPECT_FALSE(bad > 1);
  EXPECT_TRUE(std::isnan(bad.to_double()));
  EXPECT_EQ(bad.floor(), 0);
  // Intermediate results may be larger than what comes out.
  EXPECT_EQ(big / kMax * 3, Rational(3));
  EXPECT_EQ(Rational(kMax, 3) * Rational(3, kMax), Rational(1));
  EXPECT_EQ(Rational(kMin) - kMin, Rational(0));
}

TEST(Rational, GcdAndLcm) {
  EXPECT_EQ(gcd(Rational(1, 30), Rational(1, 20)), Rational(1, 60));
  EXPECT_EQ(lcm(Rational(1, 30), Rational(1, 20)), Rational(1, 10));
  EXPECT_EQ(gcd(0, Rational(-3, 4)), Rational(3, 4));
  EXPECT_EQ(gcd(0, 0), Rational(0));
  EXPECT_EQ(lcm(0, 5), Rational(0));
  EXPECT_EQ(lcm(-4, 6), Rational(12));
}

/// Fractions small enough for nothing to overflow, their signs and common factors at random.
class RationalLaws : public testing::Test {
 protected:
  Rational sample() {
    return {number_(engine_), std::max<std::int64_t>(1, std::abs(number_(engine_)))};
  }

  static constexpr int kCount = 20000;

 private:
  std::mt19937_64 engine_{42};
  std::uniform_int_distribution<std::int64_t> number_{-1000, 1000};
};

TEST_F(RationalLaws, Field) {
  for (int i = 0; i < kCount; ++i) {
    const Rational a = sample();
    const Rational b = sample();
    const Rational c = sample();
    ASSERT_EQ(std::gcd(a.num(), a.den()), 1);
    ASSERT_GT(a.den(), 0);
    ASSERT_EQ(a + b, b + a);
    ASSERT_EQ((a + b) + c, a + (b + c));
    ASSERT_EQ((a * b) * c, a * (b * c));
    ASSERT_EQ(a * (b + c), a * b + a * c);
    ASSERT_EQ(a - a, Rational(0));
    ASSERT_EQ(a + b - b, a);
    if (b != 0) {
      ASSERT_EQ(a / b * b, a);
    }
  }
}

// Of up to 18 digits: more than a double has, so that a division of doubles would round twice.
TEST(Rational, IsTheSameDoubleAsItsDecimal) {
  std::mt19937_64 engine{42};
  constexpr std::int64_t kMost = 1'000'000'000'000'000'000;
  std::uniform_int_distribution<std::int64_t> digits{1, kMost - 1};
  for (int i = 0; i < 20'000; ++i) {
    std::string text = std::to_string(digits(engine));
    text.insert(text.size() - static_cast<std::size_t>(i) % text.size(), ".");
    if (text.starts_with('.')) text.insert(0, "0");
    const auto exact = Rational::parse(text);
    ASSERT_TRUE(exact) << text;
    ASSERT_EQ(exact->to_double(), std::strtod(text.c_str(), nullptr)) << text;
    ASSERT_EQ((-*exact).to_double(), -exact->to_double());
  }
  EXPECT_EQ(Rational(kMin).to_double(), -0x1p63);
  EXPECT_EQ(Rational(1, kMax).to_double(), 0x1p-63);
}

TEST_F(RationalLaws, OrderAgreesWithDoubles) {
  for (int i = 0; i < kCount; ++i) {
    const Rational a = sample();
    const Rational b = sample();
    ASSERT_EQ(a < b, a.to_double() < b.to_double());
    ASSERT_EQ(a == b, a.to_double() == b.to_double());
    ASSERT_EQ(a < b, a - b < 0);
    ASSERT_LE(Rational(a.floor()), a);
    ASSERT_GT(Rational(a.floor()) + 1, a);
    ASSERT_GE(Rational(a.ceil()), a);
    ASSERT_LT(Rational(a.ceil()) - 1, a);
  }
}

TEST_F(RationalLaws, GcdDividesAndLcmIsDivided) {
  for (int i = 0; i < kCount; ++i) {
    const Rational a = sample();
    const Rational b = sample();
    if (a == 0 || b == 0) continue;
    const Rational divisor = gcd(a, b);
    const Rational multiple = lcm(a, b);
    const Rational p = a / divisor;
    const Rational q = b / divisor;
    ASSERT_TRUE(p.is_integer() && q.is_integer());
    ASSERT_EQ(std::gcd(p.num(), q.num()), 1);  // the largest one
    ASSERT_TRUE((multiple / a).is_integer() && (multiple / b).is_integer());
    ASSERT_EQ(divisor * multiple, (a * b < 0) ? -(a * b) : a * b);
  }
}

TEST_F(RationalLaws, TextRoundTrip) {
  for (int i = 0; i < kCount; ++i) {
    const Rational a = sample();
    ASSERT_EQ(Rational::parse(a.to_string()), a) << a.to_string();
  }
}

TEST(RationalExtremes, NothingIsUndefined) {
  // Every pair of extreme values; run under the sanitizers this shows undefined behaviour.
  const std::int64_t values[] = {kMin, kMin + 1, -2, -1, 0, 1, 2, kMax - 1, kMax};
  int defined = 0;
  for (const std::int64_t a : values) {
    for (const std::int64_t b : values) {
      for (const std::int64_t c : values) {
        for (const std::int64_t d : values) {
          const Rational x(a, b);
          const Rational y(c, d);
          for (const Rational& r : {x + y, x - y, x * y, x / y, gcd(x, y), lcm(x, y)}) {
            if (r.overflowed()) continue;
            ++defined;
            ASSERT_GT(r.den(), 0);
            ASSERT_EQ(Rational::parse(r.to_string()), r) << r.to_string();
            ASSERT_LE(Rational(r.floor()), r);
          }
        }
      }
    }
  }
  EXPECT_GT(defined, 1000);
}

}  // namespace
}  // namespace eagerx::gen

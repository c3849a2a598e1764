// eagerx/math.hpp: special values, exact functions, and the same bits at compile time as at run
// time. Errors in ulp are measured in math_accuracy_test.cpp.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <eagerx/math.hpp>
#include <eagerx/random.hpp>
#include <eagerx/trace.hpp>
#include <limits>
#include <numbers>

namespace eagerx {
namespace {

template <class T>
class Math : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(Math, Scalars);

template <class T>
constexpr std::array<T, 30> special_values() {
  using Limits = std::numeric_limits<T>;
  return {T(0),
          T(-0.0),
          T(1),
          T(-1),
          T(0.5),
          T(-0.5),
          T(2),
          T(-2),
          T(3),
          T(-3),
          T(1.5),
          T(-1.5),
          T(2.5),
          T(-2.5),
          Limits::infinity(),
          -Limits::infinity(),
          Limits::quiet_NaN(),
          -Limits::quiet_NaN(),
          Limits::min(),
          -Limits::min(),
          Limits::denorm_min(),
          -Limits::denorm_min(),
          Limits::max(),
          -Limits::max(),
          T(0x1p24),
          T(-0x1p23) - 1,
          T(0x1p53),
          T(0x1p52) + 1,
          Limits::epsilon(),
          T(1) - Limits::epsilon()};
}

/// Equal bits; all NaN are equal.
template <class T>
testing::AssertionResult same(T own, T expected) {
  if (canonical_bits(own) == canonical_bits(expected)) return testing::AssertionSuccess();
  return testing::AssertionFailure() << own << " instead of " << expected;
}

/// Same class (NaN, infinity, zero, other) and sign: what C99 says about special cases.
template <class T>
testing::AssertionResult same_kind(T own, T expected) {
  const bool same_sign = std::isnan(expected) || std::signbit(own) == std::signbit(expected);
  if (std::fpclassify(own) == std::fpclassify(expected) && same_sign) {
    return testing::AssertionSuccess();
  }
  return testing::AssertionFailure() << own << " instead of " << expected;
}

template <class T>
T arbitrary(Random& random) {
  const std::uint64_t high = random.bits32();
  return unbits(static_cast<BitsOf<T>>((high << 32U) | random.bits32()));
}

template <class T>
struct UnaryPair {
  const char* name;
  T (*own)(T);
  T (*standard)(T);
};

template <class T>
std::vector<UnaryPair<T>> unary_pairs() {
  return {{"sin", sin<T>, [](T x) { return std::sin(x); }},
          {"cos", cos<T>, [](T x) { return std::cos(x); }},
          {"tan", tan<T>, [](T x) { return std::tan(x); }},
          {"asin", asin<T>, [](T x) { return std::asin(x); }},
          {"acos", acos<T>, [](T x) { return std::acos(x); }},
          {"atan", atan<T>, [](T x) { return std::atan(x); }},
          {"exp", exp<T>, [](T x) { return std::exp(x); }},
          {"log", log<T>, [](T x) { return std::log(x); }},
          {"log10", log10<T>, [](T x) { return std::log10(x); }},
          {"tanh", tanh<T>, [](T x) { return std::tanh(x); }},
          {"sinh", sinh<T>, [](T x) { return std::sinh(x); }},
          {"cosh", cosh<T>, [](T x) { return std::cosh(x); }}};
}

TYPED_TEST(Math, SpecialValuesOfUnaryFunctionsAreThoseOfC) {
  for (const auto& pair : unary_pairs<TypeParam>()) {
    for (const TypeParam x : special_values<TypeParam>()) {
      EXPECT_TRUE(same_kind(pair.own(x), pair.standard(x))) << pair.name << "(" << x << ")";
    }
  }
}

TYPED_TEST(Math, SpecialValuesOfPowAndAtan2AreThoseOfC) {
  for (const TypeParam x : special_values<TypeParam>()) {
    for (const TypeParam y : special_values<TypeParam>()) {
      EXPECT_TRUE(same_kind(pow(x, y), std::pow(x, y))) << "pow(" << x << ", " << y << ")";
      EXPECT_TRUE(same_kind(atan2(x, y), std::atan2(x, y))) << "atan2(" << x << ", " << y << ")";
    }
  }
}

TYPED_TEST(Math, Atan2GivesExactAxesAndQuadrants) {
  using T = TypeParam;
  const T pi = std::numbers::pi_v<T>;
  EXPECT_TRUE(same(atan2(T(0), T(1)), T(0)));
  EXPECT_TRUE(same(atan2(T(-0.0), T(-1)), -pi));
  EXPECT_TRUE(same(atan2(T(2), T(0)), pi / 2));
  EXPECT_TRUE(same(atan2(T(3), T(3)), pi / 4));
  EXPECT_TRUE(same(atan2(T(-3), T(-3)), T(-3) * pi / 4));
}

TYPED_TEST(Math, PowOfIntegersIsExact) {
  using T = TypeParam;
  EXPECT_EQ(pow(T(3), T(2)), T(9));
  EXPECT_EQ(pow(T(-2), T(3)), T(-8));
  EXPECT_EQ(pow(T(-2), T(-2)), T(0.25));
  EXPECT_EQ(pow(T(10), T(5)), T(100000));
  EXPECT_EQ(pow(T(4), T(0.5)), T(2));
  EXPECT_TRUE(isnan(pow(T(-8), T(1) / T(3))));
}

TYPED_TEST(Math, Log10OfPowersOfTenIsExact) {
  using T = TypeParam;
  T power = 1;
  const int largest = sizeof(T) == 4 ? 10 : 22;  // the powers that T holds exactly
  for (int i = 0; i <= largest; ++i, power *= 10) EXPECT_EQ(log10(power), static_cast<T>(i));
}

TYPED_TEST(Math, RoundingIsThatOfC) {
  using T = TypeParam;
  const auto check = [](T x) {
    ASSERT_TRUE(same(floor(x), std::floor(x))) << "floor " << x;
    ASSERT_TRUE(same(ceil(x), std::ceil(x))) << "ceil " << x;
    ASSERT_TRUE(same(trunc(x), std::trunc(x))) << "trunc " << x;
    ASSERT_TRUE(same(round(x), std::round(x))) << "round " << x;
  };
  for (const T x : special_values<T>()) check(x);
  Random random({1, 0, 0}, 0);
  for (int i = 0; i < 300'000; ++i) {
    check(arbitrary<T>(random));
    check(random.uniform(T(-100), T(100)));
    check(static_cast<T>(random.uniform(-1000, 1000)) * T(0.5));
  }
}

TYPED_TEST(Math, FmodIsExact) {
  using T = TypeParam;
  for (const T x : special_values<T>()) {
    for (const T y : special_values<T>()) {
      EXPECT_TRUE(same(fmod(x, y), std::fmod(x, y))) << x << " mod " << y;
    }
  }
  Random random({2, 0, 0}, 0);
  for (int i = 0; i < 100'000; ++i) {
    const T x = arbitrary<T>(random);
    const T y = arbitrary<T>(random);
    ASSERT_TRUE(same(fmod(x, y), std::fmod(x, y))) << x << " mod " << y;
    const T near = random.uniform(T(-1000), T(1000));
    const T step = random.uniform(T(0.001), T(10));
    ASSERT_TRUE(same(fmod(near, step), std::fmod(near, step))) << near << " mod " << step;
    const T small =
        unbits(BitsOf<T>(bits(y) & (FloatFormat<T>::kMantissa | FloatFormat<T>::kSign)));
    ASSERT_TRUE(same(fmod(near, small), std::fmod(near, small))) << near << " mod " << small;
  }
}

TYPED_TEST(Math, SqrtByDigitsIsTheMachinesSqrt) {
  using T = TypeParam;
  for (const T x : special_values<T>()) {
    EXPECT_TRUE(same(detail::sqrt_by_digits(x), std::sqrt(x))) << x;
    EXPECT_TRUE(same(sqrt(x), std::sqrt(x))) << x;
  }
  Random random({3, 0, 0}, 0);
  for (int i = 0; i < 300'000; ++i) {
    const T x = abs(arbitrary<T>(random));
    ASSERT_TRUE(same(detail::sqrt_by_digits(x), std::sqrt(x))) << x;
    const T root = static_cast<T>(random.below(sizeof(T) == 4 ? 4096 : 0x4000000));
    ASSERT_TRUE(same(detail::sqrt_by_digits(root * root), root)) << root;
  }
}

TYPED_TEST(Math, SinCosAreSinAndCos) {
  using T = TypeParam;
  Random random({4, 0, 0}, 0);
  for (int i = 0; i < 100'000; ++i) {
    const T x = arbitrary<T>(random);
    const SinCos<T> both = sincos(x);
    ASSERT_TRUE(same(both.sin, sin(x))) << x;
    ASSERT_TRUE(same(both.cos, cos(x))) << x;
  }
}

// The two ways of reducing an angle meet at 12800 (float) and 1.6e6 (double).
TYPED_TEST(Math, ReductionsAgreeWhereBothWork) {
  using T = TypeParam;
  Random random({5, 0, 0}, 0);
  for (int i = 0; i < 100'000; ++i) {
    const T x = random.uniform(T(2000), detail::TrigonometricConstants<T>::kLargest);
    const auto quick = detail::reduce_to_quadrant(x);
    const auto careful = detail::reduce_huge_angle(x);
    if (abs(careful.angle) > T(0.784)) continue;  // close to pi/4 either quadrant is right
    ASSERT_EQ(quick.quadrant % 4, careful.quadrant % 4) << x;
    ASSERT_LE(abs(quick.angle - careful.angle),
              abs(quick.angle) * std::numeric_limits<T>::epsilon());
  }
}

TEST(Math, HugeFloatsAreReducedToTheBitsOfAllTypes) {
  constexpr std::uint32_t kStep = 997;  // a prime; with 1 there is no difference, either
  constexpr std::uint32_t kFirst = 0x46000000;
  constexpr std::uint32_t kInfinity = 0x7f800000;
  std::uint32_t different = 0;
  for (std::uint32_t pattern = kFirst; pattern < kInfinity; pattern += kStep) {
    for (const std::uint32_t sign : {0U, 0x80000000U}) {
      const float x = unbits(pattern | sign);
      const auto whole = detail::reduce_huge_angle(x);
      const auto quick = detail::reduce_huge_float(x);
      const bool same = bits(quick.angle) == bits(whole.angle) && quick.tail == whole.tail &&
                        bits(quick.quadrant) % 4 == whole.quadrant % 4;
      different += same ? 0 : 1;
    }
  }
  EXPECT_EQ(different, 0U);
  for (const float x : {unbits(kInfinity), -unbits(kInfinity), unbits(kInfinity + 1)})
    EXPECT_TRUE(sin(x) != sin(x)) << x;
}

TYPED_TEST(Math, SigmoidIsSafeEverywhere) {
  using T = TypeParam;
  const T infinity = std::numeric_limits<T>::infinity();
  EXPECT_EQ(sigmoid(T(0)), T(0.5));
  EXPECT_EQ(sigmoid(infinity), T(1));
  EXPECT_EQ(sigmoid(-infinity), T(0));
  EXPECT_EQ(sigmoid(T(10000)), T(1));
  EXPECT_EQ(sigmoid(T(-10000)), T(0));
  EXPECT_GT(sigmoid(T(-80)), T(0));  // 1 / (1 + exp(80)), not rounded away
  EXPECT_TRUE(isnan(sigmoid(std::numeric_limits<T>::quiet_NaN())));
}

TYPED_TEST(Math, MinMaxClampKeepTheirFirstArgumentWhenItIsNaN) {
  using T = TypeParam;
  const T nan = std::numeric_limits<T>::quiet_NaN();
  EXPECT_EQ(min(T(2), T(1)), T(1));
  EXPECT_EQ(max(T(2), T(1)), T(2));
  EXPECT_TRUE(isnan(min(nan, T(1))));
  EXPECT_TRUE(isnan(max(nan, T(1))));
  EXPECT_EQ(min(T(1), nan), T(1));
  EXPECT_EQ(clamp(T(7), T(-1), T(1)), T(1));
  EXPECT_EQ(clamp(T(-7), T(-1), T(1)), T(-1));
  EXPECT_EQ(clamp(T(0.25), T(-1), T(1)), T(0.25));
  EXPECT_TRUE(isnan(clamp(nan, T(-1), T(1))));
  EXPECT_EQ(clamp(9, 1, 6), 6);
}

TYPED_TEST(Math, SignsAndClasses) {
  using T = TypeParam;
  const T infinity = std::numeric_limits<T>::infinity();
  const T nan = std::numeric_limits<T>::quiet_NaN();
  EXPECT_TRUE(same(abs(T(-0.0)), T(0)));
  EXPECT_TRUE(same(copysign(T(3), T(-0.0)), T(-3)));
  EXPECT_TRUE(isfinite(std::numeric_limits<T>::max()));
  EXPECT_FALSE(isfinite(-infinity));
  EXPECT_FALSE(isfinite(nan));
  EXPECT_TRUE(isnan(nan));
  EXPECT_FALSE(isnan(infinity));
}

// Models compute constants such as filter coefficients at compile time.
template <class T>
constexpr std::array<T, 16> values_at(T x) {
  return {sin(x),   cos(x),         tan(x),          asin(x),        acos(x),  atan(x),
          exp(x),   log(x),         sqrt(x),         tanh(x),        log10(x), sinh(x),
          floor(x), pow(x, T(3.7)), atan2(x, T(-2)), fmod(x, T(0.3))};
}
template <class T>
constexpr auto kAtCompileTime = values_at(T(0.7));
template <class T>
constexpr auto kFarAtCompileTime = values_at(T(1));
template <class T>
constexpr T kSinOfHugeAngle = sin(T(1e22));

TYPED_TEST(Math, CompileTimeHasTheSameBitsAsRunTime) {
  using T = TypeParam;
  volatile T x = T(0.7);
  const auto near = values_at<T>(x);
  x = T(1);
  const auto one = values_at<T>(x);
  for (std::size_t i = 0; i < near.size(); ++i) {
    EXPECT_TRUE(same(near[i], kAtCompileTime<T>[i])) << i;
    EXPECT_TRUE(same(one[i], kFarAtCompileTime<T>[i])) << i;
  }
  x = T(1e22);
  EXPECT_TRUE(same(sin(T{x}), kSinOfHugeAngle<T>));
}

static_assert(sqrt(2.0) == std::numbers::sqrt2);
static_assert(sqrt(2.0F) == std::numbers::sqrt2_v<float>);
static_assert(lanes<float> == 1 && any(true) && !any(false));
static_assert(select(true, 1, 2) == 1 && unbits(bits(1.5)) == 1.5);

}  // namespace
}  // namespace eagerx

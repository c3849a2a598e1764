// SIMD vectors against plain numbers: every operation and every function of eagerx/math.hpp gives
// the same bits in each lane. extra.cmake compiles this for the instruction set of this machine,
// too.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/random.hpp>
#include <eagerx/simd.hpp>
#include <limits>
#include <vector>

namespace {

using eagerx::Simd;

template <class T>
using Word = eagerx::BitsOf<T>;

/// Numbers where functions change their ways, and random ones of all sizes.
template <class T>
std::vector<T> arguments() {
  using Format = eagerx::FloatFormat<T>;
  std::vector<T> all{T(0),
                     T(-0.0),
                     T(1),
                     T(-1),
                     T(0.5),
                     T(-2.5),
                     T(3.75),
                     T(1e-30),
                     T(88.9),
                     T(-104),
                     T(12799),
                     T(12801),
                     T(1e30),
                     T(-1e30),
                     Format::infinity,
                     -Format::infinity,
                     Format::nan,
                     Format::smallest_normal,
                     Format::smallest_normal / T(8)};
  eagerx::Random random({7, 0, 0}, 1);
  for (int i = 0; i < 2000; ++i) {
    const T exponent = random.uniform(T(-40), T(40));
    all.push_back(random.uniform(T(-1), T(1)) * eagerx::exp(exponent));
  }
  return all;
}

template <class T>
bool same(T a, T b) {
  return std::bit_cast<Word<T>>(a) == std::bit_cast<Word<T>>(b) || (a != a && b != b);
}

template <class T, std::size_t N>
int differs(const Simd<T, N>& vectorized, std::size_t i, T alone) {
  return !same<T>(eagerx::lane(vectorized, static_cast<int>(i)), alone);
}
template <std::size_t Bytes, std::size_t N>
int differs(const eagerx::Mask<Bytes, N>& vectorized, std::size_t i, bool alone) {
  return eagerx::lane(vectorized, static_cast<int>(i)) != alone;
}

/// All pairs of neighbours and of distant arguments.
template <class T, std::size_t N>
struct Pairs {
  struct Pair {
    std::array<T, N> a, b;
  };
  std::vector<Pair> all;

  Pairs() {
    const std::vector<T> numbers = arguments<T>();
    for (std::size_t start = 0; start < numbers.size(); ++start) {
      Pair& pair = all.emplace_back();
      for (std::size_t i = 0; i < N; ++i) {
        pair.a[i] = numbers[(start + i) % numbers.size()];
        pair.b[i] = numbers[(start * 7 + i * 3 + 1) % numbers.size()];
      }
    }
  }
};

void expect_none(int different, std::size_t lanes, const char* what) {
  EXPECT_EQ(different, 0) << what << ", " << lanes << " lanes";
}

/// f over a SIMD vector and over its lanes.
template <class T, std::size_t N, class F>
void expect_equal_in(const char* what, const F& f) {
  static const Pairs<T, N> pairs;
  int different = 0;
  for (const auto& [a, b] : pairs.all) {
    const auto vectorized = f(Simd<T, N>::load(a.data()), Simd<T, N>::load(b.data()));
    for (std::size_t i = 0; i < N; ++i) different += differs(vectorized, i, f(a[i], b[i]));
  }
  expect_none(different, N, what);
}

/// The same in one register and in several, whatever the machine has.
template <class T, class F>
void expect_equal(const char* what, const F& f) {
  expect_equal_in<T, 16 / sizeof(T)>(what, f);
  expect_equal_in<T, 128 / sizeof(T)>(what, f);
}

template <class T>
void expect_arithmetic() {
  expect_equal<T>("+", [](auto a, auto b) { return a + b; });
  expect_equal<T>("-", [](auto a, auto b) { return a - b; });
  expect_equal<T>("*", [](auto a, auto b) { return a * b; });
  expect_equal<T>("/", [](auto a, auto b) { return a / b; });
  expect_equal<T>("negative", [](auto a, auto) { return -a; });
  expect_equal<T>("<", [](auto a, auto b) { return a < b; });
  expect_equal<T>("<=", [](auto a, auto b) { return a <= b; });
  expect_equal<T>(">", [](auto a, auto b) { return a > b; });
  expect_equal<T>(">=", [](auto a, auto b) { return a >= b; });
  expect_equal<T>("==", [](auto a, auto b) { return a == b; });
  expect_equal<T>("!=", [](auto a, auto b) { return a != b; });
  expect_equal<T>("and, or, not",
                  [](auto a, auto b) { return !(a < b) && (a == b || a > decltype(a)(T(0))); });
  expect_equal<T>("select", [](auto a, auto b) { return eagerx::select(a < b, a, b * b); });
  expect_equal<T>("sqrt", [](auto a, auto) { return eagerx::sqrt(a); });
}

template <class T>
void expect_functions() {
  expect_equal<T>("abs", [](auto a, auto) { return eagerx::abs(a); });
  expect_equal<T>("copysign", [](auto a, auto b) { return eagerx::copysign(a, b); });
  expect_equal<T>("min", [](auto a, auto b) { return eagerx::min(a, b); });
  expect_equal<T>("max", [](auto a, auto b) { return eagerx::max(a, b); });
  expect_equal<T>("isfinite", [](auto a, auto) { return eagerx::isfinite(a); });
  expect_equal<T>("trunc", [](auto a, auto) { return eagerx::trunc(a); });
  expect_equal<T>("floor", [](auto a, auto) { return eagerx::floor(a); });
  expect_equal<T>("ceil", [](auto a, auto) { return eagerx::ceil(a); });
  expect_equal<T>("round", [](auto a, auto) { return eagerx::round(a); });
  expect_equal<T>("fmod", [](auto a, auto b) { return eagerx::fmod(a, b); });
  expect_equal<T>("sin", [](auto a, auto) { return eagerx::sin(a); });
  expect_equal<T>("cos", [](auto a, auto) { return eagerx::cos(a); });
  expect_equal<T>("tan", [](auto a, auto) { return eagerx::tan(a); });
  expect_equal<T>("asin", [](auto a, auto) { return eagerx::asin(a); });
  expect_equal<T>("acos", [](auto a, auto) { return eagerx::acos(a); });
  expect_equal<T>("atan", [](auto a, auto) { return eagerx::atan(a); });
  expect_equal<T>("atan2", [](auto a, auto b) { return eagerx::atan2(a, b); });
  expect_equal<T>("exp", [](auto a, auto) { return eagerx::exp(a); });
  expect_equal<T>("log", [](auto a, auto) { return eagerx::log(a); });
  expect_equal<T>("pow", [](auto a, auto b) { return eagerx::pow(a, b); });
  expect_equal<T>("tanh", [](auto a, auto) { return eagerx::tanh(a); });
  expect_equal<T>("sinh", [](auto a, auto) { return eagerx::sinh(a); });
  expect_equal<T>("cosh", [](auto a, auto) { return eagerx::cosh(a); });
  expect_equal<T>("sigmoid", [](auto a, auto) { return eagerx::sigmoid(a); });
}

TEST(Simd, ArithmeticHasTheBitsOfPlainNumbers) {
  expect_arithmetic<float>();
  expect_arithmetic<double>();
}
TEST(Simd, FunctionsHaveTheBitsOfPlainNumbers) {
  expect_functions<float>();
  expect_functions<double>();
}

TEST(Simd, BroadcastsKeepTheSignOfZero) {
  EXPECT_TRUE(std::signbit(eagerx::lane(Simd<float, 8>(-0.0F), 5)));
  EXPECT_FALSE(std::signbit(eagerx::lane(Simd<float, 8>(0.0F), 5)));
}

TEST(Simd, LanesAreSetOneByOne) {
  Simd<float, 8> x(1.0F);
  set_lane(x, 3, 4.0F);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(eagerx::lane(x, i), i == 3 ? 4.0F : 1.0F);
  eagerx::Mask<4, 8> mask(false);
  EXPECT_FALSE(any(mask));
  set_lane(mask, 7, true);
  EXPECT_TRUE(any(mask));
  EXPECT_TRUE(eagerx::lane(mask, 7));
  EXPECT_FALSE(eagerx::lane(mask, 6));
}

TEST(Simd, IntegersConvertLaneByLane) {
  Simd<std::uint32_t, 8> x(4'000'000'000U);
  set_lane(x, 2, 7U);
  const Simd<std::int64_t, 8> wide(x);
  EXPECT_EQ(eagerx::lane(wide, 0), 4'000'000'000);
  EXPECT_EQ(eagerx::lane(wide, 2), 7);
  const Simd<float, 8> numbers(x);
  EXPECT_EQ(eagerx::lane(numbers, 2), 7.0F);
}

/// Every lane of `from` as To, against static_cast; most and fewest that fit are among them.
template <class To, class From, std::size_t N = 32>
void expect_converted(std::vector<From> numbers) {
  for (std::size_t first = 0; first < numbers.size(); ++first) {
    std::array<From, N> from;
    for (std::size_t i = 0; i < N; ++i) from[i] = numbers[(first + i) % numbers.size()];
    const Simd<To, N> to(Simd<From, N>::load(from.data()));
    for (std::size_t i = 0; i < N; ++i)
      EXPECT_EQ(eagerx::lane(to, static_cast<int>(i)), static_cast<To>(from[i])) << from[i];
    // All alike: the way of numbers of 32 bits, where there is one.
    const Simd<To, N> alike{Simd<From, N>(numbers[first])};
    EXPECT_EQ(eagerx::lane(alike, 3), static_cast<To>(numbers[first])) << numbers[first];
  }
}

TEST(Simd, EachTypeConvertsToEachLaneByLane) {
  using Long = std::numeric_limits<std::int64_t>;
  using Int = std::numeric_limits<std::int32_t>;
  const std::vector<std::int64_t> all = {0,
                                         1,
                                         -1,
                                         Int::max(),
                                         Int::min(),
                                         1LL << 31U,
                                         -(1LL << 32U),
                                         4'294'967'295,
                                         Long::max(),
                                         Long::min(),
                                         16'777'217};
  expect_converted<float>(all);
  expect_converted<std::int32_t>(all);
  expect_converted<std::int8_t>(all);
  expect_converted<std::uint64_t>(all);
  const std::vector<std::uint64_t> naturals = {0,           7,     0x7fffffffU, 0x80000000U,
                                               0xffffffffU, ~0ULL, ~0ULL << 31U};
  expect_converted<float>(naturals);
  expect_converted<std::uint16_t>(naturals);
  const std::vector<float> numbers = {0.0F, -0.0F, 1.9F, -1.9F, 100.0F, -100.0F};
  expect_converted<std::int64_t>(numbers);
  expect_converted<std::int32_t>(numbers);
  expect_converted<std::int8_t>(numbers);
  expect_converted<double>(numbers);
  expect_converted<std::int64_t>(std::vector<float>{5.0F, -0x1p62F, 0x1p40F, 0x1p31F});
  expect_converted<float>(std::vector<std::int8_t>{0, 1, -1, 127, -128});
  expect_converted<std::int64_t>(std::vector<std::uint8_t>{0, 1, 200, 255});
  expect_converted<std::int64_t>(std::vector<std::int16_t>{0, 1, -300, 32767});
}

TEST(Simd, NaturalsThatAreNoWordsAreNotTakenForNegativeOnes) {
  EXPECT_EQ(eagerx::lane(Simd<float, 16>(Simd<std::uint64_t, 16>(~0ULL)), 9), 0x1p64F);
}

TEST(Simd, TruthValuesOfAllWidthsAreTheSame) {
  Simd<float, 64> x(0.0F);
  std::uint64_t wanted = 0;
  for (int i = 0; i < 64; i += 5) {
    set_lane(x, i, 1.0F);
    wanted |= std::uint64_t{1} << static_cast<unsigned>(i);
  }
  const auto mask = x > Simd<float, 64>(0.5F);
  EXPECT_EQ(eagerx::lane_bits(mask), wanted);
  EXPECT_EQ(eagerx::lane_bits(!mask), ~wanted);
  const eagerx::Mask<8, 64> wide(mask);
  const eagerx::Mask<1, 64> narrow(wide);
  for (int i = 0; i < 64; ++i) {
    EXPECT_EQ(eagerx::lane(wide, i), i % 5 == 0) << i;
    EXPECT_EQ(eagerx::lane(narrow, i), i % 5 == 0) << i;
  }
  EXPECT_EQ(eagerx::lane_bits(eagerx::Mask<4, 64>(narrow)), wanted);
}

TEST(Simd, AnyLaneCounts) {
  for (int i = 0; i < 64; ++i) {
    eagerx::Mask<4, 64> mask(false);
    EXPECT_FALSE(any(mask));
    set_lane(mask, i, true);
    EXPECT_TRUE(any(mask)) << i;
  }
}

TEST(Simd, RegistersMayBeNarrowerThanTheMachines) {
  using Narrow = Simd<float, 24, 8>;  // no power of two
  static_assert(Narrow::kCount == 3);
  Narrow x(2.0F);
  set_lane(x, 17, 9.0F);
  const Narrow roots = eagerx::sqrt(x * x) + Narrow(1.0F);
  for (int i = 0; i < 24; ++i) EXPECT_EQ(eagerx::lane(roots, i), i == 17 ? 10.0F : 3.0F);
}

TEST(Simd, MessagesConsistOfSimd) {
  using Message = eagerx::Array<Simd<float, 8>, 2>;
  static_assert(eagerx::size_of<Message> == 2);
  Message message{};
  set_lane(eagerx::element(message, 1), 4, 2.5F);
  EXPECT_EQ(eagerx::lane(message[1], 4), 2.5F);
  EXPECT_EQ(eagerx::lane(message[0], 4), 0.0F);
}

}  // namespace

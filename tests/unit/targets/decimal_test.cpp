// Numbers as boards print them, against std::to_chars and std::from_chars of the host.
#include "targets/common/bare-metal/decimal.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <eagerx/random.hpp>
#include <limits>
#include <string>

namespace eagerx::board {
namespace {

template <class T>
std::string decimal(T value) {
  char text[Decimal<T>::kLongestText];
  return {text, Decimal<T>::write(text, value)};
}

template <class T>
std::string integer(T value) {
  char text[kLongestInteger];
  return {text, write_integer(text, value)};
}

template <class T>
std::string reference(T value) {
  char text[Decimal<T>::kLongestText];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

template <class T>
bool reads_back(const std::string& text, T value) {
  T parsed{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), parsed);
  return error == std::errc() && end == text.data() + text.size() && parsed == value &&
         std::signbit(parsed) == std::signbit(value);
}

/// Arbitrary bits, decimals with few digits and whole numbers in turn.
template <class T, class Bits>
T sample(Random& random, int i) {
  constexpr int kKinds = 3;
  if (i % kKinds == 0) {
    const std::uint64_t bits = (std::uint64_t{random.bits32()} << 32U) | random.bits32();
    return std::bit_cast<T>(static_cast<Bits>(bits));
  }
  const auto whole = static_cast<T>(static_cast<std::int32_t>(random.bits32()));
  return i % kKinds == 1 ? whole / T{1000} : whole * static_cast<T>(random.below(1000000));
}

/// Powers of two may have a digit more than needed.
template <class T>
bool is_power_of_two(T value) {
  int exponent = 0;
  return std::abs(std::frexp(value, &exponent)) == T(0.5);
}

template <class T, class Bits>
void check_samples(int count) {
  Random random({1, 0, 0}, 7);
  for (int i = 0; i < count; ++i) {
    const T value = sample<T, Bits>(random, i);
    if (std::isnan(value)) continue;
    const std::string text = decimal(value);
    ASSERT_TRUE(reads_back(text, value)) << text << " for " << reference(value);
    if (is_power_of_two(value)) continue;
    ASSERT_EQ(text, reference(value));
  }
}

TEST(Decimal, FloatsAreTheShortestTextThatReadsBack) {
  check_samples<float, std::uint32_t>(30000);
}

TEST(Decimal, DoublesAreTheShortestTextThatReadsBack) {
  check_samples<double, std::uint64_t>(3000);
}

TEST(Decimal, SpecialFloats) {
  using Limits = std::numeric_limits<float>;
  EXPECT_EQ(decimal(0.0F), "0");
  EXPECT_EQ(decimal(-0.0F), "-0");
  EXPECT_EQ(decimal(1.0F), "1");
  EXPECT_EQ(decimal(0.1F), "0.1");
  EXPECT_EQ(decimal(-999.0F), "-999");
  EXPECT_EQ(decimal(Limits::infinity()), "inf");
  EXPECT_EQ(decimal(-Limits::infinity()), "-inf");
  EXPECT_EQ(decimal(Limits::quiet_NaN()), "nan");
  EXPECT_EQ(decimal(-Limits::quiet_NaN()), "nan");
  EXPECT_EQ(decimal(Limits::max()), "3.4028235e+38");
  EXPECT_EQ(decimal(Limits::denorm_min()), "1e-45");
}

TEST(Decimal, SpecialDoubles) {
  using Limits = std::numeric_limits<double>;
  EXPECT_EQ(decimal(1.0 / 3.0), "0.3333333333333333");
  EXPECT_EQ(decimal(Limits::max()), "1.7976931348623157e+308");
  EXPECT_EQ(decimal(Limits::denorm_min()), "5e-324");
  EXPECT_EQ(decimal(1e22), "1e+22");
}

TEST(Decimal, PowersOfTwoReadBack) {
  for (int exponent = -149; exponent < 128; ++exponent) {
    const float value = std::ldexp(1.0F, exponent);
    EXPECT_TRUE(reads_back(decimal(value), value)) << decimal(value);
  }
}

TEST(Decimal, Integers) {
  EXPECT_EQ(integer(0), "0");
  EXPECT_EQ(integer(std::uint8_t{200}), "200");
  EXPECT_EQ(integer(std::numeric_limits<std::int64_t>::min()), "-9223372036854775808");
  EXPECT_EQ(integer(std::numeric_limits<std::int64_t>::max()), "9223372036854775807");
  EXPECT_EQ(integer(std::numeric_limits<std::uint64_t>::max()), "18446744073709551615");
}

}  // namespace
}  // namespace eagerx::board

// Reduction of huge angles: x modulo pi/2 with as many digits of 2/pi as x asks for (Payne and
// Hanek 1983), in integers.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <eagerx/math/polynomial.hpp>
#include <eagerx/math/vocabulary.hpp>
#include <type_traits>

namespace eagerx::detail {

/// x = angle + tail + quadrant * pi/2; |angle| <= pi/4, `tail` is the part that does not fit into
/// `angle`, and only the last two bits of `quadrant` count.
template <class R>
struct Reduced {
  R angle;
  R tail;
  BitsOf<R> quadrant;
};

/// 2/pi as a binary fraction, most significant word first, after two words of zeros, for numbers
/// whose last bit is below 2^2.
inline constexpr std::array<std::uint32_t, 40> kTwoOverPiWords = {
    0x00000000U, 0x00000000U, 0xa2f9836eU, 0x4e441529U, 0xfc2757d1U, 0xf534ddc0U, 0xdb629599U,
    0x3c439041U, 0xfe5163abU, 0xdebbc561U, 0xb7246e3aU, 0x424dd2e0U, 0x06492eeaU, 0x09d1921cU,
    0xfe1deb1cU, 0xb129a73eU, 0xe88235f5U, 0x2ebb4484U, 0xe99c7026U, 0xb45f7e41U, 0x3991d639U,
    0x835339f4U, 0x9c845f8bU, 0xbdf9283bU, 0x1ff897ffU, 0xde05980fU, 0xef2f118bU, 0x5a0a6d1fU,
    0x6d367ecfU, 0x27cb09b7U, 0x4f463f66U, 0x9e5fea2dU, 0x7527bac7U, 0xebe5f17bU, 0x3d0739f7U,
    0x8a5292eaU, 0x6bfb5fb1U, 0x1f8d5d08U, 0x56033046U, 0xfc7b6babU};

/// A fixed-point number of N words, most significant first.
template <std::size_t N>
using Words = std::array<std::uint32_t, N>;

/// The 32 bits from bit `first` on, counted from the most significant; zeros after the end.
template <std::size_t N>
constexpr std::uint32_t bits_at(const Words<N>& words, int first) {
  const auto at = static_cast<std::size_t>(first / 32);
  const std::uint64_t high = at < N ? words[at] : 0;
  const std::uint64_t low = at + 1 < N ? words[at + 1] : 0;
  return static_cast<std::uint32_t>(((high << 32U) | low) >> (32 - first % 32));
}

/// words * factor * 2^(32 place), modulo the size of Words.
template <std::size_t N>
constexpr Words<N> multiply(const Words<N>& words, std::uint32_t factor, std::size_t place) {
  Words<N> product{};
  std::uint64_t carry = 0;
  for (std::size_t i = N; i-- > place;) {
    carry += std::uint64_t{words[i]} * factor;
    product[i - place] = static_cast<std::uint32_t>(carry);
    carry >>= 32U;
  }
  return product;
}

template <std::size_t N>
constexpr Words<N> add(const Words<N>& a, const Words<N>& b) {
  Words<N> sum{};
  std::uint64_t carry = 0;
  for (std::size_t i = N; i-- > 0;) {
    carry += std::uint64_t{a[i]} + b[i];
    sum[i] = static_cast<std::uint32_t>(carry);
    carry >>= 32U;
  }
  return sum;
}

/// The `FloatFormat<T>::kDigits` bits from bit `first` on, as a number.
template <class T, std::size_t N>
constexpr T digits_at(const Words<N>& words, int first) {
  if constexpr (sizeof(T) == 4) {
    return static_cast<T>(bits_at(words, first) >> 8U);
  } else {
    const std::uint64_t high = bits_at(words, first);
    return static_cast<T>(((high << 32U) | bits_at(words, first + 32)) >> 11U);
  }
}

template <class T>
struct PayneHanekConstants;
template <>
struct PayneHanekConstants<float> {
  static constexpr float kHalfPi = 0x1.921fb6p0F;
  static constexpr float kHalfPiLow = -0x1.777a5cp-25F;
};
template <>
struct PayneHanekConstants<double> {
  static constexpr double kHalfPi = 0x1.921fb54442d18p0;
  static constexpr double kHalfPiLow = 0x1.1a62633145c07p-54;
};

/// x * 2/pi modulo 4, as a fixed-point number with two bits before the point; x > 2^10, finite.
template <class T>
constexpr auto quadrants_of(T x) {
  using Format = FloatFormat<T>;
  // No float is closer than 2^-30 to a multiple of pi/2, relative to pi/2, no double than 2^-62:
  // this many words leave the digits of a number, and those of its tail, after the cancellation.
  constexpr std::size_t kWords = sizeof(T) == 4 ? 3 : 6;
  const BitsOf<T> magnitude = bits(x) & ~Format::kSign;
  const std::uint64_t mantissa =
      (magnitude & Format::kMantissa) | (BitsOf<T>{1} << Format::kMantissaBits);
  const int exponent =  // x = mantissa * 2^exponent
      static_cast<int>(magnitude >> Format::kMantissaBits) - Format::kBias - Format::kMantissaBits;
  // Digits of 2/pi before this one give multiples of 4 in the product, and count for nothing.
  const int first = 64 + exponent - 2;
  Words<kWords> window{};
  for (std::size_t i = 0; i < kWords; ++i) {
    window[i] = bits_at(kTwoOverPiWords, first + static_cast<int>(32 * i));
  }
  Words<kWords> product = multiply(window, static_cast<std::uint32_t>(mantissa), 0);
  if constexpr (sizeof(T) == 8) {
    product = add(product, multiply(window, static_cast<std::uint32_t>(mantissa >> 32U), 1));
  }
  return product;
}

/// The upper word of high and low, together shifted to the left by less than 32.
constexpr std::uint32_t shifted(std::uint32_t high, std::uint32_t low, unsigned by) {
  return (high << by) | ((low >> 1U) >> (31 - by));
}

/// exact_product(), with the same bits from the core's fused multiply-add if it has one.
[[gnu::always_inline]] constexpr TwoWords<float> exact_product_of_floats(float a, float b) {
#if defined(__ARM_FEATURE_FMA) && defined(__OPTIMIZE__)
  const float product = a * b;
  if (!std::is_constant_evaluated()) return {product, __builtin_fmaf(a, b, -product)};
#endif
  return exact_product(a, b);
}

/// A reduced float that three floating-point registers can return: `quadrant` by its bits.
struct ReducedFloat {
  float angle, tail, quadrant;
};

/// reduce_huge_angle() for floats. It has no loop and one branch, so that the bound of its
/// instructions is tight: programs for boards are planned with this path.
[[gnu::noinline]] constexpr ReducedFloat reduce_huge_float(float x) {
  using Format = FloatFormat<float>;
  constexpr unsigned kWordBits = 32;
  const std::uint32_t pattern = bits(x);
  const std::uint32_t exponent = (pattern & Format::kInfinity) >> Format::kMantissaBits;
  if (exponent == Format::kInfinity >> Format::kMantissaBits) return {Format::nan, Format::nan, 0};
  const std::uint32_t mantissa = (pattern & Format::kMantissa) | (1U << Format::kMantissaBits);
  // As in quadrants_of(): three words of 2/pi, their product modulo 2^96.
  constexpr unsigned kBelowFirst = Format::kBias + Format::kMantissaBits - 64 + 2;
  const std::uint32_t first = exponent - kBelowFirst;
  const std::uint32_t* word = kTwoOverPiWords.data() + first / kWordBits;
  const unsigned by = first % kWordBits;
  const std::uint64_t last = std::uint64_t{shifted(word[2], word[3], by)} * mantissa;
  const std::uint64_t middle =
      std::uint64_t{shifted(word[1], word[2], by)} * mantissa + (last >> kWordBits);
  std::uint32_t high =
      shifted(word[0], word[1], by) * mantissa + static_cast<std::uint32_t>(middle >> kWordBits);
  // To the nearest quadrant: past the middle, count from the next one, backwards.
  const std::uint32_t backwards = (high >> 29U) & 1U;
  std::uint32_t quadrant = (high >> 30U) + backwards;
  const std::uint32_t negated = 0U - backwards;  // all but the last bit
  high = (high ^ negated) & 0x3fffffffU;
  std::uint32_t low = static_cast<std::uint32_t>(middle) ^ negated;
  std::uint32_t rest = static_cast<std::uint32_t>(last) ^ negated;
  unsigned zeros = 0;
  if (high == 0) {  // then not in `low`, too
    high = low;
    low = rest;
    rest = 0;
    zeros = kWordBits;
  }
  const auto leading = static_cast<unsigned>(std::countl_zero(high));
  zeros += leading;
  high = shifted(high, low, leading);
  low = shifted(low, rest, leading);
  // In quadrants, then in rad: (a + b) * pi/2, with the sign of all of it.
  const std::uint32_t sign = pattern >> (kWordBits - 1);
  const std::uint32_t scale =
      ((static_cast<std::uint32_t>(Format::kBias + 2 - Format::kDigits) - zeros)
       << Format::kMantissaBits) |
      ((sign ^ backwards) << (kWordBits - 1));
  const std::uint32_t scale_of_b =
      scale - (std::uint32_t{Format::kDigits} << Format::kMantissaBits);
  const float a = static_cast<float>(static_cast<std::int32_t>(high >> 8U)) * unbits(scale);
  const float b =
      static_cast<float>(static_cast<std::int32_t>(((high & 0xffU) << 16U) | (low >> 16U))) *
      unbits(scale_of_b);
  using Constants = PayneHanekConstants<float>;
  const TwoWords<float> product = exact_product_of_floats(a, Constants::kHalfPi);
  const float left = product.low + (a * Constants::kHalfPiLow + b * Constants::kHalfPi);
  const float angle = product.high + left;
  quadrant = (quadrant ^ (0U - sign)) + sign;  // -quadrant of a negative angle
  return {angle, (product.high - angle) + left, unbits(quadrant)};
}

/// Reduces one angle beyond the range of the quick reduction; NaN for infinities and NaN.
template <class T>
[[gnu::noinline]] constexpr Reduced<T> reduce_huge_angle(T x) {
  using Format = FloatFormat<T>;
  using Bits = BitsOf<T>;
  if ((bits(x) & Format::kInfinity) == Format::kInfinity) return {Format::nan, Format::nan, 0};
  auto turns = quadrants_of(x);
  std::uint32_t quadrant = turns[0] >> 30U;
  // To the nearest quadrant: past the middle, count from the next one, backwards.
  const bool backwards = (turns[0] >> 29U) % 2 != 0;
  if (backwards) {
    ++quadrant;
    for (std::uint32_t& word : turns) word = ~word;  // negates: all but the last bit
  }
  turns[0] &= 0x3fffffffU;
  int zeros = 0;
  for (const std::uint32_t word : turns) {
    zeros += std::countl_zero(word);
    if (word != 0) break;
  }
  // In quadrants, then in rad: (high + low) * 2^scale, then times pi/2.
  const T scale = power_of_two<T>(2 - zeros - Format::kDigits);
  const T high = digits_at<T>(turns, zeros) * scale;
  const T low =
      digits_at<T>(turns, zeros + Format::kDigits) * scale * power_of_two<T>(-Format::kDigits);
  using Constants = PayneHanekConstants<T>;
  const TwoWords<T> product = exact_product(high, Constants::kHalfPi);
  const T rest = product.low + (high * Constants::kHalfPiLow + low * Constants::kHalfPi);
  Reduced<T> reduced{product.high + rest, 0, quadrant};
  reduced.tail = (product.high - reduced.angle) + rest;
  const bool negative = (bits(x) & Format::kSign) != 0;
  if (negative != backwards) {
    reduced.angle = -reduced.angle;
    reduced.tail = -reduced.tail;
  }
  if (negative) reduced.quadrant = static_cast<Bits>(4U - quadrant);
  return reduced;
}

}  // namespace eagerx::detail

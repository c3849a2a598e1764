// Square root: IEEE 754 demands it correctly rounded, so every target's own has the same bits.
#pragma once

#include <eagerx/math/vocabulary.hpp>
#include <type_traits>

namespace eagerx {
namespace detail {

/// Correctly rounded square root, one binary digit at a time: for the compiler, whose built-in
/// square root is not always a constant expression (clang).
template <class T>
constexpr T sqrt_by_digits(T x) {
  using Format = FloatFormat<T>;
  using Bits = BitsOf<T>;
  if (x != x || x == T{0} || x == Format::infinity) return x;
  if (x < T{0}) return Format::nan;
  int exponent = 0;  // x = mantissa * 2^exponent
  if (x < Format::smallest_normal) {
    x *= power_of_two<T>(Format::kDigits);
    exponent = -Format::kDigits;
  }
  exponent +=
      static_cast<int>(bits(x) >> Format::kMantissaBits) - Format::kBias - Format::kMantissaBits;
  Bits mantissa = (bits(x) & Format::kMantissa) | (Bits{1} << Format::kMantissaBits);
  // The root of mantissa * 2^kRootDigits has kRootDigits digits, one more than fits: it decides the
  // rounding. A tie is impossible, as its square would have more digits than x.
  constexpr int kRootDigits = Format::kDigits + 1;
  if ((exponent - kRootDigits) % 2 != 0) {
    mantissa <<= 1;
    --exponent;
  }
  // As on paper: bring down two digits of the mantissa, later zeros, for each digit of the root.
  mantissa <<= Format::kWidth - kRootDigits;
  Bits root = 0;
  Bits rest = 0;
  for (int i = 0; i < kRootDigits; ++i) {
    rest = (rest << 2) | (mantissa >> (Format::kWidth - 2));
    mantissa <<= 2;
    const Bits trial = (root << 2) | 1U;
    root <<= 1;
    if (rest >= trial) {
      rest -= trial;
      root |= 1U;
    }
  }
  root = (root + 1) >> 1;
  return static_cast<T>(root) * power_of_two<T>((exponent - kRootDigits) / 2 + 1);
}

}  // namespace detail

/// Square root. Correctly rounded: 0.5 ulp. NaN below zero, -0 for -0.
constexpr float sqrt(float x) {
  if (std::is_constant_evaluated()) return detail::sqrt_by_digits(x);
  return __builtin_sqrtf(x);
}
constexpr double sqrt(double x) {
  if (std::is_constant_evaluated()) return detail::sqrt_by_digits(x);
  return __builtin_sqrt(x);
}

}  // namespace eagerx

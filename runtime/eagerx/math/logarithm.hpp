// Natural and decimal logarithm.
#pragma once

#include <array>
#include <eagerx/math/polynomial.hpp>
#include <eagerx/math/vocabulary.hpp>

namespace eagerx {
namespace detail {

/// Coefficients (highest degree first) from tests/accuracy/coefficients.sollya.
template <class T>
struct LogarithmConstants;
template <>
struct LogarithmConstants<float> {
  static constexpr std::uint32_t kSqrtHalf = 0x3f3504f3U;  // bits of sqrt(1/2)
  static constexpr float kLn2High = 0x1.62e4p-1F;
  static constexpr float kLn2Low = 0x1.7f7d1cp-20F;
  static constexpr float kLog2High = 0x1.344p-2F;  // log10(2)
  static constexpr float kLog2Low = 0x1.3509f8p-18F;
  static constexpr float kLogEHigh = 0x1.bcap-2F;  // log10(e)
  static constexpr float kLogELow = 0x1.7b1526p-14F;
  static constexpr std::uint32_t kHighHalf =
      0xfffff000U;  // the bits that times kLogEHigh are exact
  static constexpr std::array<float, 4> kLog = {0x1.ec1e3cp-3F, 0x1.23f1ap-2F, 0x1.999bd4p-2F,
                                                0x1.555554p-1F};
};
template <>
struct LogarithmConstants<double> {
  static constexpr std::uint64_t kSqrtHalf = 0x3fe6a09e667f3bcdU;
  static constexpr double kLn2High = 0x1.62e42fefa38p-1;
  static constexpr double kLn2Low = 0x1.ef35793c7673p-45;
  static constexpr double kLog2High = 0x1.34413509f78p-2;
  static constexpr double kLog2Low = 0x1.fef311f12b358p-46;
  static constexpr double kLogEHigh = 0x1.bcb7b1p-2;
  static constexpr double kLogELow = 0x1.49b9438ca9aaep-28;
  static constexpr std::uint64_t kHighHalf = 0xfffffffff8000000U;
  static constexpr std::array<double, 7> kLog = {
      0x1.2f041b8c9d05ep-3, 0x1.39a1e2db12308p-3, 0x1.74663d0456acbp-3, 0x1.c71c5214811ddp-3,
      0x1.24924941e0829p-2, 0x1.999999997ff2bp-2, 0x1.5555555555592p-1};
};

/// x = (1 + f) 2^k with sqrt(1/2) <= 1 + f < sqrt(2), both exact.
template <class R>
struct LogarithmParts {
  R k;
  R f;
};

/// Parts of a positive finite number, subnormal ones too.
template <class R>
[[gnu::always_inline]] constexpr LogarithmParts<R> logarithm_parts(R x) {
  using T = LaneOf<R>;
  using Bits = BitsOf<R>;
  using Format = FloatFormat<T>;
  constexpr auto kSqrtHalf = LogarithmConstants<T>::kSqrtHalf;
  const auto subnormal = x < R(Format::smallest_normal);
  const R normal = select(subnormal, x * R(power_of_two<T>(Format::kDigits)), x);
  const R offset = select(subnormal, R(static_cast<T>(-Format::kDigits)), R(T(0)));
  const Bits b = bits(normal) + Bits(Format::kOne - kSqrtHalf);
  const R mantissa = unbits((b & Bits(Format::kMantissa)) + Bits(kSqrtHalf));
  // The exponent as a number: put it into the low bits of kRounder.
  const Bits exponent = b >> Format::kMantissaBits;
  const R shifted = unbits(exponent + Bits(bits(Format::kRounder) - Format::kBias));
  return {(shifted - R(Format::kRounder)) + offset, mantissa - R(T(1))};
}

/// `y` for positive finite x; what the logarithm of everything else is.
template <class R>
[[gnu::always_inline]] constexpr R logarithm_special_cases(R x, R y) {
  using T = LaneOf<R>;
  const R infinity = R(FloatFormat<T>::infinity);
  y = select(x == infinity, infinity, y);
  y = select(x == R(T(0)), -infinity, y);
  return select(x >= R(T(0)), y, R(FloatFormat<T>::nan));
}

/// log(1 + f) = f - (half_square - correction), in parts. With s = f / (2 + f) (as in fdlibm).
template <class R>
struct Log1pParts {
  R half_square;
  R correction;
};
template <class R>
[[gnu::always_inline]] constexpr Log1pParts<R> log1p_parts(R f) {
  using T = LaneOf<R>;
  const R s = f / (R(T(2)) + f);
  const R square = s * s;
  const R half_square = R(T(0.5)) * f * f;
  return {half_square, s * (half_square + square * horner(square, LogarithmConstants<T>::kLog))};
}

}  // namespace detail

/// Natural logarithm. Largest measured error: 0.85 ulp. -infinity for 0, NaN below.
template <Floating R>
constexpr R log(R x) {
  using Constants = detail::LogarithmConstants<LaneOf<R>>;
  const auto [k, f] = detail::logarithm_parts(x);
  const detail::Log1pParts<R> parts = detail::log1p_parts(f);
  const R low = parts.correction + k * R(Constants::kLn2Low);
  return detail::logarithm_special_cases(
      x, k * R(Constants::kLn2High) - ((parts.half_square - low) - f));
}

/// Decimal logarithm, exact for powers of ten. Largest measured error: 0.75 ulp. -infinity for 0,
/// NaN below.
template <Floating R>
constexpr R log10(R x) {
  using Constants = detail::LogarithmConstants<LaneOf<R>>;
  const auto [k, f] = detail::logarithm_parts(x);
  const detail::Log1pParts<R> parts = detail::log1p_parts(f);
  // log(1 + f) in two words, the first short enough for an exact product (as in FreeBSD's log10).
  const R high = unbits(bits(f - parts.half_square) & BitsOf<R>(Constants::kHighHalf));
  const R low = ((f - high) - parts.half_square) + parts.correction;
  const R octaves = k * R(Constants::kLog2High);
  const R rest = high * R(Constants::kLogEHigh);
  const R sum = octaves + rest;
  const R lost = (octaves - sum) + rest;
  const R small = k * R(Constants::kLog2Low) + (low + high) * R(Constants::kLogELow) +
                  low * R(Constants::kLogEHigh);
  return detail::logarithm_special_cases(x, sum + (small + lost));
}

}  // namespace eagerx

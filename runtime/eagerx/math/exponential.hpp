// The exponential function, and its parts that other functions use.
#pragma once

#include <array>
#include <eagerx/math/basic.hpp>
#include <eagerx/math/polynomial.hpp>
#include <eagerx/math/vocabulary.hpp>

namespace eagerx {
namespace detail {

/// Coefficients (highest degree first) from tests/accuracy/coefficients.sollya.
template <class T>
struct ExponentialConstants;
template <>
struct ExponentialConstants<float> {
  static constexpr float kLowest = -105.0F;  // exp is 0 below,
  static constexpr float kHighest = 90.0F;   // infinity above
  static constexpr float kLog2E = 0x1.715476p0F;
  static constexpr float kLn2High = 0x1.62e4p-1F;
  static constexpr float kLn2Low = 0x1.7f7d1cp-20F;
  static constexpr std::array<float, 5> kExpm1 = {0x1.6b71a8p-10F, 0x1.1227c2p-7F, 0x1.555718p-5F,
                                                  0x1.5554bp-3F, 0x1.fffffep-2F};
};
template <>
struct ExponentialConstants<double> {
  static constexpr double kLowest = -746.0;
  static constexpr double kHighest = 710.0;
  static constexpr double kLog2E = 0x1.71547652b82fep0;
  static constexpr double kLn2High = 0x1.62e42fefa38p-1;
  static constexpr double kLn2Low = 0x1.ef35793c7673p-45;
  static constexpr std::array<double, 11> kExpm1 = {0x1.1f1a80b9a0138p-29,
                                                    0x1.af5f7219ed364p-26,
                                                    0x1.27e51320fef1dp-22,
                                                    0x1.71ddf7eeb87b5p-19,
                                                    0x1.a01a018e123e4p-16,
                                                    0x1.a01a01b00d184p-13,
                                                    0x1.6c16c16c1ab02p-10,
                                                    0x1.111111110f647p-7,
                                                    0x1.555555555554dp-5,
                                                    0x1.5555555555559p-3,
                                                    0.5};
};

/// exp(x) = 2^n (1 + expm1), |log(2^n) - x| <= log(2)/2.
template <class R>
struct ExponentialParts {
  BitsOf<R> n;  ///< two's complement
  R expm1;
};

/// Parts of exp(x + low); `low` is a small correction. x within ±2^(mantissa bits / 2) or so.
template <class R>
[[gnu::always_inline]] constexpr ExponentialParts<R> exponential_parts(R x, R low) {
  using T = LaneOf<R>;
  using Constants = ExponentialConstants<T>;
  constexpr T kRounder = FloatFormat<T>::kRounder;
  const R shifted = x * R(Constants::kLog2E) + R(kRounder);
  const R n = shifted - R(kRounder);
  const R r = (x - n * R(Constants::kLn2High)) - (n * R(Constants::kLn2Low) - low);
  return {bits(shifted) - BitsOf<R>(bits(kRounder)), r + r * r * horner(r, Constants::kExpm1)};
}

/// exp(x + low), 0 and infinity beyond the range; any number for NaN.
template <class R>
[[gnu::always_inline]] constexpr R exp_of_sum(R x, R low) {
  using T = LaneOf<R>;
  using Format = FloatFormat<T>;
  using Constants = ExponentialConstants<T>;
  const R bounded = clamp(x, R(Constants::kLowest), R(Constants::kHighest));
  const ExponentialParts<R> parts = exponential_parts(bounded, low);
  // 2^n in two factors, because n may exceed the exponent range. The first product is exact.
  const BitsOf<R> exponent = parts.n + BitsOf<R>(2 * Format::kBias);  // positive
  const BitsOf<R> half = exponent >> 1;
  const R first = unbits(half << Format::kMantissaBits);
  const R second = unbits((exponent - half) << Format::kMantissaBits);
  return ((R(T(1)) + parts.expm1) * first) * second;
}

/// 2^n for n in two's complement, within the exponent range of normal numbers.
template <class R>
[[gnu::always_inline]] constexpr R power_of_two_lanes(BitsOf<R> n) {
  using Format = FloatFormat<LaneOf<R>>;
  return unbits((n + BitsOf<R>(Format::kBias)) << Format::kMantissaBits);
}

}  // namespace detail

/// e^x. Largest measured error: 1.05 ulp (float), 1.0 (double). 0 and infinity beyond the range of
/// the type.
template <Floating R>
constexpr R exp(R x) {
  return select(x == x, detail::exp_of_sum(x, R(LaneOf<R>(0))), x);
}

}  // namespace eagerx

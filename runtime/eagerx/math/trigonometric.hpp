// Sine, cosine and tangent for every finite angle.
#pragma once

#include <array>
#include <eagerx/math/basic.hpp>
#include <eagerx/math/payne_hanek.hpp>
#include <eagerx/math/polynomial.hpp>
#include <eagerx/math/vocabulary.hpp>

namespace eagerx {
namespace detail {

/// Coefficients (highest degree first) from tests/accuracy/coefficients.sollya.
template <class T>
struct TrigonometricConstants;
template <>
struct TrigonometricConstants<float> {
  /// Up to here the product of a part of pi/2 and the number of quadrants (13 bits) is exact.
  static constexpr float kLargest = 12800.0F;
  static constexpr float kTwoOverPi = 0x1.45f306p-1F;
  /// pi/2 in four parts of 8, 11, 11 and 24 bits.
  static constexpr std::array<float, 2> kExactParts = {0x1.92p0F, 0x1.fb4p-12F};
  static constexpr float kNextPart = 0x1.444p-24F;
  static constexpr float kLastPart = 0x1.68c234p-39F;
  static constexpr std::array<float, 3> kSin = {-0x1.9952ecp-13F, 0x1.110776p-7F, -0x1.555546p-3F};
  static constexpr std::array<float, 3> kCos = {0x1.99e8fcp-16F, -0x1.6c0c2ap-10F, 0x1.55554ap-5F};
};
template <>
struct TrigonometricConstants<double> {
  /// As above, with 20 bits.
  static constexpr double kLargest = 1.6e6;
  static constexpr double kTwoOverPi = 0x1.45f306dc9c883p-1;
  /// pi/2 in three parts of 33, 33 and 53 bits.
  static constexpr std::array<double, 1> kExactParts = {0x1.921fb544p0};
  static constexpr double kNextPart = 0x1.0b4611a6p-34;
  static constexpr double kLastPart = 0x1.3198a2e037073p-69;
  static constexpr std::array<double, 6> kSin = {0x1.5d8d6e1091edbp-33, -0x1.ae5e52092adc8p-26,
                                                 0x1.71de355c5f14p-19,  -0x1.a01a019befb93p-13,
                                                 0x1.111111110f751p-7,  -0x1.5555555555548p-3};
  static constexpr std::array<double, 6> kCos = {-0x1.8fa5c165deabcp-37, 0x1.1ee9da88f4795p-29,
                                                 -0x1.27e4f7f008783p-22, 0x1.a01a019c8d949p-16,
                                                 -0x1.6c16c16c1500cp-10, 0x1.555555555554bp-5};
};

/// reduce_huge_angle(), for floats without its loops.
template <class T>
[[gnu::always_inline]] constexpr Reduced<T> reduce_huge(T x) {
  if constexpr (sizeof(T) == sizeof(float)) {
    const ReducedFloat reduced = reduce_huge_float(x);
    return {reduced.angle, reduced.tail, bits(reduced.quadrant)};
  } else {
    return reduce_huge_angle(x);
  }
}

/// Reduces the lanes that reduce_to_quadrant() cannot, those beyond kLargest, one by one.
template <class R>
[[gnu::noinline, gnu::cold]] constexpr void reduce_huge_lanes(const R& x, Reduced<R>& reduced) {
  using T = LaneOf<R>;
  for (int i = 0; i < lanes<R>; ++i) {
    if (abs(lane(x, i)) <= TrigonometricConstants<T>::kLargest) continue;
    const Reduced<T> one = reduce_huge(lane(x, i));
    set_lane(reduced.angle, i, one.angle);
    set_lane(reduced.tail, i, one.tail);
    set_lane(reduced.quadrant, i, one.quadrant);
  }
}

/// x minus the nearest multiple of pi/2 (Cody and Waite); lanes beyond kLargest by Payne-Hanek.
template <class R>
[[gnu::always_inline]] constexpr Reduced<R> reduce_to_quadrant(R x) {
  using T = LaneOf<R>;
  using Constants = TrigonometricConstants<T>;
  const auto huge = !(abs(x) <= R(Constants::kLargest));  // and NaN
  if constexpr (lanes<R> == 1) {
    if (any(huge)) [[unlikely]]
      return reduce_huge(x);
  }
  const R shifted = x * R(Constants::kTwoOverPi) + R(FloatFormat<T>::kRounder);
  const R n = shifted - R(FloatFormat<T>::kRounder);
  R rest = x;
  for (const T part : Constants::kExactParts) rest = rest - n * R(part);
  // From here on, the rounding errors of the subtractions are kept: near multiples of pi/2 they are
  // all that remains.
  const R next = n * R(Constants::kNextPart);
  const R after_next = rest - next;
  const R last = n * R(Constants::kLastPart) - ((rest - after_next) - next);
  const R angle = after_next - last;
  Reduced<R> reduced{angle, (after_next - angle) - last, bits(shifted)};

  if constexpr (lanes<R> != 1) {
    if (any(huge)) [[unlikely]] {
      // A variable whose address is taken stays in memory, so this is a copy.
      Reduced<R> corrected = reduced;
      reduce_huge_lanes(R(x), corrected);
      reduced = corrected;
    }
  }
  return reduced;
}

}  // namespace detail

/// Sine and cosine of the same angle.
template <class R>
struct SinCos {
  R sin;
  R cos;
};

/// Sine and cosine of `x` rad, for little more than the cost of one. Errors as for sin and cos.
template <Floating R>
[[gnu::always_inline]] constexpr SinCos<R> sincos(R x) {
  using T = LaneOf<R>;
  using Format = FloatFormat<T>;
  using Constants = detail::TrigonometricConstants<T>;
  const detail::Reduced<R> reduced = detail::reduce_to_quadrant(x);
  const R r = reduced.angle;
  const R square = r * r;
  const R sine = r + (square * r * detail::horner(square, Constants::kSin) + reduced.tail);
  const R half_square = R(T(0.5)) * square;
  const R start = R(T(1)) - half_square;
  const R cosine =
      start + (((R(T(1)) - start) - half_square) +
               (square * square * detail::horner(square, Constants::kCos) - r * reduced.tail));

  const auto odd = (reduced.quadrant & BitsOf<R>(1)) != BitsOf<R>(0);
  const R sin_magnitude = select(odd, cosine, sine);
  const R cos_magnitude = select(odd, sine, cosine);
  // Bit 1 of the quadrant, of quadrant + 1 for the cosine, is the sign.
  const BitsOf<R> sin_sign = (reduced.quadrant << (Format::kWidth - 2)) & BitsOf<R>(Format::kSign);
  const BitsOf<R> cos_sign =
      ((reduced.quadrant + BitsOf<R>(1)) << (Format::kWidth - 2)) & BitsOf<R>(Format::kSign);
  const R sin_x = unbits(bits(sin_magnitude) ^ sin_sign);
  return {select(x == R(T(0)), x, sin_x), unbits(bits(cos_magnitude) ^ cos_sign)};  // sin(-0) = -0
}

/// Sine of `x` rad, any finite x. Largest measured error: 0.95 ulp (float), 0.9 (double). NaN for
/// infinities.
template <Floating R>
constexpr R sin(R x) {
  return sincos(x).sin;
}

/// Cosine of `x` rad, any finite x. Largest measured error: 0.95 ulp (float), 0.9 (double). NaN for
/// infinities.
template <Floating R>
constexpr R cos(R x) {
  return sincos(x).cos;
}

/// Tangent of `x` rad, any finite x. Largest measured error: 2.6 ulp (float), 2.4 (double). NaN for
/// infinities.
template <Floating R>
constexpr R tan(R x) {
  const SinCos<R> both = sincos(x);
  return both.sin / both.cos;
}

}  // namespace eagerx

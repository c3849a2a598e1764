// Hyperbolic functions and the logistic function.
#pragma once

#include <array>
#include <eagerx/math/basic.hpp>
#include <eagerx/math/exponential.hpp>
#include <eagerx/math/vocabulary.hpp>

namespace eagerx {
namespace detail {

template <class T>
struct HyperbolicConstants;
template <>
struct HyperbolicConstants<float> {
  static constexpr float kTanhIsOne = 10.0F;   // tanh is 1 from here on
  static constexpr float kSinhIsX = 0x1p-13F;  // sinh(x) is x up to here
  static constexpr float kOverflow = 89.5F;    // sinh and cosh are infinite from here on
};
template <>
struct HyperbolicConstants<double> {
  static constexpr double kTanhIsOne = 20.0;
  static constexpr double kSinhIsX = 0x1p-28;
  static constexpr double kOverflow = 710.5;
};

/// tanh(s) / s - 1 = s² (c[0] + c[1] s²) for |s| <= log(2)/4; see
/// tests/accuracy/coefficients.sollya.
inline constexpr std::array<float, 2> kTanhNearZero = {-0x1.554fe8p-2F, 0x1.0c7f34p-3F};

/// log(2) / 2 in 21 bits, so that n times it is exact for n below 8; beyond, tanh hardly changes.
inline constexpr float kHalfLn2 = 0x1.62e43p-2F;

/// Rounds as kRounder, but the low bits of x + kPowerRounder are those of n and the bias of 2^n, so
/// that they need only be shifted to be that number.
inline constexpr float kPowerRounder =
    unbits(bits(FloatFormat<float>::kRounder) + FloatFormat<float>::kBias);

/// tanh of 0 <= a <= kTanhIsOne, in float. Policies compute it very often: fewer operations and
/// shorter chains than with e^2a - 1. a = n log(2)/2 + s; tanh(n log(2)/2) is (2^n - 1) / (2^n +
/// 1), and tanh(s) is added by the formula for tanh of a sum.
template <Floating R>
[[gnu::always_inline]] constexpr R positive_tanh(R a) {
  using Constants = ExponentialConstants<float>;
  const R shifted = a * R(2.0F * Constants::kLog2E) + R(kPowerRounder);
  const R n = shifted - R(kPowerRounder);
  const R s = a - n * R(kHalfLn2);
  const R power = unbits(bits(shifted) << FloatFormat<float>::kMantissaBits);  // 2^n
  const R square = s * s;
  const R t = s + (square * s) * (square * R(kTanhNearZero[1]) + R(kTanhNearZero[0]));
  const R less = power - R(1.0F);
  const R more = power + R(1.0F);
  return (less + more * t) / (more + less * t);
}

/// tanh, always inlined: SIMD vectors of several registers must not pass through memory.
template <Floating R>
[[gnu::always_inline]] constexpr R tanh_inlined(R x) {
  using T = LaneOf<R>;
  const R a = min(abs(x), R(HyperbolicConstants<T>::kTanhIsOne));
  if constexpr (std::is_same_v<T, float>) {
    return copysign(positive_tanh(a), x);
  } else {
    const auto parts = exponential_parts(a + a, R(T(0)));
    const R scale = power_of_two_lanes<R>(parts.n);
    const R expm1 = scale * parts.expm1 + (scale - R(T(1)));  // e^2a - 1
    return select(x == x, copysign(expm1 / (expm1 + R(T(2))), x), x);
  }
}

}  // namespace detail

/// Hyperbolic tangent. Largest measured error: 2.6 ulp (float), 2.5 (double).
template <Floating R>
constexpr R tanh(R x) {
  return detail::tanh_inlined(x);
}

/// Hyperbolic sine. Largest measured error: 2.5 ulp. Infinite where the result is too large.
template <Floating R>
constexpr R sinh(R x) {
  using T = LaneOf<R>;
  using Constants = detail::HyperbolicConstants<T>;
  const R a = min(abs(x), R(Constants::kOverflow));
  const auto parts = detail::exponential_parts(a, R(T(0)));
  // A quarter of e^a - 1, so that it overflows only when the result does.
  const R scale = detail::power_of_two_lanes<R>(parts.n - BitsOf<R>(2));
  const R quarter = scale * parts.expm1 + (scale - R(T(0.25)));
  const R half_sinh = quarter + quarter / (R(T(4)) * quarter + R(T(1)));
  const R sinh_a = select(a < R(Constants::kSinhIsX), a, half_sinh + half_sinh);
  return select(x == x, copysign(sinh_a, x), x);
}

/// Hyperbolic cosine. Largest measured error: 1.6 ulp. Infinite where the result is too large.
template <Floating R>
constexpr R cosh(R x) {
  using T = LaneOf<R>;
  const R a = min(abs(x), R(detail::HyperbolicConstants<T>::kOverflow));
  const auto parts = detail::exponential_parts(a, R(T(0)));
  const R scale = detail::power_of_two_lanes<R>(parts.n - BitsOf<R>(2));
  const R quarter = scale * parts.expm1 + scale;  // of e^a
  const R half_cosh = quarter + R(T(0.0625)) / quarter;
  return select(x == x, half_cosh + half_cosh, x);
}

/// 1 / (1 + e^-x), the logistic function. Largest measured error: 2.5 ulp. Never overflows.
template <Floating R>
constexpr R sigmoid(R x) {
  using T = LaneOf<R>;
  const R e = exp(-abs(x));
  const R numerator = select(x < R(T(0)), e, R(T(1)));
  return select(x == x, numerator / (R(T(1)) + e), x);
}

}  // namespace eagerx

// Rounding to integers, and remainders. Exact.
#pragma once

#include <bit>
#include <eagerx/math/basic.hpp>
#include <eagerx/math/vocabulary.hpp>
#include <type_traits>

namespace eagerx {
namespace detail {

/// |x| rounded to an integer, ties to even; numbers without a fraction, infinity and NaN unchanged.
template <class R>
[[gnu::always_inline]] constexpr R round_magnitude_to_even(R x) {
  const R limit = R(power_of_two<LaneOf<R>>(FloatFormat<LaneOf<R>>::kMantissaBits));
  const R a = abs(x);
  return select(a < limit, (a + limit) - limit, a);
}

}  // namespace detail

/// To the nearest integer, halves to the even one (IEEE 754's roundTiesToEven). Exact; keeps the
/// sign of zero.
template <Floating R>
constexpr R round_to_even(R x) {
  return copysign(detail::round_magnitude_to_even(x), x);
}

/// Towards zero. Exact; keeps the sign of zero.
template <Floating R>
constexpr R trunc(R x) {
  using T = LaneOf<R>;
  const R even = detail::round_magnitude_to_even(x);
  return copysign(even - select(even > abs(x), R(T(1)), R(T(0))), x);
}

/// The largest integer not above `x`. Exact; keeps the sign of zero.
template <Floating R>
constexpr R floor(R x) {
  using T = LaneOf<R>;
  const R even = copysign(detail::round_magnitude_to_even(x), x);
  return copysign(even - select(even > x, R(T(1)), R(T(0))), x);
}

/// The smallest integer not below `x`. Exact; keeps the sign of zero.
template <Floating R>
constexpr R ceil(R x) {
  using T = LaneOf<R>;
  const R even = copysign(detail::round_magnitude_to_even(x), x);
  return copysign(even + select(even < x, R(T(1)), R(T(0))), x);
}

/// To the nearest integer, halves away from zero (as C's round). Exact; keeps the sign of zero.
template <Floating R>
constexpr R round(R x) {
  using T = LaneOf<R>;
  const R whole = trunc(x);
  const R up = select(abs(x - whole) >= R(T(0.5)), R(T(1)), R(T(0)));
  return copysign(abs(whole) + up, x);
}

/// To the nearest multiple of `step`, halves away from zero. Numbers with derivatives take the mean
/// slope of these steps.
template <Floating R>
constexpr R quantized(R x, std::type_identity_t<R> step) {
  return step * round(x / step);
}

namespace detail {

/// fmod of positive finite numbers with x >= y.
template <class T>
constexpr T remainder_of_magnitudes(T x, T y) {
  using Format = FloatFormat<T>;
  using Bits = BitsOf<T>;
  struct Parts {
    Bits mantissa;
    int exponent;
  };
  const auto parts = [](T value) {
    const int exponent = static_cast<int>(bits(value) >> Format::kMantissaBits);
    const Bits mantissa = bits(value) & Format::kMantissa;
    if (exponent == 0) return Parts{mantissa, 1};  // subnormal
    return Parts{mantissa | (Bits{1} << Format::kMantissaBits), exponent};
  };
  const Parts dividend = parts(x);
  const Parts divisor = parts(y);
  // Long division, with as many binary digits at a time as fit above the mantissa.
  constexpr int kStep = Format::kWidth - Format::kDigits;
  Bits rest = dividend.mantissa % divisor.mantissa;
  for (int digits = dividend.exponent - divisor.exponent; digits > 0; digits -= kStep) {
    rest = (rest << (digits < kStep ? digits : kStep)) % divisor.mantissa;
  }
  // rest < divisor.mantissa, at the exponent of the divisor.
  if (rest == 0) return T(0);
  const int room = std::countl_zero(rest) - (Format::kWidth - Format::kDigits);
  const int shift = room < divisor.exponent - 1 ? room : divisor.exponent - 1;
  // The leading one of a normal mantissa adds the last 1 to the exponent.
  return unbits((static_cast<Bits>(divisor.exponent - shift - 1) << Format::kMantissaBits) +
                (rest << shift));
}

}  // namespace detail

/// x - n y, n the quotient truncated to an integer; with the sign of x, as C's fmod. Exact. NaN for
/// y = 0 and infinite x. One lane at a time, and slow for a very large quotient.
template <Floating R>
constexpr R fmod(R x, std::type_identity_t<R> y) {
  using T = LaneOf<R>;
  R result = x;
  for (int i = 0; i < lanes<R>; ++i) {
    const T numerator = lane(x, i);
    const T a = abs(numerator);
    const T b = abs(lane(y, i));
    if (!isfinite(a) || !(b > T(0))) {  // also NaN
      set_lane(result, i, FloatFormat<T>::nan);
    } else if (a >= b) {
      set_lane(result, i, copysign(detail::remainder_of_magnitudes(a, b), numerator));
    }
  }
  return result;
}

}  // namespace eagerx

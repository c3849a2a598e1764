// Powers of real numbers.
#pragma once

#include <array>
#include <eagerx/math/basic.hpp>
#include <eagerx/math/exponential.hpp>
#include <eagerx/math/logarithm.hpp>
#include <eagerx/math/polynomial.hpp>
#include <eagerx/math/rounding.hpp>
#include <eagerx/math/vocabulary.hpp>

namespace eagerx {
namespace detail {

/// Coefficients (highest degree first) from tests/accuracy/coefficients.sollya.
template <class T>
struct PowerConstants;
template <>
struct PowerConstants<float> {
  static constexpr float kLargestExponent = 0x1p40F;  // beyond, powers are 0, 1 or infinity
  static constexpr TwoWords<float> kLogThreeQuarters = {-0x1.2698p-2F, 0x1.deecb2p-18F};
  static constexpr TwoWords<float> kLogFiveQuarters = {0x1.c9p-3F, -0x1.070cacp-20F};
  static constexpr std::array<float, 3> kLog = {0x1.27df96p-2F, 0x1.9995cep-2F, 0x1.555556p-1F};
};
template <>
struct PowerConstants<double> {
  static constexpr double kLargestExponent = 0x1p70;
  static constexpr TwoWords<double> kLogThreeQuarters = {-0x1.269621134ep-2, 0x1.1b61f10522625p-44};
  static constexpr TwoWords<double> kLogFiveQuarters = {0x1.c8ff7c79aap-3, -0x1.7794f689f8434p-45};
  static constexpr std::array<double, 6> kLog = {0x1.40335e58515adp-3, 0x1.745370a87dd6fp-3,
                                                 0x1.c71c7ad4912a1p-3, 0x1.2492492261235p-2,
                                                 0x1.999999999a1b2p-2, 0x1.5555555555555p-1};
};

/// log(x) of a positive finite number in two words, with some ten digits more than one word has.
template <class R>
[[gnu::always_inline]] constexpr TwoWords<R> log_in_two_words(R x) {
  using T = LaneOf<R>;
  using Constants = PowerConstants<T>;
  const auto [k, f] = logarithm_parts(x);
  const R m = f + R(T(1));
  // log(x) = k log(2) + log(c) + log(m / c), c the closest of 3/4, 1 and 5/4; f becomes m - c,
  // exactly.
  const auto below = m < R(T(0.866));
  const auto above = m > R(T(1.118));
  const R c = select(below, R(T(0.75)), select(above, R(T(1.25)), R(T(1))));
  const R log_c = select(below, R(Constants::kLogThreeQuarters.high),
                         select(above, R(Constants::kLogFiveQuarters.high), R(T(0))));
  const R log_c_low = select(below, R(Constants::kLogThreeQuarters.low),
                             select(above, R(Constants::kLogFiveQuarters.low), R(T(0))));
  const R difference = m - c;
  // s = (m - c) / (m + c), in two words
  const TwoWords<R> sum = exact_sum(c + c, difference);
  const R s = difference / sum.high;
  const TwoWords<R> back = exact_product(s, sum.high);
  const R s_low = (((difference - back.high) - back.low) - s * sum.low) / sum.high;
  // log(m / c) = 2 s + s^3 (2/3 + s^2 (...)); s is small enough for one word of the second term.
  const R square = s * s;
  const R cubic = s * (square * horner(square, Constants::kLog));
  const TwoWords<R> total =
      exact_sum(k * R(LogarithmConstants<T>::kLn2High) + log_c, s + s);  // the products are exact
  // 2 s_low (1 + s^2) is the slope of the series times s_low.
  const R slope = (s_low + s_low) + (s_low + s_low) * square;
  const R low = cubic + (slope + (k * R(LogarithmConstants<T>::kLn2Low) + log_c_low));
  return exact_sum(total.high, total.low + low);
}

/// x^y for x >= 0 (or NaN), any y: the magnitude of pow.
template <class R>
[[gnu::always_inline]] constexpr R power_of_magnitude(R x, R y) {
  using T = LaneOf<R>;
  using Format = FloatFormat<T>;
  const R zero = R(T(0));
  const R infinity = R(Format::infinity);
  const R largest = R(PowerConstants<T>::kLargestExponent);
  const auto ordinary = (x > zero) & (x < infinity);
  const TwoWords<R> logarithm = log_in_two_words(select(ordinary, x, R(T(1))));
  const R exponent = clamp(y, -largest, largest);
  const TwoWords<R> product = exact_product(exponent, logarithm.high);
  // Beyond the range of exp the second word is meaningless.
  const auto in_range = (product.high >= R(ExponentialConstants<T>::kLowest)) &
                        (product.high <= R(ExponentialConstants<T>::kHighest));
  const R low = select(in_range, product.low + exponent * logarithm.low, zero);
  const R power = exp_of_sum(product.high, low);
  const auto grows = (x == infinity) == (y > zero);
  return select(ordinary, power, select(grows, infinity, zero));
}

}  // namespace detail

/// x^y for all real arguments, with all special cases of C99; x < 0 needs an integer y, otherwise
/// NaN. Largest measured error: 1.2 ulp (float), 3.0 (double).
template <Floating R>
constexpr R pow(R x, std::type_identity_t<R> y) {
  using T = LaneOf<R>;
  using Format = FloatFormat<T>;
  const R zero = R(T(0));
  const R one = R(T(1));
  const R half = R(T(0.5)) * y;
  const auto integer = trunc(y) == y;
  const auto odd = integer & (trunc(half) != half);
  const auto negative = (bits(x) & BitsOf<R>(Format::kSign)) != BitsOf<R>(0);
  R power = detail::power_of_magnitude(abs(x), y);
  power = select(negative & odd, -power, power);
  const auto finite_negative = (x < zero) & (x > -R(Format::infinity));
  power = select(finite_negative & !integer, R(Format::nan), power);
  power = select((x == x) & (y == y), power, x + y);
  return select((x == one) | (y == zero), one, power);
}

}  // namespace eagerx

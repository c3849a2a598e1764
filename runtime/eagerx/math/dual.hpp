// Dual numbers: a value together with its derivatives, exact but for rounding.
//
// A function that is written over its number type alone, computed with Dual<double, N>, gives its
// value and ∂/∂x_1 … ∂/∂x_N at once, by the rules of differentiation: no step size to choose, and
// the same bits on every target. Griewank, Walther: Evaluating Derivatives, 2nd edition, 2008,
// chapter 3 (forward mode). This header has every function of eagerx/math.hpp for them.
#pragma once

#include <cstddef>
#include <eagerx/math/basic.hpp>
#include <eagerx/math/exponential.hpp>
#include <eagerx/math/hyperbolic.hpp>
#include <eagerx/math/inverse_trigonometric.hpp>
#include <eagerx/math/logarithm.hpp>
#include <eagerx/math/power.hpp>
#include <eagerx/math/rounding.hpp>
#include <eagerx/math/sqrt.hpp>
#include <eagerx/math/trigonometric.hpp>
#include <eagerx/math/vocabulary.hpp>
#include <eagerx/message.hpp>
#include <numbers>
#include <type_traits>

namespace eagerx {

/// Does nothing when a Dual is constructed. A program specializes it to find all numbers of an
/// object (targets/linearize).
template <class R, std::size_t N>
struct DualBirth {};

/// A number (or SIMD vector) `value` and its N derivatives. Comparisons use the value only, so at a
/// kink the derivative is that of the branch taken.
template <class R, std::size_t N>
struct Dual {
  [[no_unique_address]] DualBirth<R, N> birth;
  R value;
  R derivative[N];

  Dual() = default;
  // NOLINTBEGIN(google-explicit-constructor): numbers mix with constants
  /// A constant: all derivatives are zero.
  constexpr Dual(R constant) : value(constant), derivative{} {}
  template <class T>
  requires(std::is_arithmetic_v<T> && !std::is_same_v<T, R>) constexpr Dual(T constant)
      : value(static_cast<LaneOf<R>>(constant)), derivative{} {}
  // NOLINTEND(google-explicit-constructor)
  /// Deleted: the conversion would lose the derivatives.
  template <class T>
  requires std::is_arithmetic_v<T>
  constexpr explicit operator T() const {
    static_assert(
        sizeof(T) == 0,
        "a number with derivatives cannot become a plain one: the derivative of a model "
        "computes in Io::Real alone, or has a `jacobian`, or says `dual_numbers = false`");
    return T{};
  }
  /// The variable with number `i`, 0 <= i < N.
  static constexpr Dual variable(R value, std::size_t i) {
    Dual result(value);
    result.derivative[i] = R(LaneOf<R>(1));
    return result;
  }
  /// `value`, and derivative i is f(i).
  template <class F>
  static constexpr Dual of(R value, F f) {
    Dual result(value);
    for (std::size_t i = 0; i < N; ++i) result.derivative[i] = f(i);
    return result;
  }

  friend constexpr Dual operator-(const Dual& a) {
    return of(-a.value, [&](std::size_t i) { return -a.derivative[i]; });
  }
  friend constexpr Dual operator+(const Dual& a, const Dual& b) {
    return of(a.value + b.value, [&](std::size_t i) { return a.derivative[i] + b.derivative[i]; });
  }
  friend constexpr Dual operator-(const Dual& a, const Dual& b) {
    return of(a.value - b.value, [&](std::size_t i) { return a.derivative[i] - b.derivative[i]; });
  }
  friend constexpr Dual operator*(const Dual& a, const Dual& b) {
    return of(a.value * b.value,
              [&](std::size_t i) { return a.derivative[i] * b.value + a.value * b.derivative[i]; });
  }
  friend constexpr Dual operator/(const Dual& a, const Dual& b) {
    const R quotient = a.value / b.value;
    return of(quotient, [&](std::size_t i) {
      return (a.derivative[i] - quotient * b.derivative[i]) / b.value;
    });
  }
  constexpr Dual& operator+=(const Dual& b) { return *this = *this + b; }
  constexpr Dual& operator-=(const Dual& b) { return *this = *this - b; }
  constexpr Dual& operator*=(const Dual& b) { return *this = *this * b; }
  constexpr Dual& operator/=(const Dual& b) { return *this = *this / b; }

  friend constexpr auto operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend constexpr auto operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
  friend constexpr auto operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend constexpr auto operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }
  friend constexpr auto operator==(const Dual& a, const Dual& b) { return a.value == b.value; }
  friend constexpr auto operator!=(const Dual& a, const Dual& b) { return a.value != b.value; }
};

template <class R, std::size_t N>
struct LaneTraits<Dual<R, N>> : LaneTraits<R> {};
template <class R, std::size_t N>
inline constexpr bool is_number<Dual<R, N>> = true;

/// Both sides are computed, as for SIMD vectors.
template <class R, std::size_t N>
constexpr Dual<R, N> select(const TruthOf<R>& mask, const Dual<R, N>& when_true,
                            const std::type_identity_t<Dual<R, N>>& when_false) {
  return Dual<R, N>::of(select(mask, when_true.value, when_false.value), [&](std::size_t i) {
    return select(mask, when_true.derivative[i], when_false.derivative[i]);
  });
}

namespace detail {

/// slope·d, or 0 if d is 0: a constant stays constant even if the slope is infinite or NaN.
template <class R>
constexpr R scaled(const R& slope, const R& d) {
  return select(d == R(LaneOf<R>(0)), d, slope * d);
}

/// The chain rule: g(x) from `value` = g(x.value) and `slope` = g'(x.value).
template <class R, std::size_t N>
constexpr Dual<R, N> chain(const Dual<R, N>& x, const std::type_identity_t<R>& value,
                           const std::type_identity_t<R>& slope) {
  return Dual<R, N>::of(value, [&](std::size_t i) { return scaled(slope, x.derivative[i]); });
}

}  // namespace detail

// The functions of eagerx/math.hpp; the values have the bits of theirs.
template <class R, std::size_t N>
constexpr Dual<R, N> abs(const Dual<R, N>& x) {
  return detail::chain(x, abs(x.value), copysign(R(LaneOf<R>(1)), x.value));
}
template <class R, std::size_t N>
constexpr Dual<R, N> square(const Dual<R, N>& x) {
  return x * x;
}
template <class R, std::size_t N>
constexpr Dual<R, N> cube(const Dual<R, N>& x) {
  return x * x * x;
}
template <class R, std::size_t N>
constexpr Dual<R, N> copysign(const Dual<R, N>& magnitude,
                              const std::type_identity_t<Dual<R, N>>& sign) {
  const R one = R(LaneOf<R>(1));
  return detail::chain(magnitude, copysign(magnitude.value, sign.value),
                       copysign(one, magnitude.value) * copysign(one, sign.value));
}
template <class R, std::size_t N>
constexpr auto isnan(const Dual<R, N>& x) {
  return isnan(x.value);
}
template <class R, std::size_t N>
constexpr auto isfinite(const Dual<R, N>& x) {
  return isfinite(x.value);
}
template <class R, std::size_t N>
constexpr Dual<R, N> sqrt(const Dual<R, N>& x) {
  const R root = sqrt(x.value);
  return detail::chain(x, root, R(LaneOf<R>(0.5)) / root);
}
template <class R, std::size_t N>
constexpr Dual<R, N> exp(const Dual<R, N>& x) {
  const R power = exp(x.value);
  return detail::chain(x, power, power);
}
template <class R, std::size_t N>
constexpr Dual<R, N> log(const Dual<R, N>& x) {
  return detail::chain(x, log(x.value), R(LaneOf<R>(1)) / x.value);
}
template <class R, std::size_t N>
constexpr Dual<R, N> log10(const Dual<R, N>& x) {
  constexpr auto kLog10E = std::numbers::log10e_v<LaneOf<R>>;
  return detail::chain(x, log10(x.value), R(kLog10E) / x.value);
}
template <class R, std::size_t N>
constexpr Dual<R, N> sinh(const Dual<R, N>& x) {
  return detail::chain(x, sinh(x.value), cosh(x.value));
}
template <class R, std::size_t N>
constexpr Dual<R, N> cosh(const Dual<R, N>& x) {
  return detail::chain(x, cosh(x.value), sinh(x.value));
}
template <class R, std::size_t N>
constexpr Dual<R, N> tanh(const Dual<R, N>& x) {
  const R t = tanh(x.value);
  return detail::chain(x, t, R(LaneOf<R>(1)) - t * t);
}
template <class R, std::size_t N>
constexpr Dual<R, N> sigmoid(const Dual<R, N>& x) {
  const R s = sigmoid(x.value);
  return detail::chain(x, s, s * (R(LaneOf<R>(1)) - s));
}
template <class R, std::size_t N>
constexpr SinCos<Dual<R, N>> sincos(const Dual<R, N>& x) {
  const auto [sine, cosine] = sincos(x.value);
  return {detail::chain(x, sine, cosine), detail::chain(x, cosine, -sine)};
}
template <class R, std::size_t N>
constexpr Dual<R, N> sin(const Dual<R, N>& x) {
  return sincos(x).sin;
}
template <class R, std::size_t N>
constexpr Dual<R, N> cos(const Dual<R, N>& x) {
  return sincos(x).cos;
}
template <class R, std::size_t N>
constexpr Dual<R, N> tan(const Dual<R, N>& x) {
  const R t = tan(x.value);
  return detail::chain(x, t, R(LaneOf<R>(1)) + t * t);
}
template <class R, std::size_t N>
constexpr Dual<R, N> asin(const Dual<R, N>& x) {
  const R one = R(LaneOf<R>(1));
  return detail::chain(x, asin(x.value), one / sqrt((one - x.value) * (one + x.value)));
}
template <class R, std::size_t N>
constexpr Dual<R, N> acos(const Dual<R, N>& x) {
  const R one = R(LaneOf<R>(1));
  return detail::chain(x, acos(x.value), -one / sqrt((one - x.value) * (one + x.value)));
}
template <class R, std::size_t N>
constexpr Dual<R, N> atan(const Dual<R, N>& x) {
  const R one = R(LaneOf<R>(1));
  return detail::chain(x, atan(x.value), one / (one + x.value * x.value));
}
/// NaN for the derivative at the origin.
template <class R, std::size_t N>
constexpr Dual<R, N> atan2(const Dual<R, N>& y, const std::type_identity_t<Dual<R, N>>& x) {
  const R squares = x.value * x.value + y.value * y.value;
  return Dual<R, N>::of(atan2(y.value, x.value), [&](std::size_t i) {
    return (detail::scaled(x.value, y.derivative[i]) - detail::scaled(y.value, x.derivative[i])) /
           squares;
  });
}
template <class R, std::size_t N>
constexpr Dual<R, N> pow(const Dual<R, N>& x, const std::type_identity_t<Dual<R, N>>& y) {
  const R power = pow(x.value, y.value);
  const R by_x = y.value * pow(x.value, y.value - R(LaneOf<R>(1)));
  const R by_y = power * log(x.value);
  return Dual<R, N>::of(power, [&](std::size_t i) {
    return detail::scaled(by_x, x.derivative[i]) + detail::scaled(by_y, y.derivative[i]);
  });
}
/// Step functions: the derivative is zero.
template <class R, std::size_t N>
constexpr Dual<R, N> trunc(const Dual<R, N>& x) {
  return trunc(x.value);
}
template <class R, std::size_t N>
constexpr Dual<R, N> floor(const Dual<R, N>& x) {
  return floor(x.value);
}
template <class R, std::size_t N>
constexpr Dual<R, N> ceil(const Dual<R, N>& x) {
  return ceil(x.value);
}
template <class R, std::size_t N>
constexpr Dual<R, N> round(const Dual<R, N>& x) {
  return round(x.value);
}
/// The mean slope of the steps, 1: the effect of a fine quantization in a loop.
template <class R, std::size_t N>
constexpr Dual<R, N> quantized(const Dual<R, N>& x, const std::type_identity_t<Dual<R, N>>& step) {
  return Dual<R, N>::of(quantized(x.value, step.value),
                        [&](std::size_t i) { return x.derivative[i]; });
}
template <class R, std::size_t N>
constexpr Dual<R, N> fmod(const Dual<R, N>& x, const std::type_identity_t<Dual<R, N>>& y) {
  const R quotient = trunc(x.value / y.value);
  return Dual<R, N>::of(fmod(x.value, y.value), [&](std::size_t i) {
    return x.derivative[i] - detail::scaled(quotient, y.derivative[i]);
  });
}

}  // namespace eagerx

/// Models write std::numbers::pi_v<Real>, which a program may specialize for its own types.
template <class R, std::size_t N>
inline constexpr eagerx::Dual<R, N> std::numbers::pi_v<eagerx::Dual<R, N>> =
    std::numbers::pi_v<eagerx::LaneOf<R>>;

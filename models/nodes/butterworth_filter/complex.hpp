// Complex arithmetic for filter design, usable at compile time.
#pragma once

#include <eagerx/math.hpp>

namespace eagerx::models {

/// std::complex is not used: its products and quotients handle infinities through the compiler's
/// run-time library, and its square root is not constexpr.
struct Complex {
  double re = 0.0;
  double im = 0.0;

  friend constexpr Complex operator+(Complex a, Complex b) { return {a.re + b.re, a.im + b.im}; }
  friend constexpr Complex operator-(Complex a, Complex b) { return {a.re - b.re, a.im - b.im}; }
  friend constexpr Complex operator*(Complex a, Complex b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  friend constexpr Complex operator/(Complex a, Complex b) {
    const double square = b.re * b.re + b.im * b.im;
    return {(a.re * b.re + a.im * b.im) / square, (a.im * b.re - a.re * b.im) / square};
  }
};

constexpr double squared_magnitude(Complex z) {
  return z.re * z.re + z.im * z.im;
}
constexpr double magnitude(Complex z) {
  return eagerx::sqrt(squared_magnitude(z));
}

/// The square root with a real part that is not negative.
constexpr Complex square_root(Complex z) {
  const double larger = eagerx::sqrt(0.5 * (magnitude(z) + eagerx::abs(z.re)));
  if (larger == 0.0) return {};
  const double smaller = 0.5 * z.im / larger;
  if (z.re >= 0.0) return {larger, smaller};
  return z.im < 0.0 ? Complex{-smaller, -larger} : Complex{smaller, larger};
}

}  // namespace eagerx::models

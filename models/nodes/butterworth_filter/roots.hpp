// The roots of a polynomial with real coefficients.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/math.hpp>
#include <models/nodes/butterworth_filter/complex.hpp>

namespace eagerx::models {

/// Real roots, and complex ones by the one of each conjugate pair that has a positive imaginary
/// part.
struct Roots {
  static constexpr std::size_t kMax = 16;  // a band filter of order 8

  std::array<Complex, kMax> pairs{};
  std::array<double, kMax> reals{};
  std::size_t pair_count = 0;
  std::size_t real_count = 0;

  constexpr std::size_t count() const { return 2 * pair_count + real_count; }
  constexpr void add_pair(Complex root) { pairs[pair_count++] = {root.re, eagerx::abs(root.im)}; }
  constexpr void add_real(double root) { reals[real_count++] = root; }

  /// Removes a root; the order of the others stays.
  constexpr Complex take_pair(std::size_t at) {
    const Complex root = pairs[at];
    --pair_count;
    for (std::size_t i = at; i < pair_count; ++i) pairs[i] = pairs[i + 1];
    return root;
  }
  constexpr double take_real(std::size_t at) {
    const double root = reals[at];
    --real_count;
    for (std::size_t i = at; i < real_count; ++i) reals[i] = reals[i + 1];
    return root;
  }

  /// Every root r as f(r), for an f that maps conjugates to conjugates and reals to reals.
  template <class F>
  constexpr Roots mapped(F f) const {
    Roots result;
    for (std::size_t i = 0; i < pair_count; ++i) result.add_pair(f(pairs[i]));
    for (std::size_t i = 0; i < real_count; ++i) result.add_real(f(Complex{reals[i]}).re);
    return result;
  }

  /// Product of all roots; 1 if there is none.
  constexpr double product() const {
    double result = 1.0;
    for (std::size_t i = 0; i < pair_count; ++i) result *= squared_magnitude(pairs[i]);
    for (std::size_t i = 0; i < real_count; ++i) result *= reals[i];
    return result;
  }
};

}  // namespace eagerx::models

// A second-order section as two integrators, which keeps its precision at low frequencies.
#pragma once

#include <eagerx/math.hpp>
#include <models/nodes/block.hpp>
#include <models/nodes/butterworth_filter/sections.hpp>

namespace eagerx::models {

template <class Real>
struct StateMemory {
  CompensatedSum<Real> first, second;  // of the band and the low output
};

/// The state-variable form of (b0 + b1/z + b2/z²)/(1 + a1/z + a2/z²) by the trapezoidal rule: with
/// g the corner and k the damping,
///   v1 = (g·(x − z2) + z1)/(1 + g·(g + k)),  v2 = z2 + g·v1,
///   z1 ← 2·v1 − z1,  z2 ← 2·v2 − z2,  y = m0·x + m1·v1 + m2·v2
/// Its coefficients do not cancel, and at rest v2 is x to the bit. Zavalishin: The Art of VA Filter
/// Design, 2018, chapter 4; Simper: Linear trapezoidal integrated state variable filter, 2014.
template <class Real>
struct StateSection {
  using Lane = LaneOf<Real>;
  Lane a1, a2, a3;  // 1/(1 + g·(g + k)), g·a1, g·a2
  Lane m0, m1, m2;
  Lane less;  // 1 − a1

  constexpr Real pass(const Real& x, StateMemory<Real>& z) const {
    const Real lag = (x - z.second.value) - z.second.rest;
    const Real v1 = Real(a1) * z.first.value + Real(a2) * lag;
    const Real rise = Real(a2) * z.first.value + Real(a3) * lag;
    const Real v2 = z.second.value + rise;
    // 2·v1 − z1 = z1 + 2·(v1 − z1), with a1 − 1 = −(a3 + k·a2), whose digits are not lost.
    z.first = z.first.plus(Real(Lane(2)) * (Real(a2) * lag - Real(less) * z.first.value));
    z.second = z.second.plus(Real(Lane(2)) * rise);
    return (Real(m0) * x + Real(m1) * v1) + Real(m2) * v2;
  }
};

/// The n-th root of a positive number, by Newton's method.
constexpr double root_of(double x, int n) {
  double root = 1.0;
  for (int i = 0; i < 300; ++i) {
    double power = 1.0;
    for (int k = 1; k < n; ++k) power *= root;
    const double next = ((n - 1) * root + x / power) / n;
    if (next == root) break;
    root = next;
  }
  return root;
}

/// Of a digital section whose numerator is as monic, but for a gain. The bilinear transformation
/// backwards: z = (1 + s)/(1 − s) makes of z² + c1·z + c2 the polynomial
/// (1 − c1 + c2)·s² + 2·(1 − c2)·s + (1 + c1 + c2).
template <class Real>
constexpr StateSection<Real> state_section(const SecondOrderSection& s, double gain) {
  const double square = 1.0 - s.a1 + s.a2;  // of the denominator
  const double linear = 2.0 * (1.0 - s.a2);
  const double g = eagerx::sqrt(s.a_at_one / square);
  const double k = linear / (square * g);
  const double high = gain * (1.0 - s.b1 / s.b0 + s.b2 / s.b0) / square;
  const double band = gain * 2.0 * (1.0 - s.b2 / s.b0) * g / s.a_at_one;
  const double low = gain * s.b_at_one / s.a_at_one;
  const double a1 = 1.0 / (1.0 + g * (g + k));
  using Lane = LaneOf<Real>;
  const auto rounded = [](double x) { return static_cast<Lane>(x); };
  return {.a1 = rounded(a1),
          .a2 = rounded(g * a1),
          .a3 = rounded(g * g * a1),
          .m0 = rounded(high),
          .m1 = rounded(band - k * high),
          .m2 = rounded(low - high),
          .less = rounded(g * (g + k) * a1)};
}

}  // namespace eagerx::models

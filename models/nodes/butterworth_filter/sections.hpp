// Converts zeros and poles into second-order sections.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/math.hpp>
#include <models/nodes/butterworth_filter/complex.hpp>
#include <models/nodes/butterworth_filter/roots.hpp>

namespace eagerx::models {

/// (b0 + b1/z + b2/z²) / (1 + a1/z + a2/z²)
struct SecondOrderSection {
  double b0 = 0.0;
  double b1 = 0.0;
  double b2 = 0.0;
  double a1 = 0.0;
  double a2 = 0.0;
  /// 1 + a1 + a2, and of the numerator without its gain, as products of distances of the roots from
  /// 1: the sums have lost their digits where the roots are near.
  double a_at_one = 0.0;
  double b_at_one = 0.0;
};

/// Sections in the order in which a sample passes them.
struct Sections {
  std::array<SecondOrderSection, Roots::kMax / 2> sections{};
  std::size_t count = 0;
};

/// A digital filter: gain · Π(z − zero) / Π(z − pole), with as many zeros as poles.
struct Digital {
  Roots zeros;
  Roots poles;
  double gain;
};

namespace butterworth {

/// z² + linear·z + constant
struct Quadratic {
  double linear;
  double constant;
  double at_one;
};
constexpr Quadratic of_pair(Complex root) {
  return {-2.0 * root.re, squared_magnitude(root), squared_magnitude(Complex{1.0} - root)};
}
constexpr Quadratic of_reals(double first, double second) {
  return {-(first + second), first * second, (1.0 - first) * (1.0 - second)};
}

/// Index of the smallest of `distance(0)`, …, `distance(count − 1)`; the first of equal ones.
template <class Distance>
constexpr std::size_t nearest(std::size_t count, Distance distance) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < count; ++i) {
    if (distance(i) < distance(best)) best = i;
  }
  return best;
}

constexpr double from_unit_circle(Complex z) {
  return eagerx::abs(1.0 - magnitude(z));
}

/// The two zeros for a section with pole `pole`: a conjugate pair, or the two nearest real ones.
constexpr Quadratic take_zeros(Roots& zeros, Complex pole) {
  const auto from_pole = [pole](Complex zero) { return magnitude(zero - pole); };
  const auto pair_distance = [&](std::size_t i) { return from_pole(zeros.pairs[i]); };
  const auto real_distance = [&](std::size_t i) { return from_pole(Complex{zeros.reals[i]}); };
  const std::size_t pair = nearest(zeros.pair_count, pair_distance);
  const std::size_t real = nearest(zeros.real_count, real_distance);
  const bool use_pair =
      zeros.pair_count > 0 && (zeros.real_count == 0 || pair_distance(pair) <= real_distance(real));
  if (use_pair) return of_pair(zeros.take_pair(pair));
  const double first = zeros.take_real(real);
  return of_reals(first, zeros.take_real(nearest(zeros.real_count, real_distance)));
}

/// Takes the poles nearest to the unit circle and the zeros nearest to them.
constexpr SecondOrderSection take_section(Roots& zeros, Roots& poles) {
  const auto pair_distance = [&](std::size_t i) { return from_unit_circle(poles.pairs[i]); };
  const auto real_distance = [&](std::size_t i) {
    return from_unit_circle(Complex{poles.reals[i]});
  };
  const std::size_t pair = nearest(poles.pair_count, pair_distance);
  const std::size_t real = nearest(poles.real_count, real_distance);
  const bool use_pair =
      poles.pair_count > 0 && (poles.real_count == 0 || pair_distance(pair) <= real_distance(real));
  Complex pole;
  Quadratic denominator{};
  if (use_pair) {
    pole = poles.take_pair(pair);
    denominator = of_pair(pole);
  } else {
    pole = Complex{poles.take_real(real)};
    denominator = of_reals(pole.re, poles.take_real(nearest(poles.real_count, real_distance)));
  }
  const Quadratic numerator = take_zeros(zeros, pole);
  return {.b0 = 1.0,
          .b1 = numerator.linear,
          .b2 = numerator.constant,
          .a1 = denominator.linear,
          .a2 = denominator.constant,
          .a_at_one = denominator.at_one,
          .b_at_one = numerator.at_one};
}

}  // namespace butterworth

/// Sections as scipy.signal.zpk2sos(…, pairing="nearest") makes them: from the last to the first,
/// the poles nearest to the unit circle with the zeros nearest to them; the gain is in the first
/// section. An odd number of roots is made even by a zero and a pole at 0.
constexpr Sections to_sections(Digital filter) {
  if (filter.poles.count() % 2 == 1) {
    filter.poles.add_real(0.0);
    filter.zeros.add_real(0.0);
  }
  Sections result;
  result.count = filter.poles.count() / 2;
  for (std::size_t i = result.count; i > 0; --i) {
    result.sections[i - 1] = butterworth::take_section(filter.zeros, filter.poles);
  }
  result.sections[0].b0 *= filter.gain;
  result.sections[0].b1 *= filter.gain;
  result.sections[0].b2 *= filter.gain;
  return result;
}

}  // namespace eagerx::models

// Butterworth filters as second-order sections, computed by the compiler.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <models/nodes/butterworth_filter/complex.hpp>
#include <models/nodes/butterworth_filter/roots.hpp>
#include <models/nodes/butterworth_filter/sections.hpp>
#include <numbers>

namespace eagerx::models {

enum class FilterType : std::uint8_t { lowpass, highpass, bandpass, bandstop };

inline constexpr int kMaxButterworthOrder = 8;

constexpr bool is_band(FilterType type) {
  return type == FilterType::bandpass || type == FilterType::bandstop;
}

/// A band filter has twice the poles of its order.
constexpr std::size_t butterworth_section_count(int order, FilterType type) {
  const auto n = static_cast<std::size_t>(order);
  return is_band(type) ? n : (n + 1) / 2;
}

namespace butterworth {

/// Poles of the analogue lowpass of cut-off 1 rad/s: on the left half of the unit circle.
constexpr Roots prototype_poles(int order) {
  Roots poles;
  for (int m = order % 2 == 0 ? 1 : 2; m < order; m += 2) {
    const double angle = std::numbers::pi * m / (2.0 * order);
    poles.add_pair({-eagerx::cos(angle), eagerx::sin(angle)});
  }
  if (order % 2 == 1) poles.add_real(-1.0);
  return poles;
}

/// s → s / cutoff
constexpr Roots lowpass_poles(const Roots& prototype, double cutoff) {
  return prototype.mapped([cutoff](Complex p) { return p * Complex{cutoff}; });
}

/// s → cutoff / s
constexpr Roots highpass_poles(const Roots& prototype, double cutoff) {
  return prototype.mapped([cutoff](Complex p) { return Complex{cutoff} / p; });
}

/// Each root p becomes the two solutions of s² − 2ps + center² = 0.
constexpr Roots shifted_to_band(const Roots& half_width, double center) {
  Roots result;
  const auto root_of = [center](Complex p) {
    return square_root(p * p - Complex{center * center});
  };
  for (std::size_t i = 0; i < half_width.pair_count; ++i) {
    const Complex p = half_width.pairs[i];
    result.add_pair(p + root_of(p));
    result.add_pair(p - root_of(p));
  }
  for (std::size_t i = 0; i < half_width.real_count; ++i) {
    const Complex p{half_width.reals[i]};
    const Complex root = root_of(p);
    if (root.im != 0.0) {
      result.add_pair(p + root);
    } else {
      result.add_real(p.re + root.re);
      result.add_real(p.re - root.re);
    }
  }
  return result;
}

/// An analogue filter: gain · Π(s − zero) / Π(s − pole), with zeros at one place only, if any.
struct Analogue {
  Roots zeros;
  Roots poles;
  double gain;
};

constexpr Analogue analogue(int order, FilterType type, double low, double high) {
  const Roots prototype = prototype_poles(order);
  const double width = high - low;
  const double center = eagerx::sqrt(low * high);
  Analogue filter{.zeros = {}, .poles = {}, .gain = 1.0};
  switch (type) {
    case FilterType::lowpass:
      filter.poles = lowpass_poles(prototype, low);
      for (int i = 0; i < order; ++i) filter.gain *= low;
      break;
    case FilterType::highpass:
      filter.poles = highpass_poles(prototype, low);
      for (int i = 0; i < order; ++i) filter.zeros.add_real(0.0);
      break;
    case FilterType::bandpass:
      filter.poles = shifted_to_band(lowpass_poles(prototype, width / 2.0), center);
      for (int i = 0; i < order; ++i) {
        filter.zeros.add_real(0.0);
        filter.gain *= width;
      }
      break;
    case FilterType::bandstop:
      filter.poles = shifted_to_band(highpass_poles(prototype, width / 2.0), center);
      for (int i = 0; i < order; ++i) filter.zeros.add_pair({0.0, center});
      break;
  }
  return filter;
}

/// s → fs2·(z − 1)/(z + 1), with fs2 twice the sample rate. Zeros at infinity come to z = −1.
constexpr Digital bilinear(const Analogue& filter, double fs2) {
  const auto to_z = [fs2](Complex s) { return (Complex{fs2} + s) / (Complex{fs2} - s); };
  const auto distance = [fs2](Complex s) { return Complex{fs2} - s; };
  Digital result{
      .zeros = filter.zeros.mapped(to_z), .poles = filter.poles.mapped(to_z), .gain = filter.gain};
  result.gain *= filter.zeros.mapped(distance).product() / filter.poles.mapped(distance).product();
  while (result.zeros.count() < result.poles.count()) result.zeros.add_real(-1.0);
  return result;
}

}  // namespace butterworth

/// The digital Butterworth filter of `order` 1 to 8 with its corners (−3 dB) at `low_hz` and, for
/// band filters, `high_hz`, sampled at `rate_hz`; 0 < low_hz < high_hz < rate_hz / 2.
///
/// The same sections in the same order as scipy.signal.butter(order, …, fs=rate_hz, output="sos"),
/// to 1e-12. Where two pole pairs are equally far from the unit circle (a band filter with
/// low_hz + high_hz = rate_hz / 2), scipy's order depends on rounding and may be another one.
///
/// Method: analogue prototype, frequency transformation with prewarped corners, bilinear
/// transformation. Oppenheim, Schafer: Discrete-Time Signal Processing, chapter 7, appendix B.
constexpr Sections design_butterworth(int order, FilterType type, double low_hz, double high_hz,
                                      double rate_hz) {
  constexpr double kFs2 = 4.0;  // scipy designs for a sample rate of 2
  const auto prewarped = [rate_hz](double hz) {
    return kFs2 * eagerx::tan(std::numbers::pi * hz / rate_hz);
  };
  const auto analogue = butterworth::analogue(order, type, prewarped(low_hz), prewarped(high_hz));
  return to_sections(butterworth::bilinear(analogue, kFs2));
}

}  // namespace eagerx::models

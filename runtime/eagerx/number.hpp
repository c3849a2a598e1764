// Numbers of a program that is linearized: doubles with derivatives, which record their addresses
// and whether derivatives were lost or smoothed.
#pragma once

#include <cstddef>
#include <eagerx/math/dual.hpp>
#include <limits>
#include <type_traits>

namespace eagerx {

namespace linearize {

/// Number of derivatives that one run computes.
inline constexpr std::size_t kSeeds = 16;

/// If not null, called for each number that is constructed.
inline void (*born)(const void* number) = nullptr;

/// The effect of a node on derivatives.
struct Doings {
  bool lost = false;      // read a number as a plain one
  bool smoothed = false;  // took the mean slope of steps
};
inline Doings doings;

/// Whether quantized() has steps; without, it is what it is on average.
inline bool has_steps = true;

}  // namespace linearize

template <>
struct DualBirth<double, linearize::kSeeds> {
  constexpr DualBirth() {
    if (!std::is_constant_evaluated() && linearize::born != nullptr) linearize::born(this);
  }
  /// A copied member is also constructed.
  constexpr DualBirth(const DualBirth& /*other*/) : DualBirth() {}
  constexpr DualBirth& operator=(const DualBirth& /*other*/) = default;
  ~DualBirth() = default;
};

/// The type of numbers in engines, nodes and messages, regardless of their types in the graph.
using Number = Dual<double, linearize::kSeeds>;

namespace linearize {
constexpr bool has_derivative(const Number& x) {
  for (const double d : x.derivative) {
    if (d != 0.0) return true;
  }
  return false;
}
}  // namespace linearize

/// Noise is replaced with its mean, 0.
inline void set_noise_lane(Number& /*x*/, int /*i*/, double /*value*/) {}
/// Lane-by-lane operations lose the derivatives.
inline double lane(const Number& x, int /*i*/) {
  linearize::doings.lost = linearize::doings.lost || linearize::has_derivative(x);
  return x.value;
}
inline void set_lane(Number& x, int /*i*/, double value) {
  x = Number(value);
}
inline Number quantized(const Number& x, const Number& step) {
  linearize::doings.smoothed = linearize::doings.smoothed || linearize::has_derivative(x);
  return linearize::has_steps ? quantized<double, linearize::kSeeds>(x, step) : x;
}

}  // namespace eagerx

/// Their limits are those of double.
template <>
struct std::numeric_limits<eagerx::Number> : std::numeric_limits<double> {};

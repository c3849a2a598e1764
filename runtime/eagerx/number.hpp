// The numbers of a program that is linearized: doubles with derivatives, which report where they
// are and what became of their derivatives.
#pragma once

#include <cstddef>
#include <eagerx/math/dual.hpp>
#include <limits>
#include <type_traits>

namespace eagerx {

namespace linearize {

/// Derivatives that one run gives.
inline constexpr std::size_t kSeeds = 16;

/// Called with each number that begins to exist, while it is not null.
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
  /// A member that begins as a copy begins to exist, too.
  constexpr DualBirth(const DualBirth& /*other*/) : DualBirth() {}
  constexpr DualBirth& operator=(const DualBirth& /*other*/) = default;
  ~DualBirth() = default;
};

/// Numbers of engines, nodes and messages, whatever the graph says of them.
using Number = Dual<double, linearize::kSeeds>;

namespace linearize {
constexpr bool has_derivative(const Number& x) {
  for (const double d : x.derivative) {
    if (d != 0.0) return true;
  }
  return false;
}
}  // namespace linearize

/// Noise has its mean, 0.
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

/// Their bounds are those of what they consist of.
template <>
struct std::numeric_limits<eagerx::Number> : std::numeric_limits<double> {};

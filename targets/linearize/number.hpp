// The numbers of a program that is linearized: doubles with derivatives, which tell where they are.
#pragma once

#include <cstddef>
#include <eagerx/math/dual.hpp>
#include <limits>
#include <type_traits>
#include <vector>

namespace eagerx {

namespace linearize {

/// Derivatives that one run gives.
inline constexpr std::size_t kSeeds = 16;

/// Where numbers have begun to exist, while it is not null.
inline std::vector<const void*>* born = nullptr;
/// Whether derivatives were lost: a number was read as a plain one.
inline bool lost = false;

}  // namespace linearize

template <>
struct DualBirth<double, linearize::kSeeds> {
  constexpr DualBirth() {
    if (!std::is_constant_evaluated() && linearize::born != nullptr)
      linearize::born->push_back(this);
  }
};

/// Numbers of engines, nodes and messages, whatever the graph says of them.
using Number = Dual<double, linearize::kSeeds>;

/// What works lane by lane loses the derivatives, and says so.
inline double lane(const Number& x, int /*i*/) {
  for (const double d : x.derivative) linearize::lost = linearize::lost || d != 0.0;
  return x.value;
}
inline void set_lane(Number& x, int /*i*/, double value) {
  x = Number(value);
}

}  // namespace eagerx

/// Their bounds are those of what they consist of.
template <>
struct std::numeric_limits<eagerx::Number> : std::numeric_limits<double> {};

// Converts the floating-point numbers of rows into elements of messages.
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

namespace eagerx::target {

/// Whole numbers are cut towards zero and moved into their type's range, NaN becomes 0 where the
/// type has none. `Number` is float or double.
template <class T, class Number>
T from_number(Number x) {
  if constexpr (std::is_same_v<T, bool>) {
    return x == x && x != Number{0};
  } else if constexpr (std::is_integral_v<T>) {
    if (x != x) return T{0};
    // Exact powers of two, unlike the highest number of the type.
    const Number beyond = std::ldexp(Number{1}, std::numeric_limits<T>::digits);
    if (x >= beyond) return std::numeric_limits<T>::max();
    if (x <= static_cast<Number>(std::numeric_limits<T>::min()))
      return std::numeric_limits<T>::min();
    return static_cast<T>(x);
  } else {
    return static_cast<T>(x);
  }
}

}  // namespace eagerx::target

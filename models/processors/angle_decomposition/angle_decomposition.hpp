// One angle of an array as a point on the unit circle.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// Element `index` θ [rad] of a message with n elements becomes cos θ, sin θ; the others keep their
/// order. n + 1 elements.
/// Source: eagerx_dcsc_setups, pendulum/processors.py.
template <class Io>
struct AngleDecomposition {
  static typename Io::Output convert(const typename Io::Input& in) {
    using Scalar = ScalarOf<typename Io::Output>;
    constexpr auto kIndex = static_cast<std::size_t>(Io::Config::index);
    static_assert(kIndex < size_of<typename Io::Input>,
                  "AngleDecomposition: `index` is beyond the end of the message");
    static_assert(size_of<typename Io::Output> == size_of<typename Io::Input> + 1,
                  "AngleDecomposition: `size` must be one more than the message has elements");
    typename Io::Output out{};
    for (std::size_t i = 0; i < size_of<typename Io::Input>; ++i) {
      if (i != kIndex) element(out, i < kIndex ? i : i + 1) = static_cast<Scalar>(element(in, i));
    }
    const auto angle = static_cast<typename Io::Real>(element(in, kIndex));
    const auto both = eagerx::sincos(angle);
    element(out, kIndex) = static_cast<Scalar>(both.cos);
    element(out, kIndex + 1) = static_cast<Scalar>(both.sin);
    return out;
  }
};

}  // namespace eagerx::models

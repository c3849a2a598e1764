// An angle as a point on the unit circle.
#pragma once

#include <eagerx/math.hpp>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// θ [] in rad becomes [cos θ, sin θ] [2], which has no jump at ±π.
template <class Io>
struct DecomposedAngle {
  static typename Io::Output convert(const typename Io::Input& in) {
    using Scalar = ScalarOf<typename Io::Output>;
    static_assert(size_of<typename Io::Input> == 1 && size_of<typename Io::Output> == 2,
                  "DecomposedAngle: one angle in, cosine and sine out");
    const auto angle = static_cast<typename Io::Real>(element(in, 0));
    const auto both = eagerx::sincos(angle);
    return {{static_cast<Scalar>(both.cos), static_cast<Scalar>(both.sin)}};
  }
};

}  // namespace eagerx::models

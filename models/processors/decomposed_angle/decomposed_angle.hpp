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
    return {{static_cast<Scalar>(eagerx::cos(angle)), static_cast<Scalar>(eagerx::sin(angle))}};
  }
};

}  // namespace eagerx::models

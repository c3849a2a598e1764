// The processor of the exercise of tutorial 3. Not finished.
#pragma once

#include <eagerx/math.hpp>
#include <eagerx/message.hpp>

namespace tutorial {

/// θ [rad] becomes [cos θ, sin θ]: no jump anywhere.
template <class Io>
struct CosineAndSine {
  static eagerx::Array<float, 2> convert(const float& angle) {
    return {{angle, 0}};  // To do: cosine and sine
  }
};

}  // namespace tutorial

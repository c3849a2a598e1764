// Actions that are the tanh of a normal distribution (Haarnoja et al. 2018, appendix C).
#pragma once

#include <eagerx/math.hpp>

#include "targets/environments/train/sac/settings.hpp"

namespace eagerx::train::sac {

/// The logarithm of the deviation, from the tanh of the network's output: between the least and the
/// most.
inline float log_deviation_of(float squashed) {
  constexpr float kHalf = 0.5F * (kMostLogDeviation - kLeastLogDeviation);
  return kLeastLogDeviation + kHalf * (squashed + 1.0F);
}
/// Its derivative by the network's output.
inline float log_deviation_slope(float squashed) {
  constexpr float kHalf = 0.5F * (kMostLogDeviation - kLeastLogDeviation);
  return kHalf * (1.0F - squashed * squashed);
}

/// log(1 - tanh(x)²), also where tanh(x) is 1 in float.
inline float log_tanh_slope(float x) {
  constexpr float kLogTwo = 0.6931472F;
  const float size = abs(x);
  return 2.0F * (kLogTwo - size - log(1.0F + exp(-2.0F * size)));
}

/// The logarithm of the density of tanh(x) for x = mean + deviation * noise.
inline float log_probability_of(float noise, float log_deviation, float x) {
  constexpr float kHalfLogTwoPi = 0.9189385F;
  return -0.5F * noise * noise - log_deviation - kHalfLogTwoPi - log_tanh_slope(x);
}

}  // namespace eagerx::train::sac

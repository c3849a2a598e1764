// The order of additions that eagerx/policy.hpp documents, as plain loops.
#pragma once

#include <cstddef>

namespace eagerx::test {

/// Output `out` of `outputs`: w [inputs], x [inputs].
inline float plain_sum(const float* w, const float* x, std::size_t inputs, float bias,
                       std::size_t out, std::size_t outputs) {
  if (out + 1 == outputs && outputs % 8 == 1) {  // alone in its panel
    float s[16] = {};
    for (std::size_t k = 0; k < inputs && k < 16; ++k) s[k] = w[k] * x[k];
    for (std::size_t j = 16; j < inputs; j += 16) {
      for (std::size_t k = 0; k < 16; ++k) {
        s[k] = s[k] + (j + k < inputs ? w[j + k] * x[j + k] : 0.0F);
      }
    }
    for (const std::size_t half : {8U, 4U, 2U, 1U}) {
      for (std::size_t k = 0; k < half; ++k) s[k] = s[k] + s[k + half];
    }
    return bias + s[0];
  }
  float sum = bias;
  for (std::size_t first = 0; first < inputs; first += 8) {
    float group = w[first] * x[first];
    for (std::size_t j = first + 1; j < inputs && j < first + 8; ++j) group = group + w[j] * x[j];
    sum = sum + group;
  }
  return sum;
}

}  // namespace eagerx::test

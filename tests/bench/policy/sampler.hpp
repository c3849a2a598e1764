// Weights sampled by a fixed rule, the same on every machine.
#pragma once

#include <cstdint>

namespace bench {

/// Numbers in -1/4…1/4 that are exact in float32.
class Sampler {
 public:
  constexpr float next() {
    state_ = state_ * 1664525U + 1013904223U;
    return static_cast<float>(state_ >> 16U) * 0x1p-17F - 0.25F;
  }

 private:
  std::uint32_t state_ = 1;
};

}  // namespace bench

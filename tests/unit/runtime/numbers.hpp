// Numbers for tests of networks.
#pragma once

#include <bit>
#include <cstdint>

namespace eagerx::test {

/// Numbers of mixed sign and size, the same on every machine.
class Numbers {
 public:
  explicit Numbers(std::uint32_t seed) : state_(seed * 2654435761U + 1U) {}
  float next() {
    state_ = state_ * 1664525U + 1013904223U;
    const float unit = static_cast<float>(state_ >> 8U) * 0x1p-24F - 0.5F;
    return (state_ & 0x80U) != 0 ? unit * 16.0F : unit * 0.01F;
  }

 private:
  std::uint32_t state_;
};

/// The bits of a result; one NaN for all NaNs, whose sign and payload are the machine's.
inline std::uint32_t bits_of(float x) {
  return x != x ? 0x7fc00000U : std::bit_cast<std::uint32_t>(x);
}

}  // namespace eagerx::test

// Checks the floating-point mode of the processor: a library, or linking with -ffast-math, can make
// it flush denormal numbers to zero, and then bits differ.
#pragma once

#include <bit>
#include <cstdint>

namespace eagerx {

/// True if the processor keeps denormal results and operands, and rounds to nearest. Tests this by
/// calculation, so that it works on every machine.
inline bool calculates_as_everywhere() {
  // Compares bits, because a comparison of numbers may also treat denormals as zero. `volatile`
  // leaves each calculation to the processor.
  const volatile float least = 0x1p-126F;
  const volatile float denormal = 0x1p-149F;
  const volatile float one = 1.0F;
  const volatile float half = 0.5F;
  const volatile float above = 0x1p-25F;  // less than half a unit in the last place of 1
  const volatile float below = 0x1p-26F;
  const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x); };
  bool right = bits(least * half) == 0x0040'0000U && bits(denormal + denormal) == 2U &&
               bits(one + above) == bits(1.0F) && bits(one - below) == bits(1.0F);
#if !defined(__arm__) || (defined(__ARM_FP) && (__ARM_FP & 8) != 0)
  // Without a double-precision unit, no mode affects doubles, and a board saves the functions.
  const volatile double least_d = 0x1p-1022;
  const volatile double denormal_d = 0x1p-1074;
  const volatile double one_d = 1.0;
  const volatile double half_d = 0.5;
  const volatile double above_d = 0x1p-54;
  const volatile double below_d = 0x1p-55;
  const auto bits_d = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  right = right && bits_d(least_d * half_d) == 0x0008'0000'0000'0000U &&
          bits_d(denormal_d + denormal_d) == 2U && bits_d(one_d + above_d) == bits_d(1.0) &&
          bits_d(one_d - below_d) == bits_d(1.0);
#endif
  return right;
}

}  // namespace eagerx

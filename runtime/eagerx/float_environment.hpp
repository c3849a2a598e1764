// Whether the processor calculates as everywhere else: a library, or a program that is linked with
// -ffast-math, can tell it to take denormal numbers for zero, and then bits differ.
#pragma once

#include <bit>
#include <cstdint>

namespace eagerx {

/// True if denormal numbers are kept, as results and as operands, and results are rounded to the
/// nearest. Found out by calculating, in float and double, so that it holds for every machine.
inline bool calculates_as_everywhere() {
  // The compiler must leave each of these to the processor.
  const volatile float least_f = 0x1p-126F;
  const volatile float denormal_f = 0x1p-149F;
  const volatile float one_f = 1.0F;
  const volatile float half_f = 0.5F;
  const volatile float above_f = 0x1p-25F;  // less than half a unit in the last place of 1
  const volatile float below_f = 0x1p-26F;
  const volatile double least_d = 0x1p-1022;
  const volatile double denormal_d = 0x1p-1074;
  const volatile double one_d = 1.0;
  const volatile double half_d = 0.5;
  const volatile double above_d = 0x1p-54;
  const volatile double below_d = 0x1p-55;
  const auto bits_f = [](float x) { return std::bit_cast<std::uint32_t>(x); };
  const auto bits_d = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  // Bits are compared, because a comparison of numbers may take denormal ones for zero, too.
  return bits_f(least_f * half_f) == 0x0040'0000U && bits_f(denormal_f + denormal_f) == 2U &&
         bits_f(one_f + above_f) == bits_f(1.0F) && bits_f(one_f - below_f) == bits_f(1.0F) &&
         bits_d(least_d * half_d) == 0x0008'0000'0000'0000U &&
         bits_d(denormal_d + denormal_d) == 2U && bits_d(one_d + above_d) == bits_d(1.0) &&
         bits_d(one_d - below_d) == bits_d(1.0);
}

}  // namespace eagerx

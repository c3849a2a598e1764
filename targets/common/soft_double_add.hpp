// Correctly rounded addition of IEEE 754 doubles in integers.
//
// Boards without a double unit (Cortex-M3, M4F) add doubles with libgcc's __aeabi_dadd,
// __aeabi_dsub and __aeabi_drsub. In libgcc 12.2 these are one unit in the last place off in a rare
// case: the exponents differ by 33, the operands have opposite signs, and the difference loses a
// binary place. x86 and boards with a double unit round correctly, so a graph in double would give
// other bits there.
//
// Tested on the host against the processor's own addition
// (tests/unit/targets/soft_double_add_test.cpp) and on the emulated Cortex-M3 and M4F by
// tests/bits/, whose hash differs without it.
#pragma once

#include <bit>
#include <cstdint>

namespace eagerx::board {

namespace double_bits {

inline constexpr int kMantissaBits = 52;
inline constexpr std::uint64_t kSign = std::uint64_t{1} << 63U;
inline constexpr std::uint64_t kLeadingOne = std::uint64_t{1} << kMantissaBits;
inline constexpr std::uint64_t kMantissa = kLeadingOne - 1;
inline constexpr std::uint64_t kQuiet = kLeadingOne >> 1U;
inline constexpr int kInfinityExponent = 2047;
inline constexpr std::uint64_t kInfinity = std::uint64_t{kInfinityExponent} << kMantissaBits;
inline constexpr int kGuardBits = 10;  // below the mantissa; the lowest one is sticky

/// A magnitude as mantissa * 2^exponent, the mantissa with its leading one and kGuardBits more.
struct Magnitude {
  std::uint64_t mantissa;
  int exponent;
};

constexpr Magnitude unpack(std::uint64_t bits) {
  const int exponent = static_cast<int>((bits & ~kSign) >> kMantissaBits);
  const std::uint64_t mantissa = bits & kMantissa;
  if (exponent == 0) return {mantissa << kGuardBits, 1};  // subnormal
  return {(mantissa | kLeadingOne) << kGuardBits, exponent};
}

/// `value` / 2^places; the last bit is set if any bit that is dropped was ("sticky").
constexpr std::uint64_t shift_right_sticky(std::uint64_t value, int places) {
  constexpr int kWidth = 64;
  if (places == 0) return value;
  if (places >= kWidth) return value != 0 ? 1U : 0U;
  const std::uint64_t dropped = value << (kWidth - places);
  return (value >> places) | (dropped != 0 ? 1U : 0U);
}

/// The magnitude, moved to where a double has its leading one and rounded to nearest, ties to even.
constexpr std::uint64_t pack(Magnitude value) {
  constexpr int kLeadingZeros = 1;  // of a mantissa with its leading one in place
  if (std::countl_zero(value.mantissa) < kLeadingZeros) {
    value.mantissa = shift_right_sticky(value.mantissa, 1);
    ++value.exponent;
  } else {  // as far left as it goes, but no exponent is smaller than that of subnormals
    const int zeros = std::countl_zero(value.mantissa) - kLeadingZeros;
    const int places = zeros < value.exponent - 1 ? zeros : value.exponent - 1;
    value.mantissa <<= places;
    value.exponent -= places;
  }
  if (value.exponent >= kInfinityExponent) return kInfinity;
  constexpr std::uint64_t kHalf = std::uint64_t{1} << (kGuardBits - 1);
  const std::uint64_t rest = value.mantissa & (2 * kHalf - 1);
  const std::uint64_t mantissa = value.mantissa >> kGuardBits;
  const bool up = rest > kHalf || (rest == kHalf && mantissa % 2 != 0);
  // The leading one of a normal mantissa adds the last 1 to the exponent; a carry does the same.
  return (static_cast<std::uint64_t>(value.exponent - 1) << kMantissaBits) + mantissa +
         (up ? 1U : 0U);
}

}  // namespace double_bits

/// The bits of a + b, rounded to nearest, ties to even. NaN operands and inf - inf result in a
/// quiet NaN.
constexpr std::uint64_t add_doubles(std::uint64_t a, std::uint64_t b) {
  using namespace double_bits;
  if ((a & ~kSign) < (b & ~kSign)) {  // a is the one of larger magnitude
    const std::uint64_t larger = b;
    b = a;
    a = larger;
  }
  const std::uint64_t sign = a & kSign;
  const bool subtract = ((a ^ b) & kSign) != 0;
  if ((a & ~kSign) > kInfinity) return a | kQuiet;
  if ((a & ~kSign) == kInfinity) {
    const bool opposite_infinities = subtract && (b & ~kSign) == kInfinity;
    return opposite_infinities ? kInfinity | kQuiet : a;
  }
  if ((a & ~kSign) == 0) return a & b;  // zeros: negative only if both are

  Magnitude sum = unpack(a);
  const Magnitude smaller = unpack(b);
  const std::uint64_t aligned =
      shift_right_sticky(smaller.mantissa, sum.exponent - smaller.exponent);
  sum.mantissa = subtract ? sum.mantissa - aligned : sum.mantissa + aligned;
  if (sum.mantissa == 0) return 0;  // x - x is +0
  return sign | pack(sum);
}

/// The bits of a - b.
constexpr std::uint64_t subtract_doubles(std::uint64_t a, std::uint64_t b) {
  return add_doubles(a, b ^ double_bits::kSign);
}

}  // namespace eagerx::board

// The operations that the mathematics is written in. A SIMD vector that provides them (with
// arithmetic, comparisons and a broadcasting constructor) can use every function of eagerx/math.hpp
// unchanged.
#pragma once

#include <bit>
#include <cfloat>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

static_assert(FLT_EVAL_METHOD == 0,
              "eagerx needs float and double to be evaluated in their own precision; on 32-bit x86 "
              "compile with -msse2 -mfpmath=sse");
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) || \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error "eagerx computes the same bits on every target: compile without -ffast-math and its parts"
#endif

namespace eagerx {

/// The element type of a number, or of a SIMD vector. SIMD vectors specialize it.
template <class R>
struct LaneTraits;
template <>
struct LaneTraits<float> {
  using Lane = float;
  using Bits = std::uint32_t;
  static constexpr int kLanes = 1;
};
template <>
struct LaneTraits<double> {
  using Lane = double;
  using Bits = std::uint64_t;
  static constexpr int kLanes = 1;
};

/// The type of one lane: float or double.
template <class R>
using LaneOf = typename LaneTraits<R>::Lane;
/// Unsigned integers of the same width and number of lanes.
template <class R>
using BitsOf = typename LaneTraits<R>::Bits;
template <class R>
inline constexpr int lanes = LaneTraits<R>::kLanes;

/// Counts that entities keep: as wide as R, so that one environment is every Nth word of a SIMD
/// vector.
template <class R>
using CountOf = BitsOf<R>;

/// A number, or a SIMD vector, that the functions of eagerx/math.hpp take.
template <class R>
concept Floating = std::is_floating_point_v<typename LaneTraits<R>::Lane>;

/// `when_true` if `mask` is true, else `when_false`, lane by lane; both are computed.
template <class T>
requires std::is_arithmetic_v<T>
constexpr T select(bool mask, T when_true, std::type_identity_t<T> when_false) {
  return mask ? when_true : when_false;
}
/// The truth values of comparisons of R: bool, or a mask.
template <class R>
using TruthOf = decltype(std::declval<R>() < std::declval<R>());
/// 1 if the mask is true, else 0, lane by lane.
template <class R>
constexpr CountOf<R> one_if(TruthOf<R> mask) {
  return select(mask, CountOf<R>(1U), CountOf<R>(0U));
}
/// True if the mask is true in any lane.
constexpr bool any(bool mask) {
  return mask;
}

/// The IEEE 754 bits of a number, and back.
constexpr std::uint32_t bits(float x) {
  return std::bit_cast<std::uint32_t>(x);
}
constexpr std::uint64_t bits(double x) {
  return std::bit_cast<std::uint64_t>(x);
}
constexpr float unbits(std::uint32_t x) {
  return std::bit_cast<float>(x);
}
constexpr double unbits(std::uint64_t x) {
  return std::bit_cast<double>(x);
}

/// Lane `i` of a number or SIMD vector; `set_lane` replaces it. For operations that cannot be
/// vectorized.
template <class T>
requires std::is_arithmetic_v<T>
constexpr T lane(T x, int /*i*/) {
  return x;
}
template <class T>
requires std::is_arithmetic_v<T>
constexpr void set_lane(T& x, int /*i*/, T value) {
  x = value;
}
/// The same for noise, which numbers with derivatives replace with its mean.
template <class T, class Lane>
constexpr void set_noise_lane(T& x, int i, Lane value) {
  set_lane(x, i, value);
}

/// The layout of IEEE 754 binary32 and binary64.
template <class T>
struct FloatFormat {
  using Bits = BitsOf<T>;
  static constexpr int kWidth = static_cast<int>(sizeof(T)) * 8;
  static constexpr int kMantissaBits = sizeof(T) == 4 ? 23 : 52;
  static constexpr int kDigits = kMantissaBits + 1;
  static constexpr int kBias = sizeof(T) == 4 ? 127 : 1023;
  static constexpr Bits kSign = Bits{1} << (kWidth - 1);
  static constexpr Bits kMantissa = (Bits{1} << kMantissaBits) - 1;
  static constexpr Bits kInfinity = ~(kSign | kMantissa);
  static constexpr Bits kOne = Bits{kBias} << kMantissaBits;
  static constexpr T infinity = unbits(kInfinity);
  static constexpr T nan = unbits(kInfinity | (Bits{1} << (kMantissaBits - 1)));
  static constexpr T smallest_normal = unbits(Bits{1} << kMantissaBits);
  /// 1.5 * 2^kMantissaBits. x + kRounder has no bits after the point, so (x + kRounder) - kRounder
  /// is x rounded to an integer, and the low bits of x + kRounder are that integer in two's
  /// complement.
  static constexpr T kRounder =
      unbits(((Bits{kBias} + kMantissaBits) << kMantissaBits) | (Bits{1} << (kMantissaBits - 1)));
};

/// 2^exponent, for exponents of normal numbers.
template <class T>
constexpr T power_of_two(int exponent) {
  using Format = FloatFormat<T>;
  return unbits(static_cast<BitsOf<T>>(exponent + Format::kBias) << Format::kMantissaBits);
}

}  // namespace eagerx

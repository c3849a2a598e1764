// Arc functions.
#pragma once

#include <array>
#include <eagerx/math/basic.hpp>
#include <eagerx/math/polynomial.hpp>
#include <eagerx/math/sqrt.hpp>
#include <eagerx/math/vocabulary.hpp>

namespace eagerx {
namespace detail {

/// Coefficients (highest degree first) from tests/accuracy/coefficients.sollya.
template <class T>
struct ArcConstants;
template <>
struct ArcConstants<float> {
  static constexpr float kHalfPi = 0x1.921fb6p0F;
  static constexpr float kHalfPiLow = -0x1.777a5cp-25F;
  static constexpr float kQuarterPi = 0x1.921fcp-1F;  // short: multiples up to 4 are exact
  static constexpr float kQuarterPiLow = -0x1.5777a6p-22F;
  static constexpr float kTanEighthPi = 0x1.a8279ap-2F;
  static constexpr std::array<float, 4> kAtan = {0x1.49bbdep-4F, -0x1.1c3184p-3F, 0x1.992442p-3F,
                                                 -0x1.555452p-2F};
  static constexpr std::array<float, 5> kAsin = {0x1.5959aap-5F, 0x1.8c415ap-6F, 0x1.747b72p-5F,
                                                 0x1.330206p-4F, 0x1.5555c8p-3F};
};
template <>
struct ArcConstants<double> {
  static constexpr double kHalfPi = 0x1.921fb54442d18p0;
  static constexpr double kHalfPiLow = 0x1.1a62633145c07p-54;
  static constexpr double kQuarterPi = 0x1.921fb544p-1;
  static constexpr double kQuarterPiLow = 0x1.0b4611a626331p-35;
  static constexpr double kTanEighthPi = 0x1.a827999fcef32p-2;
  static constexpr std::array<double, 11> kAtan = {
      -0x1.24f7b6643511bp-6, 0x1.37a100414d089p-5, -0x1.9cbdda256fc53p-5, 0x1.df0a9b846bd6ap-5,
      -0x1.10eb649a2e042p-4, 0x1.3b1111994504cp-4, -0x1.745cf86d3dacp-4,  0x1.c71c70e209601p-4,
      -0x1.24924922a2707p-3, 0x1.9999999995681p-3, -0x1.555555555553cp-2};
  static constexpr std::array<double, 12> kAsin = {
      0x1.056d6c813a1d3p-5, -0x1.09d32833a132cp-6, 0x1.3ff4a990b2acep-6, 0x1.abcf5cd7c4303p-8,
      0x1.8ec2fca60444ep-7, 0x1.c6fdc1aaa5332p-7,  0x1.1c6be1a687738p-6, 0x1.6e89f440197a7p-6,
      0x1.f1c72c38fb342p-6, 0x1.6db6db427a4f8p-5,  0x1.333333336e80fp-4, 0x1.555555555539p-3};
};

/// asin of the reduced argument: asin(|x|) up to 1/2, beyond that asin(sqrt((1 - |x|) / 2)), which
/// is (pi/2 - asin|x|) / 2. NaN beyond 1.
template <class R>
struct ArcSine {
  R value;
  decltype(R() < R()) beyond_half;
};
template <class R>
[[gnu::always_inline]] constexpr ArcSine<R> reduced_arc_sine(R x) {
  using T = LaneOf<R>;
  const R a = abs(x);
  const auto beyond_half = a > R(T(0.5));
  const R square = select(beyond_half, (R(T(1)) - a) * R(T(0.5)), a * a);
  const R s = select(beyond_half, sqrt(square), a);
  return {s + s * square * horner(square, ArcConstants<T>::kAsin), beyond_half};
}

}  // namespace detail

/// Angle of the point (x, y) in rad, in [-pi, pi], with all special cases of C99. Largest measured
/// error: 2.4 ulp.
template <Floating R>
constexpr R atan2(R y, std::type_identity_t<R> x) {
  using T = LaneOf<R>;
  using Format = FloatFormat<T>;
  using Constants = detail::ArcConstants<T>;
  const R infinity = R(Format::infinity);
  const R zero = R(T(0));
  const R one = R(T(1));
  const R ay = abs(y);
  const R ax = abs(x);
  // Smaller over larger side; infinite sides as 1 : 1 or 0 : 1, no sides as 0 : 1.
  const auto steep = ay > ax;
  R small = select(steep, ax, ay);
  R large = select(steep, ay, ax);
  const auto infinite = large == infinity;
  small = select(infinite, select(small == infinity, one, zero), small);
  large = select(infinite, one, select(large == zero, one, large));
  // Scaled where their sum could overflow, or where subnormal numbers have too few digits.
  const R tiny = R(Format::smallest_normal);
  R scale = select(large > one / tiny, R(T(0.5)), one);
  scale = select(large < tiny, R(power_of_two<T>(Format::kDigits)), scale);
  small = small * scale;
  large = large * scale;
  // Turned by pi/4 when that makes the ratio smaller.
  const auto turn = small > R(Constants::kTanEighthPi) * large;
  const R ratio = select(turn, small - large, small) / select(turn, small + large, large);
  const R square = ratio * ratio;
  R angle = ratio + ratio * square * detail::horner(square, Constants::kAtan);
  // And back: into the octant of the point, counting quarters of pi apart.
  R quarters = select(turn, one, zero);
  angle = select(steep, -angle, angle);
  quarters = select(steep, R(T(2)) - quarters, quarters);
  const auto left = (bits(x) & BitsOf<R>(Format::kSign)) != BitsOf<R>(0);
  angle = select(left, -angle, angle);
  quarters = select(left, R(T(4)) - quarters, quarters);
  const R magnitude =
      quarters * R(Constants::kQuarterPi) + (angle + quarters * R(Constants::kQuarterPiLow));
  return select((x == x) & (y == y), copysign(magnitude, y), x + y);
}

/// Arc tangent in rad. Largest measured error: 2.4 ulp.
template <Floating R>
constexpr R atan(R x) {
  return atan2(x, R(LaneOf<R>(1)));
}

/// Arc sine in rad. Largest measured error: 2.4 ulp. NaN outside [-1, 1].
template <Floating R>
constexpr R asin(R x) {
  using Constants = detail::ArcConstants<LaneOf<R>>;
  const auto [value, beyond_half] = detail::reduced_arc_sine(x);
  const R turned = R(Constants::kHalfPi) - (value + value - R(Constants::kHalfPiLow));
  return select(x == x, copysign(select(beyond_half, turned, value), x), x);
}

/// Arc cosine in rad. Largest measured error: 1.25 ulp. NaN outside [-1, 1].
template <Floating R>
constexpr R acos(R x) {
  using T = LaneOf<R>;
  using Constants = detail::ArcConstants<T>;
  const auto [value, beyond_half] = detail::reduced_arc_sine(x);
  const R half_pi = R(Constants::kHalfPi);
  const R half_pi_low = R(Constants::kHalfPiLow);
  const R near_zero = half_pi - (copysign(value, x) - half_pi_low);
  const R twice = value + value;
  const R near_one = select(x < R(T(0)), (half_pi - (value - half_pi_low)) * R(T(2)), twice);
  return select(beyond_half, near_one, near_zero);
}

}  // namespace eagerx

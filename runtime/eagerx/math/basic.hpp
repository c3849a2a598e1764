// Sign, comparison and classification: exact.
#pragma once

#include <eagerx/math/vocabulary.hpp>

namespace eagerx {

/// |x|. Exact; clears the sign of NaN and zero too.
template <Floating R>
constexpr R abs(R x) {
  return unbits(bits(x) & BitsOf<R>(~FloatFormat<LaneOf<R>>::kSign));
}

/// x * x, and x * x * x from the left.
template <Floating R>
constexpr R square(R x) {
  return x * x;
}
template <Floating R>
constexpr R cube(R x) {
  return x * x * x;
}

/// The magnitude of `magnitude` with the sign of `sign`. Exact.
template <Floating R>
constexpr R copysign(R magnitude, std::type_identity_t<R> sign) {
  using Format = FloatFormat<LaneOf<R>>;
  return unbits((bits(magnitude) & BitsOf<R>(~Format::kSign)) |
                (bits(sign) & BitsOf<R>(Format::kSign)));
}

/// True for NaN.
template <Floating R>
constexpr auto isnan(R x) {
  return x != x;
}

/// True except for infinities and NaN.
template <Floating R>
constexpr auto isfinite(R x) {
  return abs(x) < R(FloatFormat<LaneOf<R>>::infinity);
}

/// The smaller value, the first of equal ones (also of -0 and 0). If one is NaN: `a`. For integers
/// too.
template <class R>
constexpr R min(R a, std::type_identity_t<R> b) {
  return select(b < a, b, a);
}

/// The larger value, the first of equal ones (also of -0 and 0). If one is NaN: `a`. For integers
/// too.
template <class R>
constexpr R max(R a, std::type_identity_t<R> b) {
  return select(a < b, b, a);
}

/// `x` moved into [low, high], where low <= high. NaN stays NaN. For integers too.
template <class R>
constexpr R clamp(R x, std::type_identity_t<R> low, std::type_identity_t<R> high) {
  return min(max(x, low), high);
}

}  // namespace eagerx

#include "generator/policy/network/shape.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>

#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {

double half(std::uint16_t bits) {
  constexpr unsigned kExponentBits = 0x1f;
  constexpr unsigned kMantissaBits = 10;
  const unsigned exponent = (bits >> kMantissaBits) & kExponentBits;
  const double mantissa = bits & 0x3ffU;
  double value = 0.0;
  if (exponent == kExponentBits) {
    value = mantissa == 0.0 ? std::numeric_limits<double>::infinity()
                            : std::numeric_limits<double>::quiet_NaN();
  } else if (exponent == 0) {
    value = std::ldexp(mantissa, -24);
  } else {
    value = std::ldexp(mantissa + 1024.0, static_cast<int>(exponent) - 25);
  }
  return (bits & 0x8000U) != 0 ? -value : value;
}

std::optional<std::int64_t> element_count(const Dims& dims) {
  std::int64_t bound = 1;  // with 1 for every 0, so that [2^62, 0, 2^62] is refused too
  bool empty = false;
  for (const std::int64_t dim : dims) {
    if (dim < 0 || (dim > 0 && bound > kMaxElements / dim)) return std::nullopt;
    if (dim > 0) bound *= dim;
    empty = empty || dim == 0;
  }
  return empty ? 0 : bound;
}

std::optional<std::int64_t> place_in(std::int64_t at, std::int64_t count) {
  const std::int64_t place = at < 0 ? at + count : at;
  return place >= 0 && place < count ? std::optional(place) : std::nullopt;
}

std::string show(const Dims& dims) {
  return fmt::format("[{}]", join(dims, ", "));
}

}  // namespace eagerx::gen

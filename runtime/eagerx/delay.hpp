// Delays that a reset may change: converts seconds into the units of cursors.
#pragma once

#include <cstdint>

namespace eagerx {

/// x = ceil(delay in ns * Num / Den) for a delay of whole nanoseconds from 0 to LongestNs; see
/// cursor.hpp. Counting nanoseconds keeps a decimal such as 0.06 s exact.
template <std::int64_t Num, std::int64_t Den, std::int64_t LongestNs>
struct DelayQuanta {
  /// Whether the ring has memory for this delay in seconds.
  static constexpr bool accepts(double delay_s) {
    constexpr double kLongest_s = static_cast<double>(LongestNs) / kNsPerSecond;
    return delay_s >= 0.0 && delay_s <= kLongest_s;
  }
  /// A delay that is not accepted counts as the nearest one that is, and NaN as 0.
  static constexpr std::int64_t of(double delay_s) {
    if (!(delay_s > 0.0)) return 0;
    constexpr double kHalf = 0.5;
    const double ns = delay_s * kNsPerSecond + kHalf;
    const auto whole =
        ns < static_cast<double>(LongestNs) ? static_cast<std::int64_t>(ns) : LongestNs;
    return (whole * Num + Den - 1) / Den;
  }

 private:
  static constexpr double kNsPerSecond = 1e9;
};

}  // namespace eagerx

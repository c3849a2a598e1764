// The time of a message, as ROS 2 writes it.
#pragma once

#include <compare>
#include <cstdint>

namespace eagerx::dds {

struct Stamp {
  std::int32_t s = 0;
  std::uint32_t ns = 0;  // below a second
  auto operator<=>(const Stamp&) const = default;
};

/// `ns`: of the trace, 0 or above.
inline Stamp stamp_of(std::int64_t ns) {
  constexpr std::int64_t kSecondInNs = 1'000'000'000;
  return {static_cast<std::int32_t>(ns / kSecondInNs),
          static_cast<std::uint32_t>(ns % kSecondInNs)};
}

}  // namespace eagerx::dds

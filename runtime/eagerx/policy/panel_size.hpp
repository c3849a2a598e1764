// How sums are cut into panels and groups. Part of the bits: never change one alone.
#pragma once

#include <cstddef>

namespace eagerx::policy {

inline constexpr std::size_t kPanel = 8;  // outputs that are computed side by side
inline constexpr std::size_t kGroup =
    8;  // inputs whose products are summed before they join the sum
inline constexpr std::size_t kChains = 16;  // sums of an output that is alone in its panel

/// True for the last of 1, 9, 17, … outputs.
constexpr bool alone_in_panel(std::size_t out, std::size_t outputs) {
  return out + 1 == outputs && outputs % kPanel == 1;
}

}  // namespace eagerx::policy

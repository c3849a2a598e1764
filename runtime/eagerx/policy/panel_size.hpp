// How sums are cut into panels and groups. Part of the bits: never change one alone.
#pragma once

#include <cstddef>

namespace eagerx::policy {

inline constexpr std::size_t kPanel = 8;  // outputs that are computed side by side
inline constexpr std::size_t kGroup =
    8;  // inputs whose products are summed before they join the sum

}  // namespace eagerx::policy

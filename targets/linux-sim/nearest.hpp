// Of some names, the one that was probably meant.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::linux_sim {

/// Letters to insert, remove or replace to make `b` of `a`.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// Empty if none is near.
std::string nearest_name(std::string_view name, const std::vector<std::string>& known);

}  // namespace eagerx::linux_sim

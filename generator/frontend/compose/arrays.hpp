// One element of an array: `$(index)`, and its value of each `{each: […]}`.
#pragma once

#include <optional>

#include "generator/frontend/parameters/config.hpp"

namespace eagerx::gen {

/// The number of elements in `count:`; nullopt without the key. After a problem (E0203, E0204) it
/// is 0.
std::optional<std::int64_t> count_of(const YamlValue& entity, const References& references,
                                     Diagnostics& diagnostics);

/// `entity` without `count:`, for element `index` of `count`. Problems: E0391 a list that does not
/// fit, E0324.
YamlValue element_of(YamlValue entity, std::int64_t index, std::int64_t count,
                     References references, Diagnostics& diagnostics);

/// "leg[2]"
std::string element_name(const std::string& array, std::int64_t index);

}  // namespace eagerx::gen

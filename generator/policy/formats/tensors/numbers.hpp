// Lists of numbers in JSON and in notes of weight files.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "generator/support/json/json.hpp"

namespace eagerx::gen {

/// A list of numbers, or one number, or nothing. Strings as NumPy prints arrays ("[-2.  2.]") and
/// JSON writes them count too.
std::optional<std::vector<double>> numbers_of(const Json* value);

/// The numbers of such a string.
std::optional<std::vector<double>> numbers_in(std::string_view text);

}  // namespace eagerx::gen

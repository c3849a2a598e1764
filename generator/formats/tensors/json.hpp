// JSON out of weight files. nlohmann-json's headers are only included by files that read it.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::gen {

/// The value in `text`, or nothing. Python's NaN and Infinity are null; a key twice is an error.
std::optional<nlohmann::json> parse_json(std::string_view text);

/// A list of numbers, or one number, or nothing. Strings as NumPy prints arrays ("[-2.  2.]") and
/// JSON writes them count too.
std::optional<std::vector<double>> numbers_of(const nlohmann::json& value);

/// The member `key` of an object, or nullptr.
const nlohmann::json* member(const nlohmann::json& value, const char* key);

/// The text of a string, "" of anything else.
std::string text_of(const nlohmann::json* value);

}  // namespace eagerx::gen

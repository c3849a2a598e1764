// Typos that YAML reads as something else: `rate:30`, `rate = 30 Hz`, `kd: 1,5`, `1_000`.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "generator/support/diagnostics/fix.hpp"

namespace eagerx::gen {

/// "1.5" for "1,5", "-0.25 s" for "-0,25 s"; nullopt if the text is not a number with a decimal
/// comma.
std::optional<std::string> with_decimal_point(std::string_view text);

/// A number in the way of another language, and how it is written here.
struct ForeignNumber {
  std::string number;
  Help help;  // "write `1000`: a number has no underscores"
};
/// "1,5" is 1.5, "0x32" is 50, "0100" is 100, "1_000" is 1000; nullopt for other text.
std::optional<ForeignNumber> foreign_number(std::string_view text);

/// A key that holds its value, too, as nothing separates them for YAML: `rate:30`, `rate = 30`.
struct GluedKey {
  std::string key, value;
  std::string help;
};
std::optional<GluedKey> glued_key(std::string_view text);

}  // namespace eagerx::gen

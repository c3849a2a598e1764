// What was meant by text that YAML takes otherwise: `rate:30`, `rate = 30 Hz`, `kd: 1,5`.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace eagerx::gen {

/// "1.5" for "1,5", "-0.25 s" for "-0,25 s"; nullopt for what is no number with a decimal comma.
std::optional<std::string> with_decimal_point(std::string_view text);

/// A key that holds its value, too, as nothing separates them for YAML: `rate:30`, `rate = 30`.
struct GluedKey {
  std::string key, value;
  std::string help;
};
std::optional<GluedKey> glued_key(std::string_view text);

}  // namespace eagerx::gen

#include "generator/frontend/read/slips.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/frontend/read/scalar.hpp"

namespace eagerx::gen {
namespace {

constexpr std::string_view kDigits = "0123456789";
constexpr std::string_view kOfNames =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";

}  // namespace

std::optional<std::string> with_decimal_point(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos || !parse_number(text.substr(0, comma))) return std::nullopt;
  const std::string_view rest = text.substr(comma + 1);
  const std::size_t digits = std::min(rest.find_first_not_of(kDigits), rest.size());
  if (digits == 0 || rest.find(',') != std::string_view::npos) return std::nullopt;
  std::string result(text);
  result[comma] = '.';
  const std::string_view number = std::string_view(result).substr(0, comma + 1 + digits);
  return parse_number(number) ? std::optional(result) : std::nullopt;
}

std::optional<GluedKey> glued_key(std::string_view text) {
  const std::size_t at = text.find_first_of(":=");
  if (at == std::string_view::npos) return std::nullopt;
  const std::string key(trimmed(text.substr(0, at)));
  const std::string value(trimmed(text.substr(at + 1)));
  if (key.empty() || value.empty()) return std::nullopt;
  if (key.find_first_not_of(kOfNames) != std::string::npos) return std::nullopt;
  const char* why = text[at] == ':' ? "a space is missing behind `:`" : "a key ends with `:`";
  return GluedKey{key, value, fmt::format("write `{}: {}`: {}", key, value, why)};
}

}  // namespace eagerx::gen

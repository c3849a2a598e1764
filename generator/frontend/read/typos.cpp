#include "generator/frontend/read/typos.hpp"

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

/// "50" for "1/0.02", "100/3" for "1/0.03".
std::optional<std::string> decimal_quotient(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  const auto above = Rational::parse(text.substr(0, slash));
  const auto below = Rational::parse(text.substr(slash + 1));
  if (!above || !below || *below == Rational()) return std::nullopt;
  const Rational quotient = *above / *below;
  return quotient.overflowed() ? std::nullopt : std::optional(quotient.to_string());
}

std::optional<ForeignNumber> foreign_number(std::string_view text) {
  const auto meant = [](std::string number, std::string_view why) {
    Help help = write_instead(number, fmt::format(": {}", why));
    return ForeignNumber{std::move(number), std::move(help)};
  };
  if (auto point = with_decimal_point(text))
    return meant(std::move(*point), "a number has a decimal point");
  if (parse_number(text)) return std::nullopt;
  if (auto quotient = decimal_quotient(text))
    return meant(std::move(*quotient), "a number is written out");
  if (text.starts_with("0x")) {
    const auto value = parse_whole(text);
    if (!value) return std::nullopt;
    return meant(std::to_string(*value), "a number is decimal");
  }
  const std::string_view before_pi =
      text.substr(0, text.size() - std::min<std::size_t>(text.size(), 2));
  if (text.ends_with("pi") && is_decimal_text(before_pi))
    return meant(fmt::format("{}*pi", before_pi), "a product has `*`");
  std::string without(text);
  if (std::erase(without, '_') > 0 && parse_number(without))
    return meant(std::move(without), "a number has no underscores");
  const std::size_t sign = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
  const std::size_t digits = std::min(text.find_first_not_of('0', sign), text.size());
  without = std::string(text.substr(0, sign)) + std::string(text.substr(digits));
  if (digits > sign && parse_number(without))
    return meant(std::move(without),
                 "a number has no leading zeros, which YAML 1.1 takes as octal");
  return std::nullopt;
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

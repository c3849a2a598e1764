#include "generator/frontend/read/quantity.hpp"

#include <fmt/format.h>

#include <array>

#include "generator/frontend/read/scalar.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

const auto& units() {
  static const std::array kUnits = {
      Unit{"Hz", Quantity::rate, 1},
      Unit{"kHz", Quantity::rate, 1'000},
      Unit{"MHz", Quantity::rate, 1'000'000},
      Unit{"mHz", Quantity::rate, {1, 1'000}},
      Unit{"s", Quantity::time, 1},
      Unit{"ms", Quantity::time, {1, 1'000}},
      Unit{"us", Quantity::time, {1, 1'000'000}},
      Unit{"ns", Quantity::time, {1, 1'000'000'000}},
      Unit{"min", Quantity::time, 60},
      Unit{"h", Quantity::time, 3'600},
      Unit{"deg", Quantity::angle, 1},
      Unit{"dB", Quantity::gain, 1},
      // U+00B5, the micro sign, and U+03BC, the Greek letter
      Unit{"\u00b5s", Quantity::time, {1, 1'000'000}},
      Unit{"\u03bcs", Quantity::time, {1, 1'000'000}},
      Unit{"%", Quantity::share, {1, 100}},
  };
  return kUnits;
}

bool is_in_unit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '%' ||
         (static_cast<unsigned char>(c) & 0x80U) != 0;
}

/// The text of a number, or a fraction if its decimals do not end.
std::optional<std::string> digits_of(const Rational& value) {
  return value.overflowed() ? std::nullopt : std::optional(value.to_string());
}

}  // namespace

NumberAndUnit take_unit_off(std::string_view text) {
  std::size_t end = text.size();
  while (end > 0 && is_in_unit(text[end - 1])) --end;
  const std::string_view unit = text.substr(end);
  while (end > 0 && !unit.empty() && text[end - 1] == ' ') --end;
  return {text.substr(0, end), unit};
}

const Unit& base_unit(Quantity quantity) {
  static const Unit kOne{"", Quantity::share, 1};
  if (quantity == Quantity::share) return kOne;
  return *ranges::find(units(), quantity, &Unit::quantity);
}

const Unit* find_unit(std::string_view name) {
  const auto* const found = ranges::find(units(), name, &Unit::name);
  return found == units().end() ? nullptr : found;
}

std::vector<std::string> units_of(Quantity quantity) {
  std::vector<std::string> names;
  for (const Unit& unit : units()) {
    const bool ascii = ranges::all_of(unit.name, [](unsigned char c) { return c < 0x80; });
    if (unit.quantity == quantity && ascii) names.emplace_back(unit.name);
  }
  return names;
}

std::optional<Rational> parse_quantity(std::string_view text, Quantity quantity) {
  const auto [number, name] = take_unit_off(text);
  const auto value = Rational::parse(number);
  if (!value || name.empty()) return value;
  const Unit* unit = find_unit(name);
  if (unit == nullptr || unit->quantity != quantity) return std::nullopt;
  const Rational scaled = *value * unit->scale;
  return scaled.overflowed() ? std::nullopt : std::optional(scaled);
}

std::optional<Rational> number_in(std::string_view text, const Unit& unit) {
  if (take_unit_off(text).unit.empty()) return std::nullopt;
  const auto value = parse_quantity(text, unit.quantity);
  if (!value) return std::nullopt;
  const Rational number = *value / unit.scale;
  return number.overflowed() ? std::nullopt : std::optional(number);
}

std::string with_right_unit(std::string_view text, Quantity wanted) {
  const auto [number, name] = take_unit_off(text);
  const auto value = Rational::parse(number);
  const Unit* unit = find_unit(name);
  const auto is_inverse = [](Quantity a, Quantity b) {
    return a == Quantity::rate && b == Quantity::time;
  };
  if (value && unit != nullptr && *value > Rational() &&
      (is_inverse(unit->quantity, wanted) || is_inverse(wanted, unit->quantity))) {
    const Rational other = Rational(1) / (*value * unit->scale);
    const auto other_text = digits_of(other);
    return other_text ? fmt::format("{} {}", *other_text, wanted == Quantity::rate ? "Hz" : "s")
                      : "";
  }
  const std::string near = nearest(name, units_of(wanted));
  return near.empty() || !value ? "" : fmt::format("{} {}", number, near);
}

}  // namespace eagerx::gen

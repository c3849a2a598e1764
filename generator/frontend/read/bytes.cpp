#include "generator/frontend/read/bytes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "generator/frontend/read/quantity.hpp"
#include "generator/frontend/read/scalar.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

constexpr std::int64_t kKilo = 1024;

/// 0 for what is none.
std::int64_t bytes_of_unit(std::string_view unit) {
  if (!ranges::contains(units_of_memory(), unit)) return 0;
  if (unit.starts_with('M')) return kKilo * kKilo;
  return unit == "B" ? 1 : kKilo;
}

bool has_no_case(std::string_view one, std::string_view other) {
  return std::ranges::equal(
      one, other, {}, [](unsigned char c) { return std::tolower(c); },
      [](unsigned char c) { return std::tolower(c); });
}

}  // namespace

const std::vector<std::string>& units_of_memory() {
  static const std::vector<std::string> kUnits = {"kB", "KiB", "MB", "MiB", "B",
                                                  "k",  "K",   "M",  "KB"};
  return kUnits;
}

std::optional<std::uint64_t> parse_bytes(std::string_view text) {
  const auto whole = parse_whole(text);  // hexadecimal digits are no unit
  const auto [number, unit] = take_unit_off(text);
  const auto value = whole ? std::optional(Rational(*whole)) : Rational::parse(number);
  const std::int64_t scale = whole || unit.empty() ? 1 : bytes_of_unit(unit);
  if (!value || scale == 0) return std::nullopt;
  const Rational bytes = *value * Rational(scale);
  if (!bytes.is_integer() || bytes < Rational()) return std::nullopt;
  return static_cast<std::uint64_t>(bytes.num());
}

std::string with_right_unit_of_memory(std::string_view text) {
  const auto [number, name] = take_unit_off(text);
  if (!Rational::parse(number)) return {};
  const auto same = [&name = name](const std::string& unit) { return has_no_case(unit, name); };
  const auto found = ranges::find_if(units_of_memory(), same);
  const std::string near =
      found != units_of_memory().end() ? *found : nearest(name, units_of_memory());
  return near.empty() ? "" : fmt::format("{} {}", number, near);
}

}  // namespace eagerx::gen

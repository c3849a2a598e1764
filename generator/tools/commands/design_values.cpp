#include "generator/tools/commands/design_values.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "generator/frontend/read/quantity.hpp"
#include "generator/frontend/read/scalar.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {

std::optional<NamedValue> split_value(const std::string& option, const std::string& text,
                                      Diagnostics& diagnostics) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
    diagnostics
        .usage_error("E0522", fmt::format("`{} {}`: a name or a value is missing", option, text))
        .help = fmt::format("write `{} PORT=VALUE`", option);
    return std::nullopt;
  }
  NamedValue result;
  result.name = trimmed(text.substr(0, equals));
  if (result.name.ends_with(']')) {
    const std::size_t bracket = result.name.rfind('[');
    const auto index =
        bracket == std::string::npos
            ? std::nullopt
            : parse_int(result.name.substr(bracket + 1, result.name.size() - bracket - 2));
    if (index && *index >= 0) {
      result.element = static_cast<std::size_t>(*index);
      result.name.resize(bracket);
    }
  }
  for (std::size_t begin = equals + 1; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    result.values.emplace_back(trimmed(std::string_view(text).substr(begin, end - begin)));
    begin = end + 1;
  }
  return result;
}

std::optional<double> positive_in(const std::string& unit, const std::string& option,
                                  const std::string& text, Diagnostics& diagnostics) {
  auto number = parse_number(text);
  if (!number) {
    const NumberAndUnit parts = take_unit_off(text);
    const auto value = parse_number(trimmed(parts.number));
    // "rad/s" ends in letters behind what is none: all that follows the number is the unit.
    const std::size_t space = text.find(' ');
    const std::string written = space == std::string::npos
                                    ? std::string(parts.unit)
                                    : std::string(trimmed(text.substr(space)));
    const auto plain = space == std::string::npos ? value : parse_number(text.substr(0, space));
    const bool is_angle = written.starts_with("deg") && unit.starts_with("rad") &&
                          written.substr(3) == unit.substr(3);
    if (plain && written == unit) number = plain;
    if (plain && is_angle) number = *plain * std::numbers::pi / 180.0;
    if (!number && plain) {
      diagnostics
          .usage_error("E0522", fmt::format("`{}` of `{}` is not in {}", text, option,
                                            unit.empty() ? "a known unit" : unit))
          .help = unit.empty() ? "write the number alone: the port has no unit in its manifest"
                               : fmt::format("write the number in {}", unit);
      return std::nullopt;
    }
  }
  if (number && std::isfinite(*number) && *number > 0.0) return number;
  diagnostics.usage_error("E0522",
                          fmt::format("`{}` of `{}` is not a positive number", text, option));
  return std::nullopt;
}

bool spread_values(const std::string& option, const NamedValue& value, const std::string& unit,
                   std::vector<std::optional<double>>& elements, Diagnostics& diagnostics) {
  const std::size_t size = elements.size();
  const std::size_t wanted = value.element ? 1 : size;
  if (value.element && *value.element >= size) {
    diagnostics.usage_error("E0522", fmt::format("`{}` of `{}` has no element {}: it has {}",
                                                 value.name, option, *value.element, size));
    return false;
  }
  if (value.values.size() != wanted) {
    diagnostics
        .usage_error("E0522", fmt::format("`{}` of `{}` has {}, not {}", value.name, option,
                                          counted(size, "element"), value.values.size()))
        .help = fmt::format("write a value for each, or for one of them `{}[0]=VALUE`", value.name);
    return false;
  }
  for (std::size_t i = 0; i < wanted; ++i) {
    const auto number = positive_in(unit, option, value.values[i], diagnostics);
    if (!number) return false;
    elements[value.element.value_or(i)] = *number;
  }
  return true;
}

}  // namespace eagerx::gen

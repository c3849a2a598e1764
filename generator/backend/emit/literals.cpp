#include "generator/backend/emit/literals.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "generator/backend/emit/namer.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

/// Digits with a point, so that the literal is a floating one.
template <class T>
std::string floating_literal(T value, std::string_view type, std::string_view suffix) {
  if (std::isnan(value)) return fmt::format("std::numeric_limits<{}>::quiet_NaN()", type);
  if (std::isinf(value))
    return fmt::format("{}std::numeric_limits<{}>::infinity()", value < 0 ? "-" : "", type);
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text + std::string(suffix);
}

std::string integer_literal(double value, Dtype dtype) {
  const std::string_view type = element_type(dtype);
  if (value <= lowest_of(dtype))
    return dtype == Dtype::boolean ? "false"
                                   : fmt::format("std::numeric_limits<{}>::lowest()", type);
  if (value >= highest_of(dtype))
    return dtype == Dtype::boolean ? "true" : fmt::format("std::numeric_limits<{}>::max()", type);
  if (dtype == Dtype::uint64 || dtype == Dtype::uint32) return fmt::format("{:.0f}U", value);
  return fmt::format("{:.0f}", value);
}

}  // namespace

std::string double_literal(double value) {
  return floating_literal(value, "double", "");
}

std::string float_literal(float value) {
  return floating_literal(value, "float", "F");
}

std::string int_type(std::int64_t value) {
  const bool small = value >= std::numeric_limits<std::int32_t>::min() &&
                     value <= std::numeric_limits<std::int32_t>::max();
  return small ? "int" : "std::int64_t";
}

/// The smallest number has no literal: C++ reads a minus and a number that is too large.
std::string int_literal(std::int64_t value) {
  constexpr std::int64_t kLowest = std::numeric_limits<std::int64_t>::lowest();
  return value == kLowest ? "std::numeric_limits<std::int64_t>::lowest()"
                          : fmt::format("{}", value);
}

std::string bool_literal(bool value) {
  return value ? "true" : "false";
}

std::string literal(double value, Dtype dtype) {
  const bool is_float = dtype == Dtype::float32;
  if (!is_float && dtype != Dtype::float64) return integer_literal(value, dtype);
  // The bounds of a space without bounds.
  const auto is_end = [&](double end) {
    return is_float ? static_cast<float>(value) == static_cast<float>(end) : value == end;
  };
  if (is_end(highest_of(dtype)))
    return fmt::format("std::numeric_limits<{}>::max()", element_type(dtype));
  if (is_end(lowest_of(dtype)))
    return fmt::format("std::numeric_limits<{}>::lowest()", element_type(dtype));
  return is_float ? float_literal(static_cast<float>(value)) : double_literal(value);
}

std::string message_literal(const std::vector<double>& values, const Space& space) {
  if (space.shape.empty()) return literal(values.front(), space.dtype);
  constexpr std::uint64_t kMostWritten = 64;  // longer messages of one value are filled
  if (values.size() == 1 && space.size() > kMostWritten) {
    return fmt::format("eagerx::filled<{}>({})", message_type(space),
                       literal(values.front(), space.dtype));
  }
  std::vector<std::string> literals;
  for (std::uint64_t i = 0; i < space.size(); ++i)
    literals.push_back(literal(values[values.size() == 1 ? 0 : i], space.dtype));
  return fmt::format("{{{{{}}}}}", join(literals, ", "));
}

std::string space_literal(const Space& space) {
  const auto bounds = [](const std::vector<double>& given, double otherwise) {
    return given.empty() ? std::vector<double>{otherwise} : given;
  };
  return fmt::format("{{.low = {}, .high = {}}}",
                     message_literal(bounds(space.low, lowest_of(space.dtype)), space),
                     message_literal(bounds(space.high, highest_of(space.dtype)), space));
}

std::string joined(const std::vector<std::string>& items) {
  return fmt::format("{}", join(items, ", "));
}

std::string braced(const std::vector<std::string>& items) {
  return "{" + joined(items) + "}";
}

std::string designated(const std::vector<FieldValue>& items) {
  std::vector<std::string> texts;
  texts.reserve(items.size());
  for (const auto& item : items) texts.push_back(fmt::format(".{} = {}", item.field, item.value));
  return braced(texts);
}

}  // namespace eagerx::gen

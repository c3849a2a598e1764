#include "generator/emit/namer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

namespace eagerx::gen {
namespace {

std::string_view element_type(Dtype dtype) {
  switch (dtype) {
    case Dtype::float32:
      return "float";
    case Dtype::float64:
      return "double";
    case Dtype::boolean:
      return "bool";
    case Dtype::int8:
      return "std::int8_t";
    case Dtype::int16:
      return "std::int16_t";
    case Dtype::int32:
      return "std::int32_t";
    case Dtype::int64:
      return "std::int64_t";
    case Dtype::uint8:
      return "std::uint8_t";
    case Dtype::uint16:
      return "std::uint16_t";
    case Dtype::uint32:
      return "std::uint32_t";
    case Dtype::uint64:
      return "std::uint64_t";
  }
  return "";
}

/// Digits with a point, so that the literal is a floating one.
template <class T>
std::string floating_literal(T value, std::string_view type, std::string_view suffix) {
  if (std::isnan(value)) return fmt::format("std::numeric_limits<{}>::quiet_NaN()", type);
  if (std::isinf(value))
    return fmt::format("{}std::numeric_limits<{}>::infinity()", value < 0 ? "-" : "", type);
  if (value == std::numeric_limits<T>::max())
    return fmt::format("std::numeric_limits<{}>::max()", type);
  if (value == std::numeric_limits<T>::lowest())
    return fmt::format("std::numeric_limits<{}>::lowest()", type);
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

std::string Names::unique(const std::string& wanted) {
  const int count = ++used_[wanted];
  if (count == 1) return wanted;
  const bool member = wanted.ends_with('_');
  return unique(fmt::format("{}_{}{}", member ? wanted.substr(0, wanted.size() - 1) : wanted, count,
                            member ? "_" : ""));
}

std::string Names::unique_with(const std::string& wanted, const std::string& suffix) {
  for (;;) {
    std::string name = unique(wanted);
    if (used_.contains(name + suffix)) continue;
    unique(name + suffix);
    return name;
  }
}

std::string camel(std::string_view name) {
  std::string result;
  bool up = true;
  for (const char c : name) {
    if (c == '_' || c == '/' || c == '.') {
      up = true;
      continue;
    }
    result += up ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    up = false;
  }
  return result;
}

std::string snake(std::string_view name) {
  std::string result(name);
  std::replace(result.begin(), result.end(), '/', '_');
  return result;
}

std::string rate_suffix(const Rational& rate_hz) {
  std::string text = rate_hz.to_string();
  std::string result;
  for (const char c : text) result += c == '.' ? "p" : (c == '/' ? "over" : std::string(1, c));
  return result + "Hz";
}

std::string rate_type(const Rational& rate_hz) {
  return rate_hz.is_integer() ? fmt::format("eagerx::Rate<{}>", rate_hz.num())
                              : fmt::format("eagerx::Rate<{}, {}>", rate_hz.num(), rate_hz.den());
}

std::string message_type(const Space& space) {
  const std::string_view element = element_type(space.dtype);
  return space.shape.empty()
             ? std::string(element)
             : fmt::format("eagerx::Array<{}, {}>", element, fmt::join(space.shape, ", "));
}

std::string double_literal(double value) {
  return floating_literal(value, "double", "");
}

std::string literal(double value, Dtype dtype) {
  if (dtype == Dtype::float32) return floating_literal(static_cast<float>(value), "float", "F");
  if (dtype == Dtype::float64) return double_literal(value);
  return integer_literal(value, dtype);
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
  return fmt::format("{{{{{}}}}}", fmt::join(literals, ", "));
}

std::string space_literal(const Space& space) {
  const auto bounds = [](const std::vector<double>& given, double otherwise) {
    return given.empty() ? std::vector<double>{otherwise} : given;
  };
  return fmt::format("{{.low = {}, .high = {}}}",
                     message_literal(bounds(space.low, lowest_of(space.dtype)), space),
                     message_literal(bounds(space.high, highest_of(space.dtype)), space));
}

std::string string_literal(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (byte < 0x20U || byte == 0x7fU) {
      result += fmt::format("\\{:03o}", byte);
    } else {
      result += c;
    }
  }
  return result + '"';
}

}  // namespace eagerx::gen

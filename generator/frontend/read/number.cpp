#include "generator/frontend/read/number.hpp"

#include <fmt/format.h>

#include <cmath>

#include "generator/frontend/read/scalar.hpp"

namespace eagerx::gen {
namespace {

struct ToText {
  std::string operator()(std::int64_t whole) const { return fmt::format("{}", whole); }
  std::string operator()(double real) const { return fmt::format("{}", real); }
  std::string operator()(const Rational& exact) const { return exact.to_string(); }
};

struct ToWhole {
  std::optional<std::int64_t> operator()(std::int64_t whole) const { return whole; }
  std::optional<std::int64_t> operator()(const Rational& exact) const {
    return exact.is_integer() ? std::optional(exact.num()) : std::nullopt;
  }
  std::optional<std::int64_t> operator()(double real) const {
    constexpr double kMost = 1e16;  // larger ones are rounded: no number of anything
    const bool whole = std::trunc(real) == real && std::abs(real) < kMost;
    return whole ? std::optional(static_cast<std::int64_t>(real)) : std::nullopt;
  }
};

struct ToReal {
  double operator()(std::int64_t whole) const { return static_cast<double>(whole); }
  double operator()(double real) const { return real; }
  double operator()(const Rational& exact) const { return exact.to_double(); }
};

struct ToExact {
  std::optional<Rational> operator()(std::int64_t whole) const { return whole; }
  std::optional<Rational> operator()(const Rational& exact) const { return exact; }
  std::optional<Rational> operator()(double real) const { return Rational::of_decimal(real); }
};

}  // namespace

std::string to_string(const ComputedNumber& number) {
  return std::visit(ToText{}, number);
}

YamlValue made_number(const ComputedNumber& number, Span span) {
  YamlValue yaml = made_scalar(to_string(number), span);
  yaml.number = number;
  return yaml;
}

std::optional<std::int64_t> whole_of(const YamlValue& yaml) {
  return yaml.number ? std::visit(ToWhole{}, *yaml.number) : parse_int(yaml.text);
}

std::optional<double> real_of(const YamlValue& yaml) {
  return yaml.number ? std::optional(std::visit(ToReal{}, *yaml.number)) : parse_number(yaml.text);
}

std::optional<Rational> exact_of(const YamlValue& yaml) {
  return yaml.number ? std::visit(ToExact{}, *yaml.number) : Rational::parse(yaml.text);
}

}  // namespace eagerx::gen

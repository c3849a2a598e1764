// Values of `$(…)`.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "generator/frontend/library/condition.hpp"
#include "generator/frontend/parameters/config.hpp"
#include "generator/frontend/read/number.hpp"
#include "generator/frontend/read/quantity.hpp"
#include "generator/frontend/read/scalar.hpp"
#include "generator/frontend/spec/named.hpp"

namespace eagerx::gen {
namespace {

/// Whether `config P 0` or `size P` is of a parameter that the graph does not give.
bool is_missing(const Reference& reference, const References& references) {
  const auto parameter = references.find(parameter_reference(reference.name));
  return parameter != references.end() && is_unresolved(parameter->second);
}

/// Of a whole number: whether E0322 or E0323 tells of it, where the parameter is read.
bool is_refused(const Parameter& parameter, const YamlValue& value) {
  if (parameter.type != Parameter::Type::integer || is_expression(value)) return false;
  if (!value.is_scalar() || value.quoted) return true;
  const auto whole = value.number ? whole_of(value) : parse_whole(value.text);
  if (!whole) return true;
  return (parameter.low && !at_most(*parameter.low, *whole)) ||
         (parameter.high && !at_most(*whole, *parameter.high));
}

/// A value as expressions calculate with it; nullopt if it is not known.
std::optional<ConditionValue> fact_of(const YamlValue& yaml) {
  if (is_unresolved(yaml)) return std::nullopt;
  const auto number = [](const YamlValue& item) -> std::optional<ConditionNumber> {
    if (!item.is_scalar() || item.quoted) return std::nullopt;
    if (const auto exact = exact_of(item)) {
      if (exact->is_integer()) return exact->num();
      return *exact;
    }
    const auto real = real_of(item);
    return real ? std::optional<ConditionNumber>(*real) : std::nullopt;
  };
  if (yaml.is_sequence()) {
    std::vector<ConditionNumber> list;
    for (const auto& item : yaml.items)
      list.push_back(number(item).value_or(std::numeric_limits<double>::quiet_NaN()));
    return list;
  }
  if (const auto one = number(yaml))
    return std::visit([](const auto& value) { return ConditionValue(value); }, *one);
  if (const auto truth = parse_bool(yaml.text)) return *truth;
  return yaml.text;
}

std::optional<ComputedNumber> finite_number(const ConditionValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return *whole;
  if (const auto* exact = std::get_if<Rational>(&value))
    return exact->overflowed() ? std::nullopt : std::optional<ComputedNumber>(*exact);
  const auto* real = std::get_if<double>(&value);
  return real != nullptr && std::isfinite(*real) ? std::optional<ComputedNumber>(*real)
                                                 : std::nullopt;
}

/// `2 * $(config limit)`; marked as unresolved where something in it is not known.
YamlValue compute(YamlValue yaml, const References& references, Diagnostics& diagnostics) {
  KnownReferences known;
  Facts facts;
  for (const auto& [reference, value] : references) {
    const std::string name = to_string(reference);
    const auto fact = known[name] = fact_of(value);
    if (fact) facts[name] = *fact;
  }
  const auto expression = read_expression(yaml, known, diagnostics);
  yaml.origin = Origin::unresolved;
  const auto value = expression ? evaluate(*expression, facts) : std::nullopt;
  if (!value) return yaml;
  yaml.number = finite_number(*value);
  if (!yaml.number) {
    diagnostics.error("E0324", yaml.span, fmt::format("`{}` is not a finite number", yaml.text));
    return yaml;
  }
  yaml.origin = Origin::written;
  yaml.text = to_string(*yaml.number);
  return yaml;
}

}  // namespace

bool is_unresolved(const YamlValue& yaml) {
  return yaml.origin == Origin::unresolved;
}

YamlValue in_unit_of(const Parameter& parameter, YamlValue yaml) {
  for (auto& item : yaml.items) item = in_unit_of(parameter, std::move(item));
  const bool text =
      parameter.type == Parameter::Type::text || parameter.type == Parameter::Type::keyword;
  const Unit* unit = find_unit(parameter.unit);
  if (unit == nullptr || text || !yaml.is_scalar() || yaml.quoted || yaml.number) return yaml;
  const auto number = number_in(yaml.text, *unit);
  if (!number) return yaml;
  YamlValue made = made_number(*number, yaml.span);
  return made.text.find('/') == std::string::npos ? made : yaml;  // parameters take no fractions
}

References references_of(const Entity& entity, const std::vector<Setting>& settings) {
  References result;
  for (const auto& parameter : entity.config) {
    const Setting* setting = find_named(settings, parameter.name.value);
    if (setting == nullptr && !parameter.fallback) {
      // Said where it is missing; what refers to it says nothing.
      result[parameter_reference(parameter.name.value)].origin = Origin::unresolved;
      continue;
    }
    const YamlValue value =
        in_unit_of(parameter, setting != nullptr ? setting->value : *parameter.fallback);
    YamlValue& known = result[parameter_reference(parameter.name.value)] = value;
    if (is_refused(parameter, value)) known.origin = Origin::unresolved;
    if (parameter.type != Parameter::Type::integers && parameter.type != Parameter::Type::numbers)
      continue;
    // A single number is a list of one.
    const std::size_t size = value.is_sequence() ? value.items.size() : 1;
    result[{"size", parameter.name.value}] =
        made_number(static_cast<std::int64_t>(size), value.span);
    for (std::size_t i = 0; i < value.items.size(); ++i)
      result[{"config", parameter.name.value, std::to_string(i)}] = value.items[i];
  }
  return result;
}

YamlValue substitute(YamlValue yaml, const References& references, Diagnostics& diagnostics) {
  for (auto& item : yaml.items) item = substitute(std::move(item), references, diagnostics);
  for (auto& entry : yaml.entries)
    entry.value = substitute(std::move(entry.value), references, diagnostics);
  if (!is_expression(yaml)) return yaml;
  const auto reference = reference_in(yaml);
  if (!reference) return compute(std::move(yaml), references, diagnostics);
  const auto found = references.find(*reference);
  if (found != references.end()) return found->second;
  if (is_missing(*reference, references)) {
    yaml.origin = Origin::unresolved;
    return yaml;
  }
  return compute(std::move(yaml), references, diagnostics);
}

std::vector<Setting> substitute(std::vector<Setting> settings, const References& references,
                                Diagnostics& diagnostics) {
  for (auto& setting : settings)
    setting.value = substitute(std::move(setting.value), references, diagnostics);
  return settings;
}

}  // namespace eagerx::gen

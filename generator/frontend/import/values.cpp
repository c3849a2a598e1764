// Rates, delays and spaces as they are saved.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "generator/frontend/import/translate.hpp"
#include "generator/frontend/read/scalar.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// The simplest fraction that rounds to `value`, if it is simple. By Legendre's theorem it is a
/// convergent of the continued fraction, and convergents come in the order of their denominators.
std::optional<Rational> simplest_fraction(double value) {
  constexpr double kLargestDenominator = 1e6, kLargest = 1e9;
  if (!(value > 0.0 && value < kLargest)) return std::nullopt;
  double p = 1.0, q = 0.0, p_before = 0.0, q_before = 1.0, rest = value;
  for (;;) {
    const double whole = std::floor(rest);
    p_before = std::exchange(p, whole * p + p_before);
    q_before = std::exchange(q, whole * q + q_before);
    if (q > kLargestDenominator) return std::nullopt;
    if (p / q == value) return Rational(static_cast<std::int64_t>(p), static_cast<std::int64_t>(q));
    if (rest == whole) return std::nullopt;
    rest = 1.0 / (rest - whole);
  }
}

/// The number that EAGERx meant: it wrote a double, and so 0.06666666666666667 for 2/30. A number
/// that is no simple fraction is exact where its decimals fit, else rounded to the twelve digits
/// that EAGERx itself keeps of a time.
std::optional<Rational> meant(const YamlValue& yaml) {
  if (!yaml.is_scalar() || yaml.quoted) return std::nullopt;
  const auto number = parse_number(yaml.text);
  if (number) {
    if (const auto fraction = simplest_fraction(*number)) return fraction;
  }
  if (const auto exact = Rational::parse(yaml.text)) return exact;
  return number && std::isfinite(*number) ? Rational::parse(fmt::format("{:.12g}", *number))
                                          : std::nullopt;
}

std::optional<Rational> checked(const YamlValue& yaml, const char* what, bool zero,
                                Diagnostics& diagnostics) {
  const auto value = meant(yaml);
  if (value && !value->overflowed() && (*value > Rational() || (zero && *value == Rational())))
    return value;
  const bool object = is_python_object(yaml);
  diagnostics.error(object ? "E0803" : "E0802", yaml.span,
                    object
                        ? fmt::format("expected {}, found a Python object, `{}`", what, yaml.text)
                        : fmt::format("expected {}, found {}", what, describe(yaml)));
  return std::nullopt;
}

/// numpy's nan_to_num writes the largest numbers for infinity.
bool is_unbounded(double bound, std::string_view dtype) {
  const double magnitude = std::fabs(bound);
  constexpr double kLargestInteger = 9.2233720368547758e18;
  if (!(magnitude < std::numeric_limits<double>::max())) return true;
  if (dtype.find("int") != std::string_view::npos) return magnitude >= kLargestInteger;
  return dtype == "float32" && magnitude >= static_cast<double>(std::numeric_limits<float>::max());
}

bool all_unbounded(const YamlValue& bound, std::string_view dtype) {
  if (bound.is_sequence()) {
    return ranges::all_of(bound.items,
                          [&](const YamlValue& item) { return all_unbounded(item, dtype); });
  }
  const auto number = parse_number(bound.text);
  return number && is_unbounded(*number, dtype);
}

/// Nested lists (of matrices) in one, row by row; infinite where there is no bound.
void flatten(const YamlValue& bound, std::string_view dtype, std::vector<YamlValue>& into) {
  for (const auto& item : bound.items) flatten(item, dtype, into);
  if (bound.is_sequence()) return;
  YamlValue number = bound;
  const auto value = parse_number(bound.text);
  if (value && dtype.starts_with("float") && is_unbounded(*value, dtype))
    number.text = *value < 0 ? "-.inf" : ".inf";
  into.push_back(std::move(number));
}

std::optional<YamlValue> bound_of(const SavedPort& port, const YamlValue* space, const char* key,
                                  std::string_view dtype) {
  const YamlValue* bound = space->find(key);
  if (bound == nullptr || bound->is_null() || bound->is_map() || is_python_object(*bound) ||
      dtype == "bool" || all_unbounded(*bound, dtype))
    return std::nullopt;
  if (bound->is_scalar()) return *bound;
  YamlValue list = *bound;
  list.items.clear();
  flatten(*bound, dtype, list.items);
  for (auto& item : list.items) item.span = item.span.line == 0 ? port.name.span : item.span;
  return list;
}

bool same_shape(const YamlValue& a, const YamlValue& b) {
  return a.is_sequence() && b.is_sequence() && a.items.size() == b.items.size() &&
         std::equal(a.items.begin(), a.items.end(), b.items.begin(),
                    [](const YamlValue& x, const YamlValue& y) { return x.text == y.text; });
}

/// float32 bounds are saved with all the digits of the float: -3.140000104904175 is -3.14.
bool same_bound(const std::optional<YamlValue>& a, const std::optional<YamlValue>& b, bool single) {
  if (!a || !b) return a.has_value() == b.has_value();
  const auto count = [](const YamlValue& n) { return n.is_sequence() ? n.items.size() : 1; };
  const auto at = [](const YamlValue& n, std::size_t i) -> const YamlValue& {
    return n.is_sequence() ? n.items[n.items.size() == 1 ? 0 : i] : n;
  };
  if (count(*a) != count(*b) && count(*a) != 1 && count(*b) != 1) return false;
  for (std::size_t i = 0; i < std::max(count(*a), count(*b)); ++i) {
    if (count(*a) == 0 || count(*b) == 0) return false;
    const auto x = parse_number(at(*a, i).text), y = parse_number(at(*b, i).text);
    if (!x || !y) return false;
    if (*x != *y && !(single && static_cast<float>(*x) == static_cast<float>(*y))) return false;
  }
  return true;
}

}  // namespace

std::optional<Rational> saved_rate(const YamlValue& yaml, Diagnostics& diagnostics) {
  return checked(yaml, "a rate in Hz", false, diagnostics);
}

std::optional<Rational> saved_delay(const YamlValue& yaml, Diagnostics& diagnostics) {
  return checked(yaml, "a delay in seconds", true, diagnostics);
}

std::optional<Rational> meant_number(const YamlValue& yaml) {
  return meant(yaml);
}

std::optional<Rational> manifest_rate(const Entity& entity, const PortManifest& port,
                                      const std::vector<Setting>& settings) {
  if (!port.rate) return std::nullopt;
  if (const Rational* number = port.rate->number()) return *number;
  const auto reference = reference_in(*port.rate);
  if (!reference || reference->what != "config") return std::nullopt;
  if (const Setting* setting = find_named(settings, reference->name))
    return meant_number(setting->value);
  const Parameter* parameter = find_named(entity.config, reference->name);
  return parameter != nullptr && parameter->fallback ? Rational::parse(parameter->fallback->text)
                                                     : std::nullopt;
}

const PortManifest* manifest_port(const Entity& entity, std::string_view section,
                                  std::string_view name) {
  if (section == "inputs") return entity.input(name);
  if (section == "outputs") return entity.output(name);
  if (section == "sensors") return entity.sensor(name);
  if (section == "actuators") return entity.actuator(name);
  if (section == "feedthroughs") return entity.output(name);  // what it passes on
  if (section == "targets") return entity.reset_target(name);
  return section == "states" ? entity.state(name) : nullptr;
}

std::optional<SpaceSpec> saved_space(const SavedPort& port) {
  const YamlValue* saved = port.find("space");
  if (saved == nullptr || !saved->is_map()) return std::nullopt;
  SpaceSpec space;
  space.span = port.name.span;
  const YamlValue* dtype = saved->find("dtype");
  if (dtype != nullptr && dtype->is_scalar())
    space.dtype = Spanned<std::string>{dtype->text, dtype->span};
  const std::string_view name = space.dtype ? std::string_view(space.dtype->value) : "";
  const YamlValue* shape = saved->find("shape");
  if (shape != nullptr && shape->is_sequence()) space.shape = *shape;
  space.low = bound_of(port, saved, "low", name);
  space.high = bound_of(port, saved, "high", name);
  if (!space.dtype && !space.shape && !space.low && !space.high) return std::nullopt;
  return space;
}

bool check_space(const SpaceSpec& space, Diagnostics& diagnostics) {
  YamlValue yaml;
  yaml.kind = YamlKind::map;
  yaml.span = space.span;
  const auto add = [&](const char* key, const std::optional<YamlValue>& value) {
    if (value) yaml.entries.push_back({key, value->span, *value});
  };
  if (space.dtype) add("dtype", made_scalar(space.dtype->value, space.dtype->span));
  add("shape", space.shape);
  add("low", space.low);
  add("high", space.high);
  return check(yaml, *space_format(ReferenceRule::refuse, false), diagnostics);
}

bool same_space(const SpaceSpec& saved, const SpaceSpec& manifest) {
  const bool single = saved.dtype && saved.dtype->value == "float32";
  return saved.dtype && manifest.dtype && saved.dtype->value == manifest.dtype->value &&
         saved.shape && manifest.shape && same_shape(*saved.shape, *manifest.shape) &&
         same_bound(saved.low, manifest.low, single) &&
         same_bound(saved.high, manifest.high, single);
}

std::optional<SpaceSpec> missing_of(const SpaceSpec& saved, const SpaceSpec& manifest) {
  SpaceSpec result;
  result.span = saved.span;
  const bool dtype = manifest.dtype && saved.dtype && manifest.dtype->value == saved.dtype->value;
  if (!dtype) result.dtype = saved.dtype;
  const bool literal = manifest.shape && ranges::none_of(manifest.shape->items, is_expression);
  const bool shape =
      manifest.shape && saved.shape && (!literal || same_shape(*manifest.shape, *saved.shape));
  if (!shape) result.shape = saved.shape;
  if (!result.dtype && !result.shape) return std::nullopt;
  return result;
}

}  // namespace eagerx::gen

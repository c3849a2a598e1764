#include "generator/frontend/parameters/config.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>

#include "generator/frontend/read/number.hpp"
#include "generator/frontend/read/quantity.hpp"
#include "generator/frontend/read/scalar.hpp"
#include "generator/frontend/read/typos.hpp"
#include "generator/frontend/spec/foreign_words.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

std::string_view type_name(Parameter::Type type) {
  switch (type) {
    case Parameter::Type::integer:
      return "an integer";
    case Parameter::Type::number:
      return "a number";
    case Parameter::Type::boolean:
      return "true or false";
    case Parameter::Type::text:
      return "a text";
    case Parameter::Type::keyword:
      return "a choice";
    case Parameter::Type::integers:
      return "a list of integers";
    case Parameter::Type::numbers:
      return "a list of numbers";
    case Parameter::Type::model:
      return "an object";
  }
  return "";
}

bool in_range(const Parameter& parameter, const ConditionNumber& value, const YamlValue& yaml,
              Diagnostics& diagnostics) {
  const bool low = parameter.low && !at_most(*parameter.low, value);
  const bool high = parameter.high && !at_most(value, *parameter.high);
  if (!low && !high) return true;
  diagnostics.error("E0323", yaml.span, fmt::format("`{}` is out of range", parameter.name.value))
      .label = low ? fmt::format("must be at least {}", to_string(*parameter.low))
                   : fmt::format("must be at most {}", to_string(*parameter.high));
  return false;
}

/// Of a list its items, of another value itself.
std::vector<YamlValue> items_of(const YamlValue& yaml) {
  return yaml.is_sequence() ? yaml.items : std::vector<YamlValue>{yaml};
}

/// Also a hexadecimal one.
std::optional<std::int64_t> any_whole_of(const YamlValue& yaml) {
  return yaml.number ? whole_of(yaml) : parse_whole(yaml.text);
}

/// Texts that are no numbers are no values of parameters either.
std::optional<double> number_of(const YamlValue& yaml) {
  const auto number = real_of(yaml);
  return number && std::isnan(*number) ? std::nullopt : number;
}

class Reader {
 public:
  Reader(const Library& library, const Parameter& parameter, const YamlValue& yaml,
         Diagnostics& diagnostics)
      : library_(library), parameter_(parameter), yaml_(yaml), diagnostics_(diagnostics) {}

  std::optional<ConfigValue> read() {
    switch (parameter_.type) {
      case Parameter::Type::integer:
        return one<std::int64_t>(any_whole_of);
      case Parameter::Type::number:
        return one<double>(number_of);
      case Parameter::Type::boolean:
        return one<bool>([](const YamlValue& n) { return parse_bool(n.text); });
      case Parameter::Type::text:
        return yaml_.is_scalar() ? value(yaml_.text) : wrong(yaml_);
      case Parameter::Type::keyword:
        return keyword();
      case Parameter::Type::integers:
        return list<std::int64_t>(any_whole_of);
      case Parameter::Type::numbers:
        return list<double>(number_of);
      case Parameter::Type::model: {
        if (is_unresolved(yaml_)) return std::nullopt;
        auto model = read_model(library_, parameter_, yaml_, diagnostics_);
        return model ? value(std::move(model)) : std::nullopt;
      }
    }
    return std::nullopt;
  }

 private:
  /// The correct form of `thirty` or `yes`.
  [[nodiscard]] Help help_with_word(const YamlValue& yaml) const {
    using Type = Parameter::Type;
    if (!yaml.is_scalar() || yaml.is_null() || yaml.quoted) return {};
    const Type type = parameter_.type;
    if (type == Type::boolean) {
      const std::string truth(foreign_truth(yaml.text));
      return truth.empty() ? Help() : write_instead(truth);
    }
    if (type == Type::integer || type == Type::integers)
      return parse_number(yaml.text) ? "" : "write it in digits, such as `30`";
    if (type == Type::number || type == Type::numbers)
      return parse_number(yaml.text) ? "" : "write it in digits, such as `30` or `1.5`";
    return {};
  }

  /// The correct form of a number in another language's notation, or with a unit.
  [[nodiscard]] Help help_with_number(const YamlValue& yaml) const {
    if (const auto foreign = yaml.is_scalar() ? foreign_number(yaml.text) : std::nullopt)
      return foreign->help;
    const Unit* unit = find_unit(parameter_.unit);
    if (unit == nullptr || !yaml.is_scalar()) return help_with_word(yaml);
    const NumberAndUnit parts = take_unit_off(yaml.text);
    if (parts.number.empty() || parts.unit.empty()) return help_with_word(yaml);
    const std::string right = with_right_unit(yaml.text, unit->quantity);
    return right.empty() ? Help(fmt::format("its unit is {}", unit->name)) : write_instead(right);
  }

  template <class T>
  std::optional<ConfigValue> value(T t) {
    return ConfigValue{&parameter_, std::move(t)};
  }

  std::optional<ConfigValue> wrong(const YamlValue& yaml) {
    if (is_unresolved(yaml)) return std::nullopt;
    diagnostics_
        .error("E0322", yaml.span,
               fmt::format("`{}` must be {}, found {}", parameter_.name.value,
                           type_name(parameter_.type), describe(yaml)))
        .help = help_with_number(yaml);
    return std::nullopt;
  }

  template <class T, class Parse>
  std::optional<T> parse_item(const YamlValue& yaml, Parse&& parse) {
    const auto parsed = yaml.is_scalar() && !yaml.quoted ? parse(yaml) : std::nullopt;
    if (!parsed) {
      wrong(yaml);
      return std::nullopt;
    }
    if constexpr (!std::is_same_v<T, bool>) {
      if (!in_range(parameter_, *parsed, yaml, diagnostics_)) return std::nullopt;
    }
    return *parsed;
  }

  template <class T, class Parse>
  std::optional<ConfigValue> one(Parse&& parse) {
    const auto item = parse_item<T>(yaml_, parse);
    return item ? value(*item) : std::nullopt;
  }

  template <class T, class Parse>
  std::optional<ConfigValue> list(Parse&& parse) {
    std::vector<T> result;
    // A single number is a list of one: `cutoff_hz: 10`.
    if (yaml_.is_map() || yaml_.is_null()) return wrong(yaml_);
    for (const auto& item : items_of(yaml_)) {
      const auto parsed = parse_item<T>(item, parse);
      if (!parsed) return std::nullopt;
      result.push_back(*parsed);
    }
    return value(std::move(result));
  }

  std::optional<ConfigValue> keyword() {
    if (is_unresolved(yaml_)) return std::nullopt;
    const auto& options = parameter_.options;
    if (yaml_.is_scalar() && contains(options, yaml_.text)) return value(yaml_.text);
    auto& problem = diagnostics_.error(
        "E0322", yaml_.span,
        fmt::format("{} is not a choice for `{}`", describe(yaml_), parameter_.name.value));
    problem.help = did_you_mean(yaml_.is_scalar() ? yaml_.text : "", options,
                                fmt::format("choose one of {}", join(options, ", ")));
    return std::nullopt;
  }

  const Library& library_;
  const Parameter& parameter_;
  const YamlValue& yaml_;
  Diagnostics& diagnostics_;
};

/// Reports parameters that do not exist; returns those that were meant.
std::vector<std::string> report_unknown_parameters(const Entity& entity,
                                                   const std::vector<Setting>& settings,
                                                   Diagnostics& diagnostics) {
  std::vector<std::string> meant;
  const std::vector<std::string> known = names_of(entity.config);
  for (const auto& setting : settings) {
    if (contains(known, setting.name)) continue;
    auto& problem =
        diagnostics.error("E0320", setting.span,
                          fmt::format("`{}` has no parameter `{}`", entity.id.value, setting.name));
    const std::string near = nearest(setting.name, known);
    if (!near.empty()) {
      problem.help = meaning(near);
    } else if (known.empty()) {
      problem.help = fmt::format("`{}` has no parameters", entity.id.value);
    } else {
      problem.help = fmt::format("`{}` has {}", entity.id.value, join(known, ", "));
    }
    meant.push_back(near);
  }
  return meant;
}

/// Whether a whole number of the dtype survives as a double. The largest of a dtype does, as the
/// double behind it stands for it.
bool is_exact_as_double(std::string_view text, std::optional<Dtype> dtype) {
  if (text.starts_with('+') || text.starts_with('-')) text.remove_prefix(1);
  std::uint64_t magnitude = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), magnitude);
  if (error != std::errc() || end != text.data() + text.size()) return true;  // reported elsewhere
  constexpr auto kInt64 = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  constexpr auto kUint64 = std::numeric_limits<std::uint64_t>::max();
  if (magnitude == kInt64 && dtype != Dtype::uint64) return true;
  if (magnitude == kUint64 && dtype != Dtype::int64) return true;
  return magnitude == 0 ||
         static_cast<int>(std::bit_width(magnitude)) - std::countr_zero(magnitude) <=
             std::numeric_limits<double>::digits;
}

}  // namespace

Config resolve_config(const Library& library, const Entity& entity,
                      const std::vector<Setting>& settings, Span span, Diagnostics& diagnostics,
                      const References& outside) {
  const std::vector<std::string> meant = report_unknown_parameters(entity, settings, diagnostics);
  Config result;
  for (const auto& parameter : entity.config) {
    const Setting* setting = find_named(settings, parameter.name.value);
    const YamlValue* yaml = setting != nullptr
                                ? &setting->value
                                : (parameter.fallback ? &*parameter.fallback : nullptr);
    if (yaml == nullptr && contains(meant, parameter.name.value)) continue;
    if (yaml == nullptr) {
      diagnostics
          .error(
              "E0321", span,
              fmt::format("`{}` needs the parameter `{}`", entity.id.value, parameter.name.value))
          .help = {
          fmt::format("add `config: {{{}: …}}`: {}{}", parameter.name.value, parameter.about,
                      parameter.unit.empty() ? "" : fmt::format(" ({})", parameter.unit)),
          add_parameter(parameter.name.value)};
      continue;
    }
    const YamlValue read =
        in_unit_of(parameter, setting != nullptr ? *yaml : substitute(*yaml, outside, diagnostics));
    auto value = Reader(library, parameter, read, diagnostics).read();
    if (!value) continue;
    value->given = setting != nullptr;
    value->span = setting != nullptr ? setting->value.span : span;
    result.push_back(std::move(*value));
  }
  return result;
}

namespace {

/// Whether it was refused before, as the value of a parameter.
bool is_reported(const Span& span, const Diagnostics& diagnostics) {
  return ranges::any_of(diagnostics.all(), [&](const Diagnostic& each) {
    return each.code == "E0322" && each.span.file == span.file && each.span.line == span.line &&
           each.span.column == span.column;
  });
}

}  // namespace

YamlValue value_of(const QuantitySpec& quantity, const References& references,
                   Diagnostics& diagnostics) {
  if (const Rational* number = quantity.number()) return made_number(*number, quantity.span);
  return substitute(*quantity.expression(), references, diagnostics);
}

std::optional<std::vector<double>> numbers_of(const YamlValue& yaml, Diagnostics& diagnostics) {
  std::vector<double> result;
  for (const auto& item : items_of(yaml)) {
    const auto number = item.is_scalar() && !item.quoted ? real_of(item) : std::nullopt;
    if (!number && is_unresolved(item)) return std::nullopt;
    if (!number) {
      if (!is_reported(item.span, diagnostics))
        diagnostics.error("E0322", item.span,
                          fmt::format("expected a number, found {}", describe(item)));
      return std::nullopt;
    }
    result.push_back(*number);
  }
  return result;
}

bool are_exact_as_doubles(const YamlValue& yaml, std::optional<Dtype> dtype, const char* code,
                          Diagnostics& diagnostics) {
  if (dtype && is_floating(*dtype)) return true;
  for (const auto& item : items_of(yaml)) {
    if (!item.is_scalar() || is_exact_as_double(item.text, dtype)) continue;
    diagnostics.error(code, item.span, fmt::format("`{}` cannot be kept exactly", item.text)).help =
        "whole numbers beyond 9007199254740992 (two to the 53rd) are rounded: choose one with "
        "fewer digits, or the largest or smallest of the dtype";
    return false;
  }
  return true;
}

std::optional<Rational> rate_of(const QuantitySpec& rate, const References& references,
                                Diagnostics& diagnostics) {
  const YamlValue found = value_of(rate, references, diagnostics);
  const auto rate_hz = exact_of(found);
  if (rate_hz && *rate_hz > Rational()) return rate_hz;
  if (is_unresolved(found)) return std::nullopt;
  diagnostics.error("E0204", found.span,
                    fmt::format("expected a rate in Hz, found {}", describe(found)));
  return std::nullopt;
}

}  // namespace eagerx::gen

// A tree against its table, with every problem in plain words.
#include <fmt/format.h>

#include <algorithm>

#include "generator/quote/quote.hpp"
#include "generator/read/bytes.hpp"
#include "generator/read/rational.hpp"
#include "generator/read/scalar.hpp"
#include "generator/read/slips.hpp"
#include "generator/spec/format.hpp"
#include "generator/spec/named.hpp"
#include "generator/spec/slips.hpp"

namespace eagerx::gen {
namespace {

bool wrong_type(const YamlValue& yaml, const Format& format, Diagnostics& diagnostics) {
  const bool mapping = format.kind == Format::Kind::record || format.kind == Format::Kind::map;
  auto& problem =
      diagnostics.error("E0203", yaml.span,
                        fmt::format("expected {}{}, found {}", mapping ? "a mapping for " : "",
                                    format.what, describe(yaml)));
  const bool number = format.kind == Format::Kind::integer ||
                      format.kind == Format::Kind::decimal || format.kind == Format::Kind::number ||
                      format.kind == Format::Kind::boolean || format.kind == Format::Kind::memory;
  if (number && yaml.is_scalar() && yaml.quoted)
    problem.help = "quotes make it a text: leave them out";
  if (!yaml.is_scalar() || yaml.quoted) return false;
  if (const auto point = with_decimal_point(yaml.text)) {
    problem.help = fmt::format("write `{}`: a number has a decimal point", *point);
  } else if (const auto glued = mapping ? glued_key(yaml.text) : std::nullopt) {
    problem.help = glued->help;
  }
  return false;
}

void report_bad_name(std::string_view text, Span span, Diagnostics& diagnostics) {
  if (is_reserved_name(text)) {
    diagnostics
        .error("E0205", span,
               fmt::format("`{}` is a word of C++ or of generated code and cannot be a name", text))
        .help = "names become C++ identifiers: choose another one";
    return;
  }
  if (text.size() > kLongestName) {
    diagnostics.error("E0205", span, fmt::format("`{}` is too long for a name", shortened(text)))
        .help = fmt::format("names have at most {} letters", kLongestName);
    return;
  }
  // `{far: max(theta, 1)}`: YAML ends a value at its comma.
  const bool is_rest = text.find(')') < text.find('(');
  const auto glued = glued_key(text);
  diagnostics.error("E0205", span, fmt::format("`{}` is not a name", text)).help =
      glued     ? glued->help
      : is_rest ? "an expression with a comma needs quotes within `{…}`"
                : "use letters, digits and single underscores, beginning with a letter";
}

bool in_range(const YamlValue& yaml, const Format& format, double value, Diagnostics& diagnostics) {
  const bool low =
      format.low && (value < *format.low || (format.low_exclusive && value <= *format.low));
  const bool high = format.high && value > *format.high;
  if (!low && !high) return true;
  auto& problem = diagnostics.error(
      "E0204", yaml.span, fmt::format("expected {}, found {}", format.what, describe(yaml)));
  if (low)
    problem.label = fmt::format("must be {} {}", format.low_exclusive ? "greater than" : "at least",
                                *format.low);
  if (high) problem.label = fmt::format("must be at most {}", *format.high);
  return false;
}

bool check_scalar_name(const YamlValue& yaml, const Format& format, Diagnostics& diagnostics) {
  if (!yaml.is_scalar()) return wrong_type(yaml, format, diagnostics);
  return check_name(yaml.text, yaml.span, diagnostics);
}

bool check_port(const YamlValue& yaml, const Format& format, Diagnostics& diagnostics) {
  if (!yaml.is_scalar()) return wrong_type(yaml, format, diagnostics);
  std::size_t parts = 0;
  bool good = true;
  for (std::size_t begin = 0; begin <= yaml.text.size(); ++parts) {
    const std::size_t end = std::min(yaml.text.find('.', begin), yaml.text.size());
    const std::string_view part = std::string_view(yaml.text).substr(begin, end - begin);
    if (is_reserved_name(part) || part.size() > kLongestName) {
      report_bad_name(part, yaml.span, diagnostics);
      return false;
    }
    const std::size_t element = part.ends_with(']') ? part.rfind('[') : part.size();
    good = good && is_inner_name(part.substr(0, element));
    begin = end + 1;
  }
  if (good && parts >= 2 && parts <= 3) return true;
  diagnostics.error("E0205", yaml.span, fmt::format("{} is not a port", describe(yaml))).help =
      fmt::format("write {}", format.what);
  return false;
}

/// Names of files and ids of targets go into paths, into CMake and into C++.
bool check_path(const YamlValue& yaml, const Format& format, Diagnostics& diagnostics) {
  if (!yaml.is_scalar()) return wrong_type(yaml, format, diagnostics);
  std::string_view rest = yaml.text;
  while (format.leaves && rest.starts_with("../")) rest.remove_prefix(3);
  const bool good = (format.one_name ? is_plain_file_name(rest) : is_plain_path(rest)) &&
                    rest.size() <= kLongestPath;
  if (good) return true;
  auto& problem = diagnostics.error("E0205", yaml.span,
                                    fmt::format("{} cannot be {}", describe(yaml), format.what));
  problem.help = format.one_name ? "use letters, digits, `-`, `_`, `+` and `.`, no `-` first"
                                 : "use names of letters, digits, `-`, `_`, `+` and `.`, no `-` "
                                   "first, with `/` between them";
  return false;
}

/// `otherwise`: what may be written instead of a keyword.
bool check_keyword(const YamlValue& yaml, const Format& format, const std::string& otherwise,
                   Diagnostics& diagnostics) {
  if (!yaml.is_scalar()) return wrong_type(yaml, format, diagnostics);
  if (contains(format.keywords, yaml.text)) return true;
  auto& problem =
      diagnostics.error("E0204", yaml.span, fmt::format("{} is not a choice here", describe(yaml)));
  problem.help = did_you_mean(yaml.text, format.keywords,
                              otherwise.empty() ? fmt::format("choose one of {}", format.what)
                                                : fmt::format("write {}", otherwise));
  return false;
}

std::string with_article(Quantity quantity) {
  return quantity == Quantity::rate ? "a rate" : "a time";
}

/// Whether a number has no unit, or one of its format; a text without a number is left to others.
bool check_unit(const YamlValue& yaml, const Format& format, Diagnostics& diagnostics) {
  const auto [number, name] = take_unit_off(yaml.text);
  if (name.empty() || !Rational::parse(number)) return true;
  const Unit* unit = find_unit(name);
  if (unit != nullptr && unit->quantity == format.quantity) return true;
  const std::string wanted = with_article(format.quantity);
  auto& problem = diagnostics.error(
      "E0209", yaml.span,
      unit != nullptr ? fmt::format("expected {}, found {}, which is {}", format.what,
                                    describe(yaml), with_article(unit->quantity))
                      : fmt::format("`{}` is not a unit of {}", shortened(name), wanted));
  const std::string right = with_right_unit(yaml.text, format.quantity);
  problem.help = right.empty() ? fmt::format("units of {} are {}", wanted,
                                             fmt::join(units_of(format.quantity), ", "))
                               : fmt::format("write `{}`", right);
  return false;
}

/// The value of a number in the base unit; nothing for what is no number.
std::optional<double> number_in_base_unit(const YamlValue& yaml, const Format& format) {
  if (format.kind == Format::Kind::integer) {
    const auto value = parse_int(yaml.text);
    return value ? std::optional(static_cast<double>(*value)) : std::nullopt;
  }
  const bool plain = format.quantity == Quantity::none || take_unit_off(yaml.text).unit.empty();
  if (format.kind == Format::Kind::number && plain) return parse_number(yaml.text);
  const auto value = parse_quantity(yaml.text, format.quantity);
  return value ? std::optional(value->to_double()) : std::nullopt;
}

bool check_number(const YamlValue& yaml, const Format& format, Diagnostics& diagnostics) {
  if (!yaml.is_scalar() || yaml.quoted) return wrong_type(yaml, format, diagnostics);
  if (format.quantity != Quantity::none && !check_unit(yaml, format, diagnostics)) return false;
  const auto value = number_in_base_unit(yaml, format);
  return value ? in_range(yaml, format, *value, diagnostics)
               : wrong_type(yaml, format, diagnostics);
}

bool check_memory(const YamlValue& yaml, const Format& format, Diagnostics& diagnostics) {
  if (!yaml.is_scalar() || yaml.quoted) return wrong_type(yaml, format, diagnostics);
  if (parse_bytes(yaml.text)) return true;
  const auto [number, unit] = take_unit_off(yaml.text);
  const auto value = Rational::parse(number);
  const bool known = unit.empty() || contains(units_of_memory(), std::string(unit));
  if (!value || (known && *value > Rational())) return wrong_type(yaml, format, diagnostics);
  if (known) {
    diagnostics
        .error("E0204", yaml.span,
               fmt::format("expected {}, found {}", format.what, describe(yaml)))
        .label = "must be at least 0";
    return false;
  }
  const std::string right = with_right_unit_of_memory(yaml.text);
  diagnostics
      .error("E0209", yaml.span, fmt::format("`{}` is not a unit of memory", shortened(unit)))
      .help = right.empty()
                  ? fmt::format("units of memory are {}", fmt::join(units_of_memory(), ", "))
                  : fmt::format("write `{}`", right);
  return false;
}

bool is_dotted_name(std::string_view text) {
  while (true) {
    const std::size_t end = std::min(text.find('.'), text.size());
    if (!is_inner_name(text.substr(0, end))) return false;
    if (end == text.size()) return true;
    text.remove_prefix(end + 1);
  }
}

bool check_map(const YamlValue& yaml, const Format& format, Diagnostics& diagnostics) {
  if (yaml.is_null()) return true;  // `config:` with nothing behind it
  if (!yaml.is_map()) return wrong_type(yaml, format, diagnostics);
  bool good = true;
  for (std::size_t i = 0; i < yaml.entries.size(); ++i) {
    const auto& entry = yaml.entries[i];
    const bool bare = i + 1 < yaml.entries.size() && entry.value.is_null();
    const std::size_t outside =
        bare ? report_not_indented(yaml, i + 1, format, diagnostics) : std::size_t{0};
    if (outside > 0 || report_decimal_comma(yaml.entries, i, diagnostics)) {
      good = false;
      i += outside;
      continue;
    }
    if (format.key)
      good = check(made_scalar(entry.key, entry.key_span), *format.key, diagnostics) && good;
    const bool is_name = format.dotted_names  ? is_dotted_name(entry.key)
                         : format.inner_names ? is_inner_name(entry.key)
                                              : is_identifier(entry.key);
    if (!format.file_names && !is_name) {
      report_bad_name(entry.key, entry.key_span, diagnostics);
      good = false;
    }
    good = check(entry.value, *format.item, diagnostics) && good;
  }
  return good;
}

bool check_list(const YamlValue& yaml, const Format& format, Diagnostics& diagnostics) {
  if (!yaml.is_sequence()) return wrong_type(yaml, format, diagnostics);
  if (yaml.items.size() < format.min_items) {
    diagnostics.error("E0204", yaml.span,
                      fmt::format("expected {}, found an empty list", format.what));
    return false;
  }
  bool good = true;
  for (const auto& item : yaml.items) good = check(item, *format.item, diagnostics) && good;
  return good;
}

/// `theta:` with nothing behind it is a record without settings, where nothing is required.
bool is_empty_record(const YamlValue& yaml, const Format& format) {
  return yaml.is_null() && std::ranges::none_of(format.fields, &Field::required);
}

/// Returns the key that was meant; empty if nobody can say.
std::string report_unknown_key(const YamlValue& yaml, std::size_t i, const Format& format,
                               const std::vector<std::string>& known, Diagnostics& diagnostics) {
  const YamlValue::Entry& entry = yaml.entries[i];
  auto& problem = diagnostics.error("E0201", entry.key_span,
                                    fmt::format("unknown key `{}` in {}", entry.key, format.what));
  const auto glued = entry.value.is_null() ? glued_key(entry.key) : std::nullopt;
  if (glued && contains(known, glued->key)) {
    problem.help = glued->help;
    return glued->key;
  }
  const std::string near = nearest(entry.key, known);
  const std::string outer = outdented_from(yaml, i, format);
  problem.help = !outer.empty() ? fmt::format("indent it, if it is one of `{}:`", outer)
                 : near.empty()
                     ? fmt::format("{} has the keys {}", format.what, fmt::join(known, ", "))
                     : fmt::format("did you mean `{}`?", near);
  return near;
}

bool check_record(const YamlValue& yaml, const Format& format, Diagnostics& diagnostics) {
  if (is_empty_record(yaml, format)) return true;
  if (!yaml.is_map()) return wrong_type(yaml, format, diagnostics);
  bool good = true;
  const std::vector<std::string> known = names_of(format.fields);
  std::vector<std::string> meant;
  for (std::size_t i = 0; i < yaml.entries.size(); ++i) {
    const auto& entry = yaml.entries[i];
    if (const Field* field = find_named(format.fields, entry.key)) {
      good = check(entry.value, *field->format, diagnostics) && good;
      continue;
    }
    if (format.item) {
      good = check_name(entry.key, entry.key_span, diagnostics) &&
             check(entry.value, *format.item, diagnostics) && good;
      continue;
    }
    good = false;
    if (!report_decimal_comma(yaml.entries, i, diagnostics))
      meant.push_back(report_unknown_key(yaml, i, format, known, diagnostics));
  }
  for (const auto& field : format.fields) {
    if (!field.required || yaml.find(field.name) != nullptr) continue;
    if (contains(meant, field.name)) continue;  // just misspelt
    diagnostics
        .error("E0202", yaml.span, fmt::format("missing key `{}` in {}", field.name, format.what))
        .help = fmt::format("add `{}:`, {}", field.name, field.about);
    good = false;
  }
  return good;
}

/// Right or wrong: it is meant as a number with a unit.
bool has_unit(const YamlValue& yaml, const Format& format) {
  if (format.quantity == Quantity::none) return false;
  const auto [number, unit] = take_unit_off(yaml.text);
  return !unit.empty() && Rational::parse(number);
}

/// Whether a value of this kind could be meant for the format at all.
bool takes(const YamlValue& yaml, const Format& format) {
  switch (format.kind) {
    case Format::Kind::any:
      return true;
    case Format::Kind::list:
      return yaml.is_sequence();
    case Format::Kind::map:
      return yaml.is_map();
    case Format::Kind::record:
      return yaml.is_map() || is_empty_record(yaml, format);
    case Format::Kind::one_of:
      return std::ranges::any_of(format.options,
                                 [&](const FormatPtr& option) { return takes(yaml, *option); });
    case Format::Kind::integer:
      return yaml.is_scalar() && !yaml.quoted && parse_int(yaml.text);
    case Format::Kind::number:
    case Format::Kind::decimal:
      return yaml.is_scalar() && !yaml.quoted &&
             (parse_number(yaml.text) || Rational::parse(yaml.text) || has_unit(yaml, format));
    case Format::Kind::boolean:
      return yaml.is_scalar() && !yaml.quoted && parse_bool(yaml.text);
    default:
      return yaml.is_scalar();
  }
}

}  // namespace

bool check_name(std::string_view text, Span span, Diagnostics& diagnostics) {
  if (is_identifier(text)) return true;
  report_bad_name(text, span, diagnostics);
  return false;
}

bool check(const YamlValue& yaml, const Format& format, Diagnostics& diagnostics) {
  switch (format.kind) {
    case Format::Kind::any:
      return true;
    case Format::Kind::text:
      return yaml.is_scalar() || wrong_type(yaml, format, diagnostics);
    case Format::Kind::name:
      return check_scalar_name(yaml, format, diagnostics);
    case Format::Kind::port:
      return check_port(yaml, format, diagnostics);
    case Format::Kind::path:
      return check_path(yaml, format, diagnostics);
    case Format::Kind::keyword:
      return check_keyword(yaml, format, "", diagnostics);
    case Format::Kind::boolean:
      return (yaml.is_scalar() && !yaml.quoted && parse_bool(yaml.text)) ||
             wrong_type(yaml, format, diagnostics);
    case Format::Kind::integer:
    case Format::Kind::decimal:
    case Format::Kind::number:
      return check_number(yaml, format, diagnostics);
    case Format::Kind::memory:
      return check_memory(yaml, format, diagnostics);
    case Format::Kind::list:
      return check_list(yaml, format, diagnostics);
    case Format::Kind::map:
      return check_map(yaml, format, diagnostics);
    case Format::Kind::record:
      return check_record(yaml, format, diagnostics);
    case Format::Kind::one_of:
      for (const auto& option : format.options) {
        if (!takes(yaml, *option)) continue;
        return option->kind == Format::Kind::keyword
                   ? check_keyword(yaml, *option, format.what, diagnostics)
                   : check(yaml, *option, diagnostics);
      }
      return wrong_type(yaml, format, diagnostics);
  }
  return false;
}

namespace {

void put_in_base_units(YamlValue& yaml, const Format& format) {
  if (format.kind == Format::Kind::one_of) {
    const auto option = std::ranges::find_if(
        format.options, [&](const FormatPtr& each) { return takes(yaml, *each); });
    if (option != format.options.end()) put_in_base_units(yaml, **option);
    return;
  }
  if (format.quantity != Quantity::none && yaml.is_scalar()) {
    const Unit& base = *find_unit(format.quantity == Quantity::rate ? "Hz" : "s");
    yaml.with_unit = !take_unit_off(yaml.text).unit.empty();
    yaml.text = number_in(yaml.text, base).value_or(yaml.text);
  }
  if (format.kind == Format::Kind::memory && yaml.is_scalar()) {
    const auto bytes = parse_bytes(yaml.text);
    yaml.text = bytes ? std::to_string(*bytes) : yaml.text;
  }
  for (auto& item : yaml.items) {
    if (format.item) put_in_base_units(item, *format.item);
  }
  for (auto& [key, span, value] : yaml.entries) {
    const Field* field = find_named(format.fields, key);
    const Format* inner = field != nullptr ? field->format.get() : format.item.get();
    if (inner != nullptr) put_in_base_units(value, *inner);
  }
}

}  // namespace

YamlValue in_base_units(YamlValue yaml, const Format& format) {
  put_in_base_units(yaml, format);
  return yaml;
}

}  // namespace eagerx::gen

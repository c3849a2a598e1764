#include "generator/frontend/spec/format_scalar.hpp"

#include <fmt/format.h>

#include "generator/frontend/read/bytes.hpp"
#include "generator/frontend/read/number.hpp"
#include "generator/frontend/read/rational.hpp"
#include "generator/frontend/read/scalar.hpp"
#include "generator/frontend/read/typos.hpp"
#include "generator/frontend/spec/foreign_words.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/frontend/spec/typos.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {

namespace {

/// How a mapping is written: "{rate: …}" with the keys that it must have, "{NAME: …}" for names
/// that the user chooses.
std::string mapping_text(const Format& format) {
  constexpr std::size_t kMostKeys = 6;
  if (format.kind == Format::Kind::map) return "{NAME: …}";
  std::vector<std::string> keys;
  for (const Field& field : format.fields) {
    if (field.required) keys.push_back(field.name);
  }
  if (keys.empty() && format.fields.size() <= kMostKeys) keys = names_of(format.fields);
  if (format.item) keys.emplace_back("NAME");
  return keys.empty() ? "{KEY: …}" : fmt::format("{{{}: …}}", join(keys, ": …, "));
}

/// Suggests what to write instead of a list, a mapping or one value where another of these is
/// expected.
Help other_form(const YamlValue& yaml, const Format& format) {
  using Kind = Format::Kind;
  const auto any_is = [&](auto&& fits) {
    return format.kind != Kind::one_of
               ? fits(format)
               : ranges::any_of(format.options, [&](const FormatPtr& each) { return fits(*each); });
  };
  const auto is_mapping = [](const Format& one) {
    return one.kind == Kind::record || one.kind == Kind::map;
  };
  const auto is_list = [](const Format& one) { return one.kind == Kind::list; };
  const bool mapping = any_is(is_mapping), list = any_is(is_list);
  const bool value = any_is([&](const Format& one) { return !is_mapping(one) && !is_list(one); });
  if (yaml.is_sequence() && value) {
    const bool has_one = yaml.items.size() == 1 && yaml.items.front().is_scalar();
    if (has_one) {
      const std::string& one = yaml.items[0].text;
      return {fmt::format("write `{}`, without brackets or a dash", one), change_list_to(one)};
    }
    return mapping ? "" : "it takes one value, not a list";
  }
  if (yaml.is_map() && list) return "write a list: `[…]`, or lines that begin with a dash";
  if (yaml.is_map() && value) return "it takes one value, not a mapping";
  if (yaml.is_scalar() && list && !yaml.is_null() && !yaml.quoted)
    return fmt::format("write a list: `[{}]`", yaml.text);
  if (format.kind == Kind::one_of || !mapping || yaml.is_null()) return {};
  return fmt::format("write `{}`, or the same on separate lines{}", mapping_text(format),
                     yaml.is_sequence() ? " without dashes" : "");
}

}  // namespace

/// `thirty`, not `30 fps` or `$(config rate)`.
static bool is_word(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_';
  });
}

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
    problem.help = {"quotes make it text: remove them", change_to(yaml.text)};
  if (problem.help.empty()) problem.help = other_form(yaml, format);
  if (!yaml.is_scalar() || yaml.quoted) return false;
  const auto is_truth = [](const Format& one) { return one.kind == Format::Kind::boolean; };
  const bool takes_truth =
      is_truth(format) ||
      (format.kind == Format::Kind::one_of &&
       ranges::any_of(format.options, [&](const FormatPtr& each) { return is_truth(*each); }));
  const std::string truth(takes_truth ? foreign_truth(yaml.text) : "");
  if (!truth.empty()) {
    problem.help = write_instead(truth);
  } else if (const auto foreign = foreign_number(yaml.text)) {
    problem.help = foreign->help;
  } else if (const auto glued = mapping ? glued_key(yaml.text) : std::nullopt) {
    problem.help = glued->help;
    if (yaml.text.find(':') != std::string::npos)
      problem.help.fixes = {change_to(fmt::format("{}: {}", glued->key, glued->value))};
  } else if (problem.help.empty() && is_word(yaml.text) &&
             (format.kind == Format::Kind::integer || format.kind == Format::Kind::decimal ||
              format.kind == Format::Kind::number)) {
    problem.help = "write it in digits, such as `30`";
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

namespace {

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

}  // namespace

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
  auto& problem =
      diagnostics.error("E0205", yaml.span, fmt::format("{} is not a port", describe(yaml)));
  problem.help = fmt::format("write {}", format.what);
  // As traces spell it: node/output.
  const std::size_t slash = yaml.text.rfind('/');
  if (!good || parts != 1 || slash == std::string::npos) return false;
  std::string port = yaml.text;
  port[slash] = '.';
  problem.help = write_instead(port);
  return false;
}

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

bool report_word_for_key(const YamlValue& yaml, const Format& format, Diagnostics& diagnostics) {
  for (const FormatPtr& option : format.options) {
    if (option->kind != Format::Kind::record) continue;
    const std::vector<std::string> keys = names_of(option->fields);
    const std::string key = contains(keys, yaml.text) ? yaml.text : foreign_word(yaml.text, keys);
    if (key.empty()) continue;
    const Format& value = *find_named(option->fields, key)->format;
    const bool is_map = value.kind == Format::Kind::record || value.kind == Format::Kind::map;
    diagnostics.error("E0204", yaml.span, fmt::format("{} is not a choice here", describe(yaml)))
        .help = fmt::format("write `{{{}: {}}}`", key, is_map ? mapping_text(value) : "…");
    return true;
  }
  return false;
}

bool check_keyword(const YamlValue& yaml, const Format& format, const std::string& otherwise,
                   Diagnostics& diagnostics) {
  if (!yaml.is_scalar()) return wrong_type(yaml, format, diagnostics);
  if (contains(format.keywords, yaml.text)) return true;
  auto& problem =
      diagnostics.error("E0204", yaml.span, fmt::format("{} is not a choice here", describe(yaml)));
  if (const std::string meant = foreign_word(yaml.text, format.keywords); !meant.empty()) {
    problem.help = write_instead(meant);
    return false;
  }
  problem.help = did_you_mean(yaml.text, format.keywords,
                              otherwise.empty() ? fmt::format("choose one of {}", format.what)
                                                : fmt::format("write {}", otherwise));
  return false;
}

namespace {

std::string with_article(Quantity quantity) {
  return quantity == Quantity::rate    ? "a rate"
         : quantity == Quantity::angle ? "an angle"
         : quantity == Quantity::gain  ? "a gain"
         : quantity == Quantity::share ? "a share"
                                       : "a time";
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
  problem.help = !right.empty() ? write_instead(right)
                                : fmt::format("units of {} are {}", wanted,
                                              join(units_of(format.quantity), ", "));
  return false;
}

/// The value of a number in the base unit; nothing for what is no number.
std::optional<double> number_in_base_unit(const YamlValue& yaml, const Format& format) {
  if (format.kind == Format::Kind::integer) {
    const auto value = whole_of(yaml);
    return value ? std::optional(static_cast<double>(*value)) : std::nullopt;
  }
  if (yaml.number) return real_of(yaml);
  const bool plain = format.quantity == Quantity::none || take_unit_off(yaml.text).unit.empty();
  if (format.kind == Format::Kind::number && plain) return parse_number(yaml.text);
  const auto value = parse_quantity(yaml.text, format.quantity);
  return value ? std::optional(value->to_double()) : std::nullopt;
}

}  // namespace

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
      .help = !right.empty() ? write_instead(right)
                             : fmt::format("units of memory are {}", join(units_of_memory(), ", "));
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

bool has_unit(const YamlValue& yaml, const Format& format) {
  if (format.quantity == Quantity::none) return false;
  const auto [number, unit] = take_unit_off(yaml.text);
  return !unit.empty() && Rational::parse(number);
}

bool check_name(std::string_view text, Span span, Diagnostics& diagnostics) {
  if (is_identifier(text)) return true;
  report_bad_name(text, span, diagnostics);
  return false;
}

}  // namespace eagerx::gen

// A tree against its table, with every problem in plain words.
#include <fmt/format.h>

#include <algorithm>

#include "generator/read/rational.hpp"
#include "generator/read/scalar.hpp"
#include "generator/spec/format.hpp"

namespace eagerx::gen {
namespace {

bool wrong_type(const Node& node, const Format& format, Diagnostics& diagnostics) {
  const bool mapping = format.kind == Format::Kind::record || format.kind == Format::Kind::map;
  auto& problem =
      diagnostics.error("E0203", node.span,
                        fmt::format("expected {}{}, found {}", mapping ? "a mapping for " : "",
                                    format.what, describe(node)));
  const bool number = format.kind == Format::Kind::integer ||
                      format.kind == Format::Kind::decimal || format.kind == Format::Kind::number ||
                      format.kind == Format::Kind::boolean;
  if (number && node.is_scalar() && node.quoted)
    problem.help = "quotes make it a text: leave them out";
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
  diagnostics.error("E0205", span, fmt::format("`{}` is not a name", text)).help =
      "use letters, digits and single underscores, beginning with a letter";
}

bool in_range(const Node& node, const Format& format, double value, Diagnostics& diagnostics) {
  const bool low =
      format.low && (value < *format.low || (format.low_exclusive && value <= *format.low));
  const bool high = format.high && value > *format.high;
  if (!low && !high) return true;
  auto& problem = diagnostics.error(
      "E0204", node.span, fmt::format("expected {}, found {}", format.what, describe(node)));
  if (low)
    problem.label = fmt::format("must be {} {}", format.low_exclusive ? "greater than" : "at least",
                                *format.low);
  if (high) problem.label = fmt::format("must be at most {}", *format.high);
  return false;
}

bool check_name(const Node& node, const Format& format, Diagnostics& diagnostics) {
  if (!node.is_scalar()) return wrong_type(node, format, diagnostics);
  if (is_identifier(node.text)) return true;
  report_bad_name(node.text, node.span, diagnostics);
  return false;
}

bool check_port(const Node& node, const Format& format, Diagnostics& diagnostics) {
  if (!node.is_scalar()) return wrong_type(node, format, diagnostics);
  std::size_t parts = 0;
  bool good = true;
  for (std::size_t begin = 0; begin <= node.text.size(); ++parts) {
    const std::size_t end = std::min(node.text.find('.', begin), node.text.size());
    const std::string_view part = std::string_view(node.text).substr(begin, end - begin);
    if (is_reserved_name(part) || part.size() > kLongestName) {
      report_bad_name(part, node.span, diagnostics);
      return false;
    }
    good = good && is_identifier(part);
    begin = end + 1;
  }
  if (good && parts >= 2 && parts <= 3) return true;
  diagnostics.error("E0205", node.span, fmt::format("{} is not a port", describe(node))).help =
      fmt::format("write {}", format.what);
  return false;
}

/// `otherwise`: what may be written instead of a keyword.
bool check_keyword(const Node& node, const Format& format, const std::string& otherwise,
                   Diagnostics& diagnostics) {
  if (!node.is_scalar()) return wrong_type(node, format, diagnostics);
  if (std::find(format.keywords.begin(), format.keywords.end(), node.text) !=
      format.keywords.end()) {
    return true;
  }
  auto& problem =
      diagnostics.error("E0204", node.span, fmt::format("{} is not a choice here", describe(node)));
  const std::string near = nearest(node.text, format.keywords);
  if (!near.empty()) {
    problem.help = fmt::format("did you mean `{}`?", near);
  } else {
    problem.help = otherwise.empty() ? fmt::format("choose one of {}", format.what)
                                     : fmt::format("write {}", otherwise);
  }
  return false;
}

bool check_number(const Node& node, const Format& format, Diagnostics& diagnostics) {
  if (!node.is_scalar() || node.quoted) return wrong_type(node, format, diagnostics);
  if (format.kind == Format::Kind::integer) {
    const auto value = parse_int(node.text);
    return value ? in_range(node, format, static_cast<double>(*value), diagnostics)
                 : wrong_type(node, format, diagnostics);
  }
  if (format.kind == Format::Kind::decimal) {
    const auto value = Rational::parse(node.text);
    return value ? in_range(node, format, value->to_double(), diagnostics)
                 : wrong_type(node, format, diagnostics);
  }
  const auto value = parse_number(node.text);
  return value ? in_range(node, format, *value, diagnostics)
               : wrong_type(node, format, diagnostics);
}

bool check_map(const Node& node, const Format& format, Diagnostics& diagnostics) {
  if (node.is_null()) return true;  // `config:` with nothing behind it
  if (!node.is_map()) return wrong_type(node, format, diagnostics);
  bool good = true;
  for (const auto& entry : node.entries) {
    if (!format.file_names && !is_identifier(entry.key)) {
      report_bad_name(entry.key, entry.key_span, diagnostics);
      good = false;
    }
    good = check(entry.value, *format.item, diagnostics) && good;
  }
  return good;
}

bool check_list(const Node& node, const Format& format, Diagnostics& diagnostics) {
  if (!node.is_sequence()) return wrong_type(node, format, diagnostics);
  if (node.items.size() < format.min_items) {
    diagnostics.error("E0204", node.span,
                      fmt::format("expected {}, found an empty list", format.what));
    return false;
  }
  bool good = true;
  for (const auto& item : node.items) good = check(item, *format.item, diagnostics) && good;
  return good;
}

/// `theta:` with nothing behind it is a record without settings, where nothing is required.
bool is_empty_record(const Node& node, const Format& format) {
  return node.is_null() && std::none_of(format.fields.begin(), format.fields.end(),
                                        [](const Field& field) { return field.required; });
}

bool check_record(const Node& node, const Format& format, Diagnostics& diagnostics) {
  if (is_empty_record(node, format)) return true;
  if (!node.is_map()) return wrong_type(node, format, diagnostics);
  bool good = true;
  std::vector<std::string> known, meant;
  for (const auto& field : format.fields) known.push_back(field.name);
  for (const auto& entry : node.entries) {
    const auto field = std::find_if(format.fields.begin(), format.fields.end(),
                                    [&](const Field& f) { return f.name == entry.key; });
    if (field != format.fields.end()) {
      good = check(entry.value, *field->format, diagnostics) && good;
      continue;
    }
    auto& problem = diagnostics.error(
        "E0201", entry.key_span, fmt::format("unknown key `{}` in {}", entry.key, format.what));
    const std::string near = nearest(entry.key, known);
    problem.help = near.empty()
                       ? fmt::format("{} has the keys {}", format.what, fmt::join(known, ", "))
                       : fmt::format("did you mean `{}`?", near);
    meant.push_back(near);
    good = false;
  }
  for (const auto& field : format.fields) {
    if (!field.required || node.find(field.name) != nullptr) continue;
    if (std::find(meant.begin(), meant.end(), field.name) != meant.end())
      continue;  // just misspelt
    diagnostics
        .error("E0202", node.span, fmt::format("missing key `{}` in {}", field.name, format.what))
        .help = fmt::format("add `{}:`, {}", field.name, field.about);
    good = false;
  }
  return good;
}

/// Whether a node of this kind could be meant for the format at all.
bool takes(const Node& node, const Format& format) {
  switch (format.kind) {
    case Format::Kind::any:
      return true;
    case Format::Kind::list:
      return node.is_sequence();
    case Format::Kind::map:
      return node.is_map();
    case Format::Kind::record:
      return node.is_map() || is_empty_record(node, format);
    case Format::Kind::one_of:
      return std::any_of(format.options.begin(), format.options.end(),
                         [&](const FormatPtr& option) { return takes(node, *option); });
    case Format::Kind::integer:
      return node.is_scalar() && !node.quoted && parse_int(node.text);
    case Format::Kind::number:
    case Format::Kind::decimal:
      return node.is_scalar() && !node.quoted &&
             (parse_number(node.text) || Rational::parse(node.text));
    case Format::Kind::boolean:
      return node.is_scalar() && !node.quoted && parse_bool(node.text);
    default:
      return node.is_scalar();
  }
}

}  // namespace

bool check(const Node& node, const Format& format, Diagnostics& diagnostics) {
  switch (format.kind) {
    case Format::Kind::any:
      return true;
    case Format::Kind::text:
      return node.is_scalar() || wrong_type(node, format, diagnostics);
    case Format::Kind::name:
      return check_name(node, format, diagnostics);
    case Format::Kind::port:
      return check_port(node, format, diagnostics);
    case Format::Kind::keyword:
      return check_keyword(node, format, "", diagnostics);
    case Format::Kind::boolean:
      return (node.is_scalar() && !node.quoted && parse_bool(node.text)) ||
             wrong_type(node, format, diagnostics);
    case Format::Kind::integer:
    case Format::Kind::decimal:
    case Format::Kind::number:
      return check_number(node, format, diagnostics);
    case Format::Kind::list:
      return check_list(node, format, diagnostics);
    case Format::Kind::map:
      return check_map(node, format, diagnostics);
    case Format::Kind::record:
      return check_record(node, format, diagnostics);
    case Format::Kind::one_of:
      for (const auto& option : format.options) {
        if (!takes(node, *option)) continue;
        return option->kind == Format::Kind::keyword
                   ? check_keyword(node, *option, format.what, diagnostics)
                   : check(node, *option, diagnostics);
      }
      return wrong_type(node, format, diagnostics);
  }
  return false;
}

}  // namespace eagerx::gen

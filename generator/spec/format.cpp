#include "generator/spec/format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "generator/read/rational.hpp"
#include "generator/read/scalar.hpp"

namespace eagerx::gen {
namespace format {
namespace {
Format make(Format::Kind kind, std::string what) {
  Format result;
  result.kind = kind;
  result.what = std::move(what);
  return result;
}
FormatPtr share(Format result) {
  return std::make_shared<const Format>(std::move(result));
}
}  // namespace

FormatPtr any(std::string what) {
  return share(make(Format::Kind::any, std::move(what)));
}
FormatPtr text(std::string what) {
  return share(make(Format::Kind::text, std::move(what)));
}
FormatPtr name(std::string what) {
  return share(make(Format::Kind::name, std::move(what)));
}
FormatPtr port(std::string what) {
  return share(make(Format::Kind::port, std::move(what)));
}
FormatPtr number(std::string what) {
  return share(make(Format::Kind::number, std::move(what)));
}
FormatPtr boolean() {
  return share(make(Format::Kind::boolean, "true or false"));
}

FormatPtr integer(std::string what, std::optional<double> low, std::optional<double> high) {
  Format result = make(Format::Kind::integer, std::move(what));
  result.low = low;
  result.high = high;
  return share(std::move(result));
}

FormatPtr decimal(std::string what, double low, bool low_exclusive) {
  Format result = make(Format::Kind::decimal, std::move(what));
  result.low = low;
  result.low_exclusive = low_exclusive;
  return share(std::move(result));
}

FormatPtr keyword(std::vector<std::string> words) {
  Format result = make(Format::Kind::keyword, fmt::format("{}", fmt::join(words, ", ")));
  result.keywords = std::move(words);
  return share(std::move(result));
}

FormatPtr list(std::string what, FormatPtr item, std::size_t min_items) {
  Format result = make(Format::Kind::list, std::move(what));
  result.item = std::move(item);
  result.min_items = min_items;
  return share(std::move(result));
}

FormatPtr map(std::string what, FormatPtr item) {
  Format result = make(Format::Kind::map, std::move(what));
  result.item = std::move(item);
  return share(std::move(result));
}

FormatPtr file_map(std::string what) {
  Format result = make(Format::Kind::map, std::move(what));
  result.item = text("a file name");
  result.file_names = true;
  return share(std::move(result));
}

FormatPtr record(std::string what, std::vector<Field> fields) {
  Format result = make(Format::Kind::record, std::move(what));
  result.fields = std::move(fields);
  return share(std::move(result));
}

FormatPtr one_of(std::string what, std::vector<FormatPtr> options) {
  Format result = make(Format::Kind::one_of, std::move(what));
  result.options = std::move(options);
  return share(std::move(result));
}
}  // namespace format

namespace {

bool is_reserved(std::string_view text) {
  static constexpr std::array kReserved = {"alignas",
                                           "alignof",
                                           "and",
                                           "asm",
                                           "auto",
                                           "bool",
                                           "break",
                                           "case",
                                           "catch",
                                           "char",
                                           "class",
                                           "concept",
                                           "const",
                                           "continue",
                                           "decltype",
                                           "default",
                                           "delete",
                                           "do",
                                           "double",
                                           "else",
                                           "enum",
                                           "explicit",
                                           "export",
                                           "extern",
                                           "false",
                                           "float",
                                           "for",
                                           "friend",
                                           "goto",
                                           "if",
                                           "inline",
                                           "int",
                                           "long",
                                           "mutable",
                                           "namespace",
                                           "new",
                                           "noexcept",
                                           "not",
                                           "nullptr",
                                           "operator",
                                           "or",
                                           "private",
                                           "protected",
                                           "public",
                                           "register",
                                           "requires",
                                           "return",
                                           "short",
                                           "signed",
                                           "sizeof",
                                           "static",
                                           "struct",
                                           "switch",
                                           "template",
                                           "this",
                                           "throw",
                                           "true",
                                           "try",
                                           "typedef",
                                           "typeid",
                                           "typename",
                                           "union",
                                           "unsigned",
                                           "using",
                                           "virtual",
                                           "void",
                                           "volatile",
                                           "wchar_t",
                                           "while",
                                           "xor",
                                           "eagerx",
                                           "std",
                                           "constexpr",
                                           "bitand",
                                           "bitor",
                                           "compl",
                                           "co_await",
                                           "co_yield",
                                           "co_return",
                                           "main",
                                           "consteval",
                                           "constinit",
                                           "static_assert",
                                           "thread_local",
                                           "not_eq",
                                           "and_eq",
                                           "or_eq",
                                           "xor_eq",
                                           "const_cast",
                                           "dynamic_cast",
                                           "reinterpret_cast",
                                           "static_cast",
                                           "char8_t",
                                           "char16_t",
                                           "char32_t",
                                           "linux", "unix", "NULL", "EOF", "NAN", "INFINITY", "errno", "assert", "Action", "Observation", "States", "Inputs", "Outputs", "Config"};
  return std::find(kReserved.begin(), kReserved.end(), text) != kReserved.end();
}

}  // namespace

bool is_identifier(std::string_view text) {
  if (text.empty() || text.size() > 100 || std::isdigit(static_cast<unsigned char>(text[0])) != 0) {
    return false;
  }
  const bool letters = std::all_of(text.begin(), text.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  });
  const bool implementation = text[0] == '_' || text.find("__") != std::string_view::npos;
  return letters && !implementation && !is_reserved(text);
}

std::string describe(const Node& node) {
  switch (node.kind) {
    case NodeKind::null:
      return "nothing";
    case NodeKind::sequence:
      return "a list";
    case NodeKind::map:
      return "a mapping";
    case NodeKind::scalar:
      break;
  }
  constexpr std::size_t kMostShown = 40;
  std::string shown = node.text;
  if (shown.size() > kMostShown) {
    std::size_t end = kMostShown;
    while (end > 0 && (static_cast<unsigned char>(shown[end]) & 0xc0U) == 0x80U) --end;  // not within a letter
    shown = shown.substr(0, end) + "…";
  }
  return fmt::format("{}`{}`", node.quoted ? "the text " : "", shown);
}

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
  if (is_reserved(text)) {
    diagnostics
        .error("E0205", span, fmt::format("`{}` is a word of C++ or of generated code and cannot be a name", text))
        .help = "names become C++ identifiers: choose another one";
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
    good = good && is_identifier(std::string_view(node.text).substr(begin, end - begin));
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

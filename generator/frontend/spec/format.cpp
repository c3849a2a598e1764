#include "generator/frontend/spec/format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <unordered_set>

#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

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
FormatPtr number(std::string what, Quantity quantity) {
  Format result = make(Format::Kind::number, std::move(what));
  result.quantity = quantity;
  return share(std::move(result));
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

FormatPtr memory(std::string what) {
  return share(make(Format::Kind::memory, std::move(what)));
}

FormatPtr rate() {
  Format result = *decimal("a rate in Hz", 0.0, true);
  result.quantity = Quantity::rate;
  return share(std::move(result));
}

FormatPtr time(std::string what, bool low_exclusive) {
  Format result = *decimal(std::move(what), 0.0, low_exclusive);
  result.quantity = Quantity::time;
  return share(std::move(result));
}

FormatPtr fraction(std::string what) {
  Format result = *decimal(std::move(what), 0.0, true);
  result.quantity = Quantity::share;
  result.high = 1.0;
  return share(std::move(result));
}

FormatPtr keyword(std::vector<std::string> words) {
  Format result = make(Format::Kind::keyword, fmt::format("{}", join(words, ", ")));
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

FormatPtr inner_map(std::string what, FormatPtr item) {
  Format result = *map(std::move(what), std::move(item));
  result.inner_names = true;
  return share(std::move(result));
}

FormatPtr path(std::string what, bool leaves) {
  Format result = make(Format::Kind::path, std::move(what));
  result.leaves = leaves;
  return share(std::move(result));
}

FormatPtr file_name(std::string what) {
  Format result = make(Format::Kind::path, std::move(what));
  result.one_name = true;
  return share(std::move(result));
}

FormatPtr record(std::string what, std::vector<Field> fields) {
  Format result = make(Format::Kind::record, std::move(what));
  result.fields = std::move(fields);
  return share(std::move(result));
}

FormatPtr open_record(std::string what, std::vector<Field> fields, FormatPtr others) {
  Format result = *record(std::move(what), std::move(fields));
  result.item = std::move(others);
  return share(std::move(result));
}

FormatPtr one_of(std::string what, std::vector<FormatPtr> options) {
  Format result = make(Format::Kind::one_of, std::move(what));
  result.options = std::move(options);
  return share(std::move(result));
}
}  // namespace format

namespace {

/// Names that <cfloat>, <climits>, <cmath>, <cstdint>, <cstdio> and <cstdlib> define as macros.
bool is_macro(std::string_view text) {
  static const std::unordered_set<std::string_view> kMacros{
      "BUFSIZ",      "DECIMAL_DIG", "EXIT_FAILURE",     "EXIT_SUCCESS", "FILENAME_MAX",
      "FOPEN_MAX",   "HUGE_VAL",    "HUGE_VALF",        "HUGE_VALL",    "L_tmpnam",
      "MATH_ERRNO",  "MB_CUR_MAX",  "MATH_ERREXCEPT",   "MB_LEN_MAX",   "M_1_PI",
      "M_2_PI",      "M_2_SQRTPI",  "math_errhandling", "M_E",          "M_LN10",
      "M_LN2",       "M_LOG10E",    "M_LOG2E",          "M_PI",         "M_PI_2",
      "M_PI_4",      "M_SQRT1_2",   "M_SQRT2",          "P_tmpdir",     "RAND_MAX",
      "SEEK_CUR",    "SEEK_END",    "SEEK_SET",         "TMP_MAX",      "PTRDIFF_MAX",
      "PTRDIFF_MIN", "SIZE_MAX",    "SIG_ATOMIC_MAX",   "SSIZE_MAX",    "SIG_ATOMIC_MIN",
      "WCHAR_MAX",   "WCHAR_MIN",   "WINT_MAX",         "WINT_MIN",     "CHAR_BIT",
      "SCHAR_MAX",   "SCHAR_MIN",   "CHAR_MAX",         "CHAR_MIN"};
  if (kMacros.contains(text)) return true;
  const bool capitals = ranges::all_of(text, [](char c) {
    return c == '_' || std::isupper(static_cast<unsigned char>(c)) != 0 ||
           std::isdigit(static_cast<unsigned char>(c)) != 0;
  });
  if (!capitals) return false;
  // INT32_MAX and UINT32_MAX, LONG_MAX and ULONG_MAX
  const std::string_view type = text.starts_with('U') ? text.substr(1) : text;
  static constexpr std::array kTypes = {"INT_",    "INT8_",     "INT16_",  "INT32_", "INT64_",
                                        "INTMAX_", "INTPTR_",   "LONG_",   "LLONG_", "SHRT_",
                                        "CHAR_",   "INT_LEAST", "INT_FAST"};
  static constexpr std::array kEnds = {"_MAX", "_MIN", "_WIDTH", "_C"};
  const auto starts = [](std::string_view word) {
    return [word](const char* prefix) { return word.starts_with(prefix); };
  };
  const auto ends = [&](const char* end) { return text.ends_with(end); };
  if (ranges::any_of(kTypes, starts(type)) && ranges::any_of(kEnds, ends)) return true;
  static constexpr std::array kFloating = {"FLT_", "DBL_", "LDBL_", "FP_"};
  return ranges::any_of(kFloating, starts(text));
}

}  // namespace

bool is_reserved_name(std::string_view text) {
  static const std::unordered_set<std::string_view> kReserved{
      "alignas",      "alignof",     "and",          "asm",
      "auto",         "bool",        "break",        "case",
      "catch",        "char",        "class",        "concept",
      "const",        "continue",    "decltype",     "default",
      "delete",       "do",          "double",       "else",
      "enum",         "explicit",    "export",       "extern",
      "false",        "float",       "for",          "friend",
      "goto",         "if",          "inline",       "int",
      "long",         "mutable",     "namespace",    "new",
      "noexcept",     "not",         "nullptr",      "operator",
      "or",           "private",     "protected",    "public",
      "register",     "requires",    "return",       "short",
      "signed",       "sizeof",      "static",       "struct",
      "switch",       "template",    "this",         "throw",
      "true",         "try",         "typedef",      "typeid",
      "typename",     "union",       "unsigned",     "using",
      "virtual",      "void",        "volatile",     "wchar_t",
      "while",        "xor",         "eagerx",       "graphs",
      "std",          "constexpr",   "bitand",       "bitor",
      "compl",        "co_await",    "co_yield",     "co_return",
      "main",         "consteval",   "constinit",    "static_assert",
      "thread_local", "not_eq",      "and_eq",       "or_eq",
      "xor_eq",       "const_cast",  "dynamic_cast", "reinterpret_cast",
      "static_cast",  "char8_t",     "char16_t",     "char32_t",
      "linux",        "unix",        "NULL",         "EOF",
      "NAN",          "INFINITY",    "errno",        "assert",
      "Action",       "Observation", "States",       "Inputs",
      "Outputs",      "Config",      "for_each",     "stdin",
      "stdout",       "stderr"};
  return kReserved.contains(text) || is_macro(text);
}

bool is_identifier(std::string_view text) {
  if (text.empty() || text.size() > kLongestName ||
      std::isdigit(static_cast<unsigned char>(text[0])) != 0) {
    return false;
  }
  const bool letters = ranges::all_of(
      text, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; });
  const bool implementation = text[0] == '_' || text.find("__") != std::string_view::npos;
  return letters && !implementation && !is_reserved_name(text);
}

bool is_inner_name(std::string_view text) {
  while (true) {
    const std::size_t end = std::min(text.find('/'), text.size());
    std::string_view part = text.substr(0, end);
    if (part.ends_with(']')) part = part.substr(0, part.find('['));
    if (!is_identifier(part)) return false;
    if (end == text.size()) return true;
    text.remove_prefix(end + 1);
  }
}

std::string describe(const YamlValue& yaml) {
  switch (yaml.kind) {
    case YamlKind::null:
      return "nothing";
    case YamlKind::sequence:
      return "a list";
    case YamlKind::map:
      return "a mapping";
    case YamlKind::scalar:
      break;
  }
  return fmt::format("{}`{}`", yaml.quoted ? "the text " : "", shortened(yaml.text));
}

std::string shortened(std::string_view text) {
  constexpr std::size_t kMostShown = 40;
  if (text.size() <= kMostShown) return std::string(text);
  std::size_t end = kMostShown;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80U)
    --end;  // not within a letter
  return std::string(text.substr(0, end)) + "…";
}

std::vector<Field> with(std::vector<Field> fields, std::vector<Field> more) {
  fields.insert(fields.end(), more.begin(), more.end());
  return fields;
}

}  // namespace eagerx::gen

#include "generator/support/quote/quote.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "generator/support/diagnostics/search.hpp"
#include "generator/support/diagnostics/utf8.hpp"

namespace eagerx::gen {
namespace {

bool is_letter_or_digit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

bool is_one_of(char c, std::string_view set) {
  return set.find(c) != std::string_view::npos;
}

/// Calls f(code point, its bytes) for each.
template <class F>
void for_each_code_point(std::string_view text, F&& f) {
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint point = decode_utf8(text, at);
    f(point, text.substr(at, point.size));
    at += point.size;
  }
}

/// Whether it must not stand in a source as it is, whatever the language.
bool is_hidden(const CodePoint& point) {
  // Byte order marks and blanks that are none for a compiler are hidden, too.
  return !point.valid || is_unprintable(point.value) || point.value == 0xfeff ||
         point.value == 0xa0 || (point.value >= 0x200b && point.value <= 0x200d);
}

std::string octal(std::string_view bytes) {
  std::string result;
  for (const char c : bytes) result += fmt::format("\\{:03o}", static_cast<unsigned char>(c));
  return result;
}

/// `\x..` or `\u....`, without a backslash that something could follow.
std::string visible(const CodePoint& point, std::string_view bytes) {
  if (!point.valid) return fmt::format("\\x{:02x}", static_cast<unsigned char>(bytes.front()));
  const auto value = static_cast<std::uint32_t>(point.value);
  return value < 0x100 ? fmt::format("\\x{:02x}", value) : fmt::format("\\u{:04x}", value);
}

}  // namespace

std::string in_cpp_string(std::string_view text) {
  std::string result;
  char before = '\0';
  for_each_code_point(text, [&](const CodePoint& point, std::string_view bytes) {
    const char c = bytes.front();
    if (is_hidden(point)) {
      result += octal(bytes);
    } else if (c == '"' || c == '\\' || (c == '?' && before == '?')) {  // of a trigraph
      result += '\\';
      result += c;
    } else {
      result += bytes;
    }
    before = c;
  });
  return result;
}

std::string cpp_string(std::string_view text) {
  return '"' + in_cpp_string(text) + '"';
}

std::string in_comment(std::string_view text) {
  std::string result;
  for_each_code_point(text, [&](const CodePoint& point, std::string_view bytes) {
    const char c = bytes.front();
    const char before = result.empty() ? '\0' : result.back();
    const bool ends_or_begins = (c == '/' && before == '*') || (c == '*' && before == '/');
    const bool trigraph = c == '?' && before == '?';
    // A comment of CMake that begins so continues to the next `]]`.
    const bool bracket = c == '[' && result.empty();
    if (is_hidden(point) || c == '\\' || ends_or_begins || trigraph || bracket)
      result += visible(point, bytes);
    else
      result += bytes;
  });
  return result;
}

std::string in_json_string(std::string_view text) {
  std::string result;
  for_each_code_point(text, [&](const CodePoint& point, std::string_view bytes) {
    const auto value = static_cast<std::uint32_t>(point.value);
    if (bytes == "\"" || bytes == "\\") {
      result += '\\';
      result += bytes;
    } else if (!point.valid) {
      result += "\\ufffd";
    } else if (is_hidden(point)) {
      result += fmt::format("\\u{:04x}", value);
    } else {
      result += bytes;
    }
  });
  return result;
}

std::string yaml_string(std::string_view text) {
  const bool simple = ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~'; });
  if (!simple) return '"' + in_json_string(text) + '"';
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "''" : std::string(1, c);
  return result + "'";
}

std::string yaml_text(std::string_view text) {
  // Those of YAML 1.1 and 1.2 that are something else.
  static constexpr std::string_view kWords[] = {"null", "true", "false", "yes", "no", "on",
                                                "off",  "y",    "n",     "inf", "nan"};
  std::string lower(text);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  const bool letter = !lower.empty() && lower.front() >= 'a' && lower.front() <= 'z';
  const bool word =
      letter && is_plain_word(text) && ranges::find(kWords, lower) == std::end(kWords);
  return word ? std::string(text) : yaml_string(text);
}

std::string yaml_scalar(std::string_view text) {
  const bool plain = is_plain_word(text) && ranges::any_of(text, is_letter_or_digit);
  // `- ` and `---` have a meaning, and no blank is in a plain word.
  return plain ? std::string(text) : yaml_string(text);
}

std::string in_cmake_string(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\n') {
      result += "\\n";
    } else if (c == '\r') {
      result += "\\r";
    } else if (c == '\t') {
      result += "\\t";
    } else {
      if (is_one_of(c, "\"\\$@")) result += '\\';
      result += c;
    }
  }
  return result;
}

std::string cmake_argument(std::string_view text) {
  return is_plain_word(text) ? std::string(text) : '"' + in_cmake_string(text) + '"';
}

std::string xml_text(std::string_view text) {
  std::string result;
  for_each_code_point(text, [&](const CodePoint& point, std::string_view bytes) {
    switch (is_hidden(point) ? '\0' : bytes.front()) {
      case '\0':
        result += visible(point, bytes);
        break;
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += bytes;
    }
  });
  return result;
}

std::string dot_string(std::string_view text) {
  std::string result = "\"";
  for_each_code_point(text, [&](const CodePoint& point, std::string_view bytes) {
    const bool special = bytes == "\"" || bytes == "\\";
    if (special) result += '\\';
    if (is_hidden(point))
      result += '\\' + visible(point, bytes);
    else
      result += bytes;
  });
  return result + '"';
}

std::string dot_record_text(std::string_view text) {
  std::string result;
  for_each_code_point(text, [&](const CodePoint& point, std::string_view bytes) {
    if (is_hidden(point)) {
      result += '\\' + visible(point, bytes);
      return;
    }
    if (is_one_of(bytes.front(), "{}|<> \"\\")) result += '\\';
    result += bytes;
  });
  return result;
}

std::string mermaid_text(std::string_view text) {
  std::string result;
  for_each_code_point(text, [&](const CodePoint& point, std::string_view bytes) {
    const char c = bytes.front();
    const bool plain = is_letter_or_digit(c) || is_one_of(c, " _.,:/()+-") || bytes.size() > 1;
    if (is_hidden(point))
      result += fmt::format("#92;{}", visible(point, bytes).substr(1));
    else if (plain)
      result += bytes;
    else
      result += fmt::format("#{};", static_cast<unsigned>(point.value));
  });
  return result;
}

std::string shell_word(std::string_view text) {
  const bool plain = ranges::all_of(text, [](char c) {
    return is_letter_or_digit(c) || is_one_of(c, "_-./=+:,@%") ||
           static_cast<unsigned char>(c) >= 0x80U;
  });
  if (!text.empty() && plain) return std::string(text);
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "'\\''" : std::string(1, c);
  return result + "'";
}

std::string in_shell_string(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (is_one_of(c, "\"\\$`")) result += '\\';
    result += c;
  }
  return result;
}

bool is_make_path(std::string_view path) {
  return path.find_first_of("\n\r") == std::string_view::npos;
}

std::string make_path(std::string_view path) {
  std::string result;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const char c = path[i];
    // Backslashes before a blank are halved; before anything else they are what they are.
    if (c == ' ' || c == '\t') {
      for (std::size_t back = i; back > 0 && path[back - 1] == '\\'; --back) result += '\\';
    }
    if (c == ' ' || c == '\t' || c == '#') result += '\\';
    if (c == '$') result += '$';
    result += c;
  }
  return result;
}

bool is_plain_word(std::string_view text) {
  return !text.empty() && ranges::all_of(text, [](char c) {
    return is_letter_or_digit(c) || is_one_of(c, "_.+-/");
  });
}

bool is_plain_file_name(std::string_view text) {
  return is_plain_word(text) && text.find('/') == std::string_view::npos && text != "." &&
         text != ".." && text.front() != '-';
}

bool is_plain_path(std::string_view text) {
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('/', begin), text.size());
    if (!is_plain_file_name(text.substr(begin, end - begin))) return false;
    begin = end + 1;
  }
  return true;
}

}  // namespace eagerx::gen

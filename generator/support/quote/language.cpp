#include "generator/support/quote/language.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {
namespace {

bool in_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

bool is_number(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789.+-eE") == std::string_view::npos;
}

using CharacterSet = std::array<bool, std::numeric_limits<unsigned char>::max() + 1>;

constexpr CharacterSet set_of(std::string_view characters) {
  CharacterSet set{};
  for (const char c : characters) set[static_cast<unsigned char>(c)] = true;
  return set;
}

// What can end code, in any language; comments and strings begin and end with one of these.
constexpr CharacterSet kEndsCode = set_of("/*\"'#[\\");

}  // namespace

Language language_of(std::string_view path) {
  const std::string_view name = path.substr(path.rfind('/') + 1);
  const std::string_view end = name.substr(std::min(name.rfind('.'), name.size()));
  for (const std::string_view cpp : {".hpp", ".cpp", ".h", ".c", ".cc", ".ino", ".S"}) {
    if (end == cpp) return Language::cpp;
  }
  if (name == "CMakeLists.txt" || end == ".cmake") return Language::cmake;
  if (end == ".yml" || end == ".yaml") return Language::yaml;
  if (end == ".json") return Language::json;
  if (end == ".sh") return Language::shell;
  if (end == ".ld") return Language::linker_script;
  return Language::other;
}

bool Quoter::has_line_comments_with(char c, char before) const {
  switch (language_) {
    case Language::cpp:
      return c == '/' && before == '/';
    case Language::cmake:
      return c == '#';
    case Language::yaml:
    case Language::shell:
      return c == '#' && (before == '\0' || before == '\n' || before == ' ' || before == '\t');
    default:
      return false;
  }
}

void Quoter::step_code(char c) {
  const char before = result_.empty() ? '\0' : result_.back();
  if (escaped_) {
    escaped_ = false;
  } else if (has_line_comments_with(c, before)) {
    where_ = Where::line_comment;
  } else if ((language_ == Language::cpp || language_ == Language::linker_script) && c == '*' &&
             before == '/') {
    where_ = Where::block_comment;
  } else if (c == '"' && language_ != Language::other) {
    const bool raw = language_ == Language::cpp && before == 'R' &&
                     (result_.size() < 2 || !in_word(result_[result_.size() - 2]));
    where_ = raw ? Where::raw : Where::string;
    raw_begin_ = raw ? "\"" : "";
  } else if (c == '\'' && language_ != Language::other && language_ != Language::cmake &&
             language_ != Language::json) {
    const bool separates_digits = language_ == Language::cpp && in_word(before);
    if (!separates_digits) where_ = Where::character;
  } else if (c == '[' && before == '[' && language_ == Language::cmake) {
    where_ = Where::raw;
    raw_end_ = "]]";
  } else if (c == '\\' && (language_ == Language::cmake || language_ == Language::shell)) {
    escaped_ = true;
  }
}

void Quoter::step(char c) {
  const char before = result_.empty() ? '\0' : result_.back();
  switch (where_) {
    case Where::code:
      step_code(c);
      break;
    case Where::line_comment:
      if (c == '[' && before == '[' && language_ == Language::cmake && result_.ends_with("#[")) {
        where_ = Where::raw;
        raw_end_ = "]]";
      }
      if (c == '\n') where_ = Where::code;
      break;
    case Where::block_comment:
      if (c == '/' && before == '*') where_ = Where::code;
      break;
    case Where::string:
    case Where::character:
      if (escaped_) {
        escaped_ = false;
      } else if (c == '\\' && !(where_ == Where::character &&
                                (language_ == Language::shell || language_ == Language::yaml))) {
        escaped_ = true;
      } else if (c == (where_ == Where::string ? '"' : '\'')) {
        where_ = Where::code;
      }
      break;
    case Where::raw:
      if (!raw_begin_.empty()) {
        raw_begin_ += c;
        if (c == '(') {
          raw_end_ = ")" + raw_begin_.substr(1, raw_begin_.size() - 2) + "\"";
          raw_begin_.clear();
        }
      } else if (c == raw_end_.back() &&
                 result_.ends_with(std::string_view(raw_end_).substr(0, raw_end_.size() - 1))) {
        where_ = Where::code;
      }
      break;
  }
  result_ += c;
}

/// The number of characters at the beginning of `text` that change nothing but result_.
std::size_t Quoter::plain_prefix(std::string_view text) const {
  if (escaped_) return 0;
  if (where_ == Where::code) {
    const auto end =
        std::ranges::find_if(text, [](char c) { return kEndsCode[static_cast<unsigned char>(c)]; });
    return static_cast<std::size_t>(end - text.begin());
  }
  if (where_ == Where::line_comment && language_ != Language::cmake)
    return std::min(text.find('\n'), text.size());
  return 0;
}

/// Most of a text is plain, and goes to the result as a whole.
void Quoter::add(std::string_view text) {
  while (!text.empty()) {
    const std::size_t plain = plain_prefix(text);
    result_ += text.substr(0, plain);
    text.remove_prefix(plain);
    if (text.empty()) return;
    step(text.front());
    text.remove_prefix(1);
  }
}

std::optional<std::string> Quoter::text_for(std::string_view value) const {
  if (where_ == Where::line_comment || where_ == Where::block_comment) return in_comment(value);
  if (where_ == Where::string) {
    switch (language_) {
      case Language::cpp:
        return in_cpp_string(value);
      case Language::cmake:
        return in_cmake_string(value);
      case Language::yaml:
      case Language::json:
        return in_json_string(value);
      case Language::shell:
        return in_shell_string(value);
      default:
        break;
    }
  }
  return is_plain_word(value) ? std::optional(std::string(value)) : std::nullopt;
}

std::optional<std::string> Quoter::code_for(std::string_view value) const {
  switch (language_) {
    case Language::cpp: {
      Quoter inside(language_);
      if (!result_.empty()) inside.result_ = result_.back();
      inside.add(value);
      const bool one_line = value.find_first_of("\n\r") == std::string_view::npos;
      if (one_line && inside.where_ == Where::code) return std::string(value);
      return std::nullopt;
    }
    case Language::cmake:
      return cmake_argument(value);
    case Language::shell:
      return shell_word(value);
    case Language::json:
      if (is_number(value) || value == "true" || value == "false") return std::string(value);
      return std::nullopt;
    case Language::other:
      return in_comment(value);
    default:
      return is_plain_word(value) ? std::optional(std::string(value)) : std::nullopt;
  }
}

bool Quoter::add_value(std::string_view value) {
  if (value.empty() && language_ != Language::cmake) return true;
  const auto text = where_ == Where::code ? code_for(value) : text_for(value);
  if (!text) return false;
  if (where_ == Where::code)
    add(*text);
  else
    result_ += *text;
  return true;
}

}  // namespace eagerx::gen

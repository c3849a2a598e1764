// Lines of generated C++, character by character.
#pragma once

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string_view>

namespace eagerx::gen {

inline constexpr std::size_t kColumns = 100;
inline constexpr std::size_t kNone = std::string_view::npos;

/// In letters: names in comments may have any.
inline std::size_t columns_of(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U;
  }));
}

/// Scans code: tracks open brackets and literals.
class Scanner {
 public:
  explicit Scanner(std::string_view line) : line_(line) {}

  /// Takes the next character; false at the end.
  bool next() {
    if (at_ + 1 >= line_.size() && started_) return false;
    if (started_) ++at_;
    started_ = true;
    if (at_ >= line_.size()) return false;
    const char c = line_[at_];
    if (quote_ != '\0') {
      if (c == '\\')
        ++at_;
      else if (c == quote_)
        quote_ = '\0';
      return true;
    }
    const char before = at_ > 0 ? line_[at_ - 1] : ' ';
    const bool digit_separator = std::isalnum(static_cast<unsigned char>(before)) != 0;
    if (c == '"' || (c == '\'' && !digit_separator)) quote_ = c;
    if (c == '(' || c == '[' || c == '{' || opens_template(c, before)) ++depth_;
    if (c == ')' || c == ']' || c == '}' || (c == '>' && before != '-' && before != ' ')) --depth_;
    return true;
  }
  [[nodiscard]] std::size_t at() const { return at_; }
  [[nodiscard]] int depth() const { return depth_; }
  [[nodiscard]] bool in_literal() const { return quote_ != '\0'; }

 private:
  static bool opens_template(char c, char before) {
    return c == '<' && (std::isalnum(static_cast<unsigned char>(before)) != 0 || before == '_');
  }

  std::string_view line_;
  std::size_t at_ = 0;
  int depth_ = 0;
  char quote_ = '\0';
  bool started_ = false;
};

/// Start of the comment after code, including the blanks before it.
inline std::size_t find_comment(std::string_view line) {
  if (line.find("  // ") == kNone) return kNone;  // most lines, without a scan
  for (Scanner scan(line); scan.next();) {
    if (!scan.in_literal() && line.substr(scan.at()).starts_with("  // ")) return scan.at();
  }
  return kNone;
}

}  // namespace eagerx::gen

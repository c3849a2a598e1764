#include "generator/frontend/read/wide_space.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "generator/support/diagnostics/utf8.hpp"

namespace eagerx::gen {
namespace {

/// Unicode's space separators but U+0020, and those without width.
bool is_wide_space(char32_t c) {
  return c == 0xa0 || c == 0x1680 || (c >= 0x2000 && c <= 0x200b) || c == 0x202f || c == 0x205f ||
         c == 0x3000 || c == 0xfeff;
}

/// Follows a text as far as needed to know what stands before a character.
class Scanner {
 public:
  /// Whether a space belongs here: at the beginning of a line, behind a key, within brackets.
  [[nodiscard]] bool separates() const {
    if (quote_ != '\0' || comment_) return false;
    return line_begins_ || after_key_ || (depth_ > 0 && after_mark_);
  }
  void take(char c) {
    if (c == '\n') {
      line_begins_ = true;
      comment_ = keyed_ = after_key_ = after_mark_ = false;
      before_ = c;
      return;
    }
    if (!comment_) take_in_line(c);
    before_ = c;
  }

 private:
  void take_in_line(char c) {
    const bool blank = c == ' ';
    if (quote_ != '\0') {
      if (c == quote_) quote_ = '\0';
    } else if (c == '#' && (before_ == ' ' || before_ == '\n')) {
      comment_ = true;
    } else if ((c == '"' || c == '\'') &&
               (after_mark_ || after_key_ || line_begins_ || before_ == ' ')) {
      quote_ = c;
    } else if (c == '{' || c == '[') {
      ++depth_;
    } else if ((c == '}' || c == ']') && depth_ > 0) {
      --depth_;
    }
    after_key_ = (c == ':' && !keyed_) || (blank && after_key_);
    keyed_ = keyed_ || c == ':';
    after_mark_ = c == '{' || c == '[' || c == ',' || c == ':' || (blank && after_mark_);
    line_begins_ = line_begins_ && (blank || c == '-');
  }

  char quote_ = '\0', before_ = '\n';
  std::size_t depth_ = 0;
  bool line_begins_ = true, comment_ = false;
  bool keyed_ = false;  // the line has a key already: further colons are text
  bool after_key_ = false, after_mark_ = false;
};

}  // namespace

bool check_wide_spaces(const Locator& locator, Diagnostics& diagnostics) {
  const std::string_view text = locator.text();
  Scanner scanner;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool ascii = static_cast<unsigned char>(text[at]) < 0x80;
    if (ascii) {
      scanner.take(text[at]);
      continue;
    }
    const auto decoded = decode_utf8(text, at);
    const char32_t code = decoded.value;
    const std::size_t size = decoded.size;
    if (is_wide_space(code) && scanner.separates()) {
      auto& problem =
          diagnostics.error("E0105", locator.span({at, at + size}),
                            fmt::format("{} (U+{:04X}) is not a separator in YAML",
                                        code == 0xa0 ? "a no-break space" : "this space",
                                        static_cast<std::uint32_t>(code)));
      problem.help = "replace it with a plain space";
      return false;
    }
    scanner.take('x');
    at += size - 1;
  }
  return true;
}

}  // namespace eagerx::gen

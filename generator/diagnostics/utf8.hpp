// UTF-8 by hand: code points, and how wide a terminal draws them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace eagerx::gen {

/// One code point taken from a text. Malformed bytes come out one at a time, as U+FFFD, not valid.
struct CodePoint {
  char32_t value = 0;
  std::size_t size = 1;  // bytes
  bool valid = true;
};

/// The code point that starts at byte `at` (at < text.size()). Strict: no overlong forms, no
/// surrogates, nothing past U+10FFFF (Unicode 15, table 3-7).
CodePoint decode_utf8(std::string_view text, std::size_t at);

/// Number of code points; a malformed byte counts as one.
std::size_t count_code_points(std::string_view text);

/// Columns on a terminal: 0 (combining), 1 or 2 (East Asian wide, emoji).
std::size_t display_width(char32_t code_point);

/// Whether printing it would do something other than draw it: control characters, malformed text,
/// and the marks that change the direction of writing (they can make a line read as another one).
bool is_unprintable(char32_t code_point);

/// `text` safe to print on a terminal: unprintable characters as `\n`, `\t`, `\x1b`, `\u202e`, …
std::string escape_unprintable(std::string_view text);

}  // namespace eagerx::gen

// Code points of UTF-8, and how wide a terminal draws them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <runtime/host/base/utf8.hpp>
#include <string>
#include <string_view>

namespace eagerx::gen {

using host::CodePoint;
using host::decode_utf8;

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

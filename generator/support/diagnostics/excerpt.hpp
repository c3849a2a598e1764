// The line of a file that a message shows, made safe for a terminal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace eagerx::gen {

/// A line as displayed, and the positions of its carets (in terminal columns from 0).
struct Excerpt {
  std::string text;
  std::size_t caret_column = 0;
  std::size_t caret_width = 1;
};

/// Tabs become four spaces, unprintable characters U+FFFD; a line wider than a terminal is cut with
/// `…` so that the span stays in sight. `column` (from 1) and `length` count code points.
Excerpt make_excerpt(std::string_view line, std::uint32_t column, std::uint32_t length);

}  // namespace eagerx::gen

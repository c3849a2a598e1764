// Passes over lines of generated C++, as clang-format formats them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace eagerx::gen {

/// Appends the lines of includes and blanks from `begin` on, sorted, without those that `text` does
/// not need; returns their end. C includes stay unchanged, and nothing is appended: some systems
/// need their order.
std::size_t sort_includes(std::string_view text, std::size_t begin, std::string& result);

/// Aligns the comments after code in consecutive lines.
std::string with_aligned_comments(std::string_view text);

/// Functions of a class with one short statement, or none, are one line. (Of templates only those
/// with none: clang-format 14 leaves the others.)
std::string with_short_functions(std::string_view text);

}  // namespace eagerx::gen

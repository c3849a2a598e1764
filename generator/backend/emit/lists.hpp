// Lists in columns, as clang-format 14 lays out lists that are too long for a line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace eagerx::gen {

/// An initializer or a call: the text before its bracket, its elements, and the text after it.
struct Braces {
  std::string_view head, tail;  // with the brackets
  std::vector<std::string_view> elements;

  [[nodiscard]] bool is_designated() const {
    return !elements.empty() && elements.front().starts_with('.');
  }
};

/// Whether clang-format writes the list in columns: not a short one, nor one within another unless
/// it is long.
bool has_columns(const Braces& braces);
/// A list in columns, starting at column `indent` after its brace or, if that takes fewer lines,
/// below it at column `deeper`.
std::string wrapped_list(const Braces& braces, std::size_t indent, std::size_t deeper);

}  // namespace eagerx::gen

// Breaks initializers and calls of generated C++ between their elements.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "generator/backend/emit/lists.hpp"

namespace eagerx::gen {

/// The elements of what opens with the bracket at `brace`; none if it is not closed here.
std::optional<Braces> braces_at(std::string_view line, std::size_t brace);
/// Whether each element fits in a line from column `indent` on.
bool all_fit(const Braces& braces, std::size_t indent);
/// Elements in lines from column `indent` on: one a line, or as many as fit. Empty if one does not
/// fit.
std::string in_lines(const Braces& braces, std::size_t indent, bool one_a_line);
/// An initializer that is too long, as clang-format breaks it: aligned behind its brace, or, where
/// that is too narrow, below.
std::string wrapped_braces(const Braces& braces, std::size_t indent, std::size_t deeper);

}  // namespace eagerx::gen

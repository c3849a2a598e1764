// Breaks lines of generated C++ as a person would.
#pragma once

#include <string>
#include <string_view>

namespace eagerx::gen {

/// `text` with lines of at most 100 columns where they can be broken: comments between words, code
/// where the fewest brackets are open. Literals, preprocessor
/// lines and what is between `clang-format off` and `on` stay as they are.
std::string wrapped(std::string_view text);

}  // namespace eagerx::gen

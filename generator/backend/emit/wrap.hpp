// Breaks lines of generated C++ as a person would.
#pragma once

#include <string>
#include <string_view>

namespace eagerx::gen {

/// `text` with lines of at most 100 columns if possible: breaks comments between words, and code
/// where the fewest brackets are open. Literals, preprocessor lines and text between `clang-format
/// off` and `on` are unchanged.
std::string wrapped(std::string_view text);

}  // namespace eagerx::gen

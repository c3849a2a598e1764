// Characters of names, and keys in incomplete text.
#pragma once

#include <cctype>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>

#include "generator/frontend/outline/outline.hpp"

namespace eagerx::gen {

inline bool is_letter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// The text of the scalar at `key`; empty if there is none.
inline std::string text_at(const OutlineNode& map, std::string_view key) {
  const OutlineNode* const value = map.find(key);
  return value != nullptr ? value->text : std::string();
}

/// The first `count` steps of a path.
inline OutlinePath beginning_of(const OutlinePath& path, std::size_t count) {
  return {path.begin(), std::next(path.begin(), static_cast<std::ptrdiff_t>(count))};
}

}  // namespace eagerx::gen

// Text to insert, in the style of the lines around it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/frontend/outline/splice.hpp"

namespace eagerx::gen {

/// The entries around a byte, from the outside in; the last one is the smallest.
std::vector<const OutlineEntry*> entries_around(const OutlineNode& top, std::size_t at);

/// End of the value of `owner`: after its last character.
std::size_t end_of(std::string_view text, const OutlineEntry& owner);

/// Adds `key: value` after the last key of the map that is the value of `owner` (an item or a key),
/// in braces or on a separate line. nullopt if the value is not a map.
std::optional<Splice> with_key(std::string_view text, const OutlineEntry& owner,
                               const std::string& key, const std::string& value);

/// Adds an item after the last one of the list that is the value of `owner`.
std::optional<Splice> with_item(std::string_view text, const OutlineEntry& owner,
                                const std::string& item);

/// Adds a top-level key of the graph; `value` may have several lines, indented by two.
Splice with_section(std::string_view text, const std::string& key, const std::string& value);

}  // namespace eagerx::gen

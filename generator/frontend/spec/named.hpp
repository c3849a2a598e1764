// Finds elements by name. Names are strings, with or without a place.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {

/// Projection of algorithms: `ranges::find(states, "x", name_of)`.
struct NameOf {
  template <class Named>
  const std::string& operator()(const Named& named) const {
    if constexpr (requires { named.name.value; }) {
      return named.name.value;
    } else {
      return named.name;
    }
  }
};
inline constexpr NameOf name_of;

/// The element of this name, or nullptr.
template <class Range>
auto* find_named(Range& range, std::string_view name) {
  const auto found = ranges::find(range, name, name_of);
  return found == std::ranges::end(range) ? nullptr : &*found;
}

/// The names in their order.
template <class Range>
std::vector<std::string> names_of(const Range& range) {
  std::vector<std::string> names;
  names.reserve(range.size());
  for (const auto& named : range) names.push_back(name_of(named));
  return names;
}

inline bool contains(const std::vector<std::string>& texts, std::string_view text) {
  return ranges::contains(texts, text);
}

}  // namespace eagerx::gen

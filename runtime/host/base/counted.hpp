// Counts in texts: "1 node", "2 nodes".
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace eagerx::host {

/// The word for a count: `one`, or `many`, by default `one` with an s.
inline std::string noun(std::uint64_t count, std::string_view one, std::string_view many = {}) {
  if (count == 1) return std::string(one);
  return many.empty() ? std::string(one) + "s" : std::string(many);
}

/// "1 node", "2 nodes"
inline std::string counted(std::uint64_t count, std::string_view one, std::string_view many = {}) {
  return std::to_string(count) + " " + noun(count, one, many);
}

}  // namespace eagerx::host

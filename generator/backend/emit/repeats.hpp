// Consecutive chains of nodes that differ only in their connections become one loop.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "generator/graph/plan/plan.hpp"
#include "generator/graph/resolve/needs.hpp"

namespace eagerx::gen {

/// `nodes` has `count` times as many nodes as a chain, chain by chain, as they run.
struct Repeat {
  std::size_t count = 0;
  std::vector<std::size_t> nodes;
  [[nodiscard]] std::size_t length() const { return nodes.size() / count; }
};

struct Repeats {
  std::vector<Repeat> all;
  /// Rings that are one array, one of each chain. Each ring is in one of these at most.
  std::vector<std::vector<std::size_t>> arrays;
};

/// Twelve equal joints share one function. `owners`: by node, the first one with the same Io.
/// Excludes nodes of engines, and nodes with processors, delays, their own resets or a link.
Repeats find_repeats(const Plan& plan, Part part, const std::vector<std::size_t>& owners);

}  // namespace eagerx::gen

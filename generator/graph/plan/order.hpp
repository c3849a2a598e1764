// Data-flow order of the whole graph: SEMANTICS §5.
#pragma once

#include <vector>

#include "generator/graph/resolve/graph.hpp"

namespace eagerx::gen {

/// Every node but the environment, once: those that do not need the action of the same instant,
/// then those that do. The graph has no cycle.
struct Order {
  std::vector<std::size_t> before, after;
};

/// `rate_of[node]`: index of its rate. The order does not depend on the order of the file.
Order order_nodes(const Graph& graph, const std::vector<std::size_t>& rate_of);

}  // namespace eagerx::gen

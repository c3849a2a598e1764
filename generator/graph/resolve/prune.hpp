// Finds the engine nodes of an object that are needed.
#pragma once

#include <cstddef>
#include <vector>

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

/// From one engine node of an object to another, by their indices.
struct InnerLink {
  std::size_t from, to;
};

/// For each of `nodes`, whether it is needed. EAGERx's rule: the nodes of used `sensors`, the nodes
/// that used `actuators` feed, descendants of the latter that are synchronized with the engine, and
/// the ancestors of all these.
std::vector<bool> needed_engine_nodes(const std::vector<UnresolvedNode>& nodes,
                                      const std::vector<InnerLink>& links,
                                      const std::vector<std::size_t>& sensors,
                                      const std::vector<std::size_t>& actuators);

}  // namespace eagerx::gen

// Nodes of equal structure share one Io struct.
#pragma once

#include <vector>

#include "generator/graph/plan/plan.hpp"
#include "generator/graph/resolve/needs.hpp"

namespace eagerx::gen {

/// Whether a program has an Io struct for this node: where it runs, and in both programs of a split
/// graph where they know when its reset is done.
bool has_io(const Graph& graph, Part part, std::size_t node);

/// By node: the first one with an Io struct like its own.
std::vector<std::size_t> io_owners(const Plan& plan, Part part);

}  // namespace eagerx::gen

// Units of messages, as manifests say them.
#pragma once

#include <string>

#include "generator/graph/resolve/graph.hpp"

namespace eagerx::gen {

/// "rad/s"; empty where the manifest has none, and where a processor gives something else.
std::string unit_of(const Graph& graph, const GraphNode& node, const Output& output);

}  // namespace eagerx::gen

// Cuts some nodes out of a graph as a separate graph, for a main loop that supplies their
// measurements.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/frontend/compose/port_bindings.hpp"
#include "generator/graph/resolve/graph.hpp"

namespace eagerx::gen {

struct CutRequest {
  std::vector<std::string> names;    // of nodes, composites, arrays; `leg[*]/knee` too
  PortBindings composites;           // of the graph
  std::optional<SafetySpec> safety;  // of the graph: its names are those of ports at the cut
};

/// The nodes of `whole` that the names call. What they take from others become actions, what others
/// take from them observations: with the names of a composite's ports, else of the port that sends.
/// Rates, windows, delays, states and processors stay; a step is the longest time that all ticks of
/// ports are multiples of. An action whose messages come less often than that goes through a node
/// of its rate. `whole` must be resolved with success. Problems: E0307 an unknown name, E0397 what
/// cannot be cut out, E0398 nodes outside that a step would need in its middle, E0399 nothing that
/// leaves, and those of read_safe_outputs(); W0117 a step that no port has the rate of.
std::optional<Graph> cut_out(const Graph& whole, const CutRequest& request,
                             Diagnostics& diagnostics);

}  // namespace eagerx::gen

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

/// Cuts out the named nodes of `whole`. Messages from other nodes become actions, and messages to
/// other nodes observations, named like the ports of a composite, or else like the sending port.
/// Rates, windows, delays, states and processors stay; a step is the greatest common divisor of the
/// ports' periods. An action with a lower rate passes through a node of its rate. `whole` must be
/// resolved without errors. Problems: E0307 an unknown name, E0397 nodes that cannot be cut out,
/// E0398 outside nodes that a step would need halfway, E0399 no outputs, and those of
/// read_safe_outputs(); W0117 no port has the rate of the step.
std::optional<Graph> cut_out(const Graph& whole, const CutRequest& request,
                             Diagnostics& diagnostics);

}  // namespace eagerx::gen

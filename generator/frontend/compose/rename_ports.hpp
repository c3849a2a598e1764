// Keys of a graph, other than connections, that name ports and nodes.
#pragma once

#include "generator/frontend/compose/port_bindings.hpp"
#include "generator/frontend/compose/port_pattern.hpp"

namespace eagerx::gen {

/// `task:`, `render:`, `budget:`, `safety:`, `telemetry:` and `like:` of a graph whose nodes and
/// connections are flat: ports of composites become those inside. Problems: those of
/// indexed_ports().
void rename_ports(YamlValue& root, const PortBindings& ends, const CountOf& count_of,
                  Diagnostics& diagnostics);

}  // namespace eagerx::gen

// Conditions of manifests on parameters, ports and rates.
#pragma once

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

/// Checks the conditions of manifests on parameters, ports and rates (E0328).
void check_limits(UnresolvedGraph& draft);
/// The same of a processor and those before it; false if there was a problem.
bool check_limits(const Processor& processor, Diagnostics& diagnostics);

}  // namespace eagerx::gen

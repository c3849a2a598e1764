// Safe values of actions and actuators, and when they are applied.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

/// The values of `$(safety KEY)` in manifests.
References safety_references(const GraphSpec& spec);
/// Adds the values of `$(safe ACTUATOR)` in the implementation of `object` to its `references`: the
/// value in `safety:`, otherwise that of the connected action, otherwise zero moved into its space.
/// Problems: E0307, E0327.
void add_safe_actuators(UnresolvedGraph& draft, const EntitySpec& object, const Entity& entity,
                        References& references);
void resolve_safety(UnresolvedGraph& draft);  // safe actions, in the spaces of the actions
/// Names in `settings` that are not among those of a graph. `what` they are: "action" (E0307).
void report_unknown_names(const std::vector<Setting>& settings,
                          const std::vector<std::string>& known, std::string_view what,
                          const char* otherwise, Diagnostics& diagnostics);

}  // namespace eagerx::gen

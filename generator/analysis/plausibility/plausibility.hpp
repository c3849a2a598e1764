// Checks for valid graphs that are probably not what the author meant: warnings, and errors for
// graphs that cannot work.
#pragma once

#include <vector>

#include "generator/graph/plan/plan.hpp"

namespace eagerx::gen {

/// The subject of the checks: the graph as it was written, resolved and planned, for these targets.
struct CheckedGraph {
  const GraphSpec& spec;
  const Graph& graph;
  const Plan& plan;
  const std::vector<const Target*>& targets;
};

/// W0101 an action wider than its actuator, W0102 units that differ, W0103 an actuator that nothing
/// drives, W0104 an output that reaches nothing, W0105 a port that is connected but not listed,
/// W0106 a sensor faster than the engine, W0107 an observation of a policy without bounds, W0109 a
/// key that does nothing in this graph, W0110 a part of a task without effect, W0111 an output
/// without a safe value, W0112 nodes without an engine that are faster than a step, W0113 a state
/// that continues from one episode to the next, W0114 a long delay without a unit, W0115 an unusual
/// rate, W0118 a file of actions that does not exist; E0421 a budget for a node that does not
/// exist, E0423 buffers that do not fit into the RAM.
void check_plausibility(const CheckedGraph& checked, Diagnostics& diagnostics);

/// Removes the warnings whose codes are in `allow:`. Reports W0108 for a code that removes nothing.
/// `complete`: whether all warnings of the graph have been collected, so that a missing one does
/// not occur.
void allow_warnings(const std::vector<Spanned<std::string>>& allowed, bool complete,
                    Diagnostics& diagnostics);

// The parts of check_plausibility().
void check_actions(const CheckedGraph& checked, Diagnostics& diagnostics);
void check_units(const CheckedGraph& checked, Diagnostics& diagnostics);
void check_wiring(const CheckedGraph& checked, Diagnostics& diagnostics);
void check_sensors(const CheckedGraph& checked, Diagnostics& diagnostics);
void check_memory(const CheckedGraph& checked, Diagnostics& diagnostics);
void check_keys(const CheckedGraph& checked, Diagnostics& diagnostics);
void check_outputs(const CheckedGraph& checked, Diagnostics& diagnostics);
/// W0111, also of nodes that were cut out.
void check_safe_outputs(const Graph& graph, Diagnostics& diagnostics);
void check_task(const Graph& graph, Diagnostics& diagnostics);
void check_numbers(const CheckedGraph& checked, Diagnostics& diagnostics);
void check_steps(const CheckedGraph& checked, Diagnostics& diagnostics);
void check_kept_states(const CheckedGraph& checked, Diagnostics& diagnostics);
void check_files(const CheckedGraph& checked, Diagnostics& diagnostics);

}  // namespace eagerx::gen

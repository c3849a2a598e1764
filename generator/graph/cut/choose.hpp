// Chooses the nodes to cut out, and describes them.
#pragma once

#include <string>
#include <vector>

#include "generator/graph/cut/cut.hpp"

namespace eagerx::gen {

/// The names as the graph spells them, with a note of each that is spelled otherwise.
std::vector<std::string> spelled_names(const Graph& whole, const std::vector<std::string>& names,
                                       Diagnostics& diagnostics);
/// Flags by node of `whole`, including the nodes that gather elements of messages among the chosen
/// ones. Empty after a problem: E0307, E0397.
std::vector<bool> choose_nodes(const Graph& whole, const std::vector<std::string>& names,
                               Diagnostics& diagnostics);
/// Whether each step can have its actions before it begins. False: E0398.
bool check_order(const Graph& whole, const std::vector<bool>& inside, Diagnostics& diagnostics);

}  // namespace eagerx::gen

// Compares two graphs by meaning: nodes, connections, rates, spaces, ages. Order, layout and file
// names do not matter, nor does it matter whether a value is written or a default.
#pragma once

#include <map>
#include <string>

#include "generator/analysis/info/info.hpp"

namespace eagerx::gen {

/// The facts of a graph, by their path: "nodes.smooth.rate" → "30".
using GraphFacts = std::map<std::string, std::string>;
GraphFacts facts_of(const PlanInfo& report);

/// A line for each difference: `-` if only the first graph has it, `+` if only the second, `~` if
/// both have it with different values. One line for an entity that only one has. Empty if there are
/// no differences.
std::string differences(const GraphFacts& first, const GraphFacts& second);

}  // namespace eagerx::gen

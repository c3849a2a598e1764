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

/// A line for each difference: `-` only the first has it, `+` only the second, `~` both, but
/// another value. Of an entity that only one has, one line. Empty if there is none.
std::string differences(const GraphFacts& first, const GraphFacts& second);

}  // namespace eagerx::gen

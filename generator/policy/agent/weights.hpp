// The weights that a graph names.
#pragma once

#include <optional>
#include <string>

#include "generator/frontend/spec/graph_spec.hpp"
#include "generator/policy/network/network.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// The weights that `policy` names, with the known answers that every program checks; paths are
/// relative to the folder of `graph_file`. Problems: those of the formats (E06xx), E0206 and E0709:
/// weights of eight bits are farther off than the graph allows.
std::optional<Network> read_weights(const AgentSpec& policy, const std::string& graph_file,
                                    Diagnostics& diagnostics);

}  // namespace eagerx::gen

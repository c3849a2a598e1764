// Command lines as shown to users.
#pragma once

#include <string>

#include "generator/driver/pipeline/options.hpp"

namespace eagerx::gen {

/// "eagerx-gen run GRAPH …" with the graph, policy, variant, engine, rates and libraries of
/// `options`; `command` replaces `run`.
std::string command_on_graph(const GraphOptions& options, const char* command = "run");

}  // namespace eagerx::gen

// Arguments that several commands of eagerx-gen take.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "generator/cli/commands.hpp"
#include "generator/command_line/command_line.hpp"

namespace eagerx::gen {

using Arguments = std::vector<Argument>;

Arguments joined(std::initializer_list<Arguments> parts);

Argument graph(Options& options);
/// Variant, engine, scalar, targets and split, as against what the graph says.
Arguments selection(Options& options);
Argument agent_policy(Options& options);
/// Nodes that are cut out of the graph, as a library.
Argument cut_out_nodes(Options& options, std::string about);
Argument variant(Options& options);
Arguments rates(Options& options);
/// Folders of the user's own entities.
Argument library(Options& options);
Arguments diagnostics(Options& options);
Argument warnings(Options& options);

/// An option that the program which is started understands.
Argument handed_on(const std::string& name, std::string about, std::string type, Options& options);
/// What making a library of environments takes.
Arguments on_environments(Options& options);

}  // namespace eagerx::gen

// What the entities of a graph need besides the runtime.
#pragma once

#include <string>
#include <vector>

#include "generator/resolve/graph.hpp"

namespace eagerx::gen {

/// pkg-config's names of the libraries, sorted, each once.
std::vector<std::string> packages_of(const Graph& graph);

/// Reports every entity that needs another operating system or family of boards than the target's:
/// E0330.
void check_system(const Graph& graph, const Target& target, const Library& library,
                  Diagnostics& diagnostics);

}  // namespace eagerx::gen

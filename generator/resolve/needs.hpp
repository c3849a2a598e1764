// What the entities of a graph need besides the runtime.
#pragma once

#include <string>
#include <vector>

#include "generator/resolve/graph.hpp"

namespace eagerx::gen {

/// The whole program of a graph, or one of its two when parts are placed on a board.
enum class Part : std::uint8_t { whole, host, board };

/// Whether this node's callback is called in this program; the environment's: whether it decides.
bool runs_here(const Graph& graph, Part part, std::size_t node);
/// Whether this node's inputs are received in this program: the host has all observations.
bool receives_here(const Graph& graph, Part part, std::size_t node);

/// pkg-config's names of the libraries, sorted, each once.
std::vector<std::string> packages_of(const Graph& graph, Part part);

/// Reports every entity of this program that needs another operating system or family of boards
/// than the target's: E0330.
void check_system(const Graph& graph, Part part, const Target& target, const Library& library,
                  Diagnostics& diagnostics);

}  // namespace eagerx::gen

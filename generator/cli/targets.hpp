// The targets that a graph is made for, and whether it can be.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "generator/cli/pipeline.hpp"

namespace eagerx::gen {

/// "1 node", "2 nodes"
std::string counted(std::uint64_t count, std::string_view what);

/// Those of the command line. Problems: E0316 unknown, E0335, E0337, E0341 and those of
/// check_system() where the graph cannot run, E0340 what nobody has filled in yet.
std::vector<const Target*> find_targets(Run& run, const GraphOptions& options);

}  // namespace eagerx::gen

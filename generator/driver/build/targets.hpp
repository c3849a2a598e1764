// The targets of a graph, and whether it can run on them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "generator/driver/pipeline/pipeline.hpp"

namespace eagerx::gen {

std::uint64_t warnings_in(const Diagnostics& diagnostics);

/// The folder for these targets, this variant, engine and policy: "pendulum-mps2-an386-light" of
/// "pendulum", so that alternating commands do not overwrite each other's output or rebuild it.
std::string folder_for_options(std::string folder, const GraphOptions& options);

/// Those of the command line. Problems: E0316 unknown, E0335, E0337, E0341 and those of
/// check_system() where the graph cannot run, E0340 blanks that are not filled in.
std::vector<const Target*> find_targets(Run& run, const GraphOptions& options);

}  // namespace eagerx::gen

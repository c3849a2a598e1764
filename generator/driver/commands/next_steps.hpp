// Commands to type after a program was generated.
#pragma once

#include <string>
#include <vector>

#include "generator/driver/pipeline/pipeline.hpp"

namespace eagerx::gen {

/// Commands that build and start each program in `folder`, with its target's compiler and as its
/// manifest says; for a split graph, also the traffic of the link. Lines for a terminal.
std::string next_steps(const Run& run, const GenerateOptions& options,
                       const std::vector<const Target*>& targets, const std::string& folder);

}  // namespace eagerx::gen

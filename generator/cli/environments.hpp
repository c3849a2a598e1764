// Programs that work on the environments of a graph: eagerx-train, eagerx-campaign.
#pragma once

#include <string>
#include <vector>

#include "generator/cli/commands.hpp"

namespace eagerx::gen {

/// Makes the graph's library of environments, and becomes `program` with it and with `words`. They
/// are checked first, before minutes of compiling.
int become_with_environments(const char* program, const Options& options,
                             std::vector<std::string> words);

}  // namespace eagerx::gen

// Programs that work on the environments of a graph: eagerx-train, eagerx-campaign.
#pragma once

#include <string>
#include <vector>

#include "generator/cli/commands.hpp"

namespace eagerx::gen {

/// Programs beside eagerx-gen that work on a library of environments.
struct Helper {
  const char* program;
  const char* checker;  // looks at the options with --check, before anything is built
};

/// Makes the graph's library of environments, and becomes `program` with it and with `words`. They
/// are checked first, before minutes of compiling.
int become_with_environments(const Helper& helper, const Options& options,
                             std::vector<std::string> words);

}  // namespace eagerx::gen

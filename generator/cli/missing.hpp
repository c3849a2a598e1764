// eagerx-gen import --missing
#pragma once

#include "generator/cli/pipeline.hpp"

namespace eagerx::gen {

/// Lists the classes of a file of EAGERx that have no counterpart, and makes a folder for each.
int missing_command(Run& run, const YamlValue& tree, const Options& options);

}  // namespace eagerx::gen

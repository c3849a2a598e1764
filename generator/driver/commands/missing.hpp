// eagerx-gen import --missing
#pragma once

#include <string>

#include "generator/driver/pipeline/pipeline.hpp"

namespace eagerx::gen {

/// Lists the classes of a file of EAGERx that have no counterpart, and makes a folder for each in
/// `output`, if it is not empty. Returns the exit code.
int list_missing(Run& run, const YamlValue& tree, const GraphOptions& options,
                 const std::string& output);

}  // namespace eagerx::gen

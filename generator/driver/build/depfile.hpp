// The sources of an output, for make and ninja.
#pragma once

#include "generator/driver/pipeline/pipeline.hpp"

namespace eagerx::gen {

/// Writes the file of `--depfile`, if there is one. Before the output: if it cannot be written, the
/// output stays as it was.
bool write_depfile(Run& run, const GenerateOptions& options);

}  // namespace eagerx::gen

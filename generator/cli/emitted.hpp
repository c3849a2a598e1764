// The text of a graph's program.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/cli/pipeline.hpp"
#include "generator/emit/emit.hpp"

namespace eagerx::gen {

/// For an output in the folder `output`, a whole path.
EmitOptions emit_options_for(const Run& run, std::vector<const Target*> targets,
                             std::string output);

/// The whole graph as one program, also where it is split.
std::optional<std::vector<GeneratedFile>> emit_whole(Run& run, const EmitOptions& options);

/// The program; of a split graph both, in the folders `host` and `board`.
std::optional<std::vector<GeneratedFile>> emit_program(Run& run, const EmitOptions& options);

}  // namespace eagerx::gen

// The text of a graph's program.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/backend/emit/emit.hpp"
#include "generator/driver/pipeline/pipeline.hpp"

namespace eagerx::gen {

/// For an output in the folder `output`, a whole path.
EmitOptions emit_options_for(const Run& run, std::vector<const Target*> targets,
                             std::string output);

/// The whole graph as one program, also where it is placed.
std::optional<std::vector<GeneratedFile>> emit_whole(Run& run, const EmitOptions& options);

/// Of the hub of a placed graph, in its output. Each part has the folder of its name.
inline constexpr const char* kHubFolder = "host";

/// The program; of a placed graph all.
std::optional<std::vector<GeneratedFile>> emit_program(Run& run, const EmitOptions& options);

}  // namespace eagerx::gen

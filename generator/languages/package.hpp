// The program of a part in another language: the files that the manifest of its target lists.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/emit/emit.hpp"
#include "generator/languages/layout.hpp"

namespace eagerx::gen {

/// All files of part `part`, whose target has a language, and part.json. `hash`: of the graph.
/// Problems: E0350, E0501, E0901 a file of a node that cannot be read.
std::optional<std::vector<GeneratedFile>> emit_language(const Plan& plan, std::size_t part,
                                                        std::uint64_t hash,
                                                        const std::string& version,
                                                        Diagnostics& diagnostics);

}  // namespace eagerx::gen

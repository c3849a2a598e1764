// The program of a part in another language: the files that the manifest of its target lists.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/backend/emit/emit.hpp"
#include "generator/backend/languages/layout.hpp"

namespace eagerx::gen {

/// All files of part `part`, whose target has a language, and part.json, for a graph that
/// check_languages() has no problem with. `hash`: of the graph. Problems: E0301 a file of a node
/// that cannot be read, E0350 one that cannot be imported, E0501.
std::optional<std::vector<GeneratedFile>> emit_language(const Plan& plan, std::size_t part,
                                                        std::uint64_t hash,
                                                        const std::string& version,
                                                        Diagnostics& diagnostics);

}  // namespace eagerx::gen

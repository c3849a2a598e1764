#pragma once

#include <optional>
#include <string>

#include "generator/backend/program_map/program_map.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// The map next to the program.hpp that an image was built from. Problems: E0911.
std::optional<ProgramMap> map_of_program(const std::string& program, const std::string& image,
                                         Diagnostics& diagnostics);

}  // namespace eagerx::gen

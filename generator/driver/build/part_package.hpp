// `generate --part PART --package LANGUAGE`: one part of a placed graph for another language.
#pragma once

#include <string>
#include <vector>

#include "generator/backend/emit/emit.hpp"
#include "generator/driver/pipeline/pipeline.hpp"

namespace eagerx::gen {

/// Sets the language of the part in `options`, if they name one. False: E0307 an unknown part,
/// E0502 an unknown language, E0336 an option that conflicts with `--part`.
bool choose_language(Run& run, const GenerateOptions& options);

/// Leaves the files of one part, in the folder itself.
void keep_part(const std::string& part, std::vector<GeneratedFile>& files);

/// The commands that run it.
std::string next_steps_of_part(const Run& run, const std::string& part, const std::string& folder);

}  // namespace eagerx::gen

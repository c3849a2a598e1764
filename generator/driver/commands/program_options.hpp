// Options of a program that is run: a file next to its main loop lists them.
#pragma once

#include <string>
#include <vector>

#include "generator/driver/pipeline/pipeline.hpp"

namespace eagerx::gen {

/// Looks for the file by the templates of `target`: a main.cpp that includes
/// <targets/PLACE/app.hpp> has its options in targets/PLACE/options.yaml. E0516 for each option
/// that the program does not take, with the reason or the option that is meant, which may be one of
/// eagerx-gen; what it does without being asked is left out of `words`. Programs without such a
/// file check their options themselves.
bool check_program_options(Run& run, const Target& target, std::vector<std::string>& words);

}  // namespace eagerx::gen

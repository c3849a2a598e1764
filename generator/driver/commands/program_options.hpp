// Options of a program that is run: a file next to its main loop lists them.
#pragma once

#include <string>
#include <vector>

#include "generator/driver/pipeline/pipeline.hpp"

namespace eagerx::gen {

/// Looks for the file by the templates of `target`: a main.cpp that includes
/// <targets/PLACE/app.hpp> has its options in targets/PLACE/options.yaml. Reports E0516 for each
/// option that the program does not have, with the reason or the intended option, which may be one
/// of eagerx-gen. Removes options that have no effect on the program from `words`. Programs without
/// such a file check their options themselves.
bool check_program_options(Run& run, const Target& target, std::vector<std::string>& words);

}  // namespace eagerx::gen

// A CMake project for a library that is cut out of a graph, and for its program.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/backend/emit/emit.hpp"
#include "generator/driver/build/built.hpp"

namespace eagerx::gen {

/// Writes the project of `templates/KIND` into `folder`, whose folder `library` has the library of
/// `run`'s graph, with the files of `more`, and builds it for `target`: the program has the name
/// KIND. Nothing if there is a problem, which is in `run`.
std::optional<BuiltProgram> build_library_project(Run& run, const GenerateOptions& options,
                                                  const Target& target, const std::string& kind,
                                                  const std::string& folder,
                                                  std::vector<GeneratedFile> more = {});

}  // namespace eagerx::gen

// The time of an image: the bound of its cycles on its board, against the rates of its graph.
#pragma once

#include <optional>
#include <string>

#include "generator/analysis/fit/fit.hpp"
#include "generator/driver/build/built.hpp"

namespace eagerx::gen {

Machine machine_of(const Target& target);

/// The board that an image names, if the library has it; loads the library of a run without graph.
std::optional<Machine> machine_of_image(Run& run, const LibraryOptions& options,
                                        const std::string& image);

/// bound_instructions() with the names of the plan's rates, if there is a plan.
std::optional<BoundReport> bound_of_image(Run& run, const std::string& image,
                                          const Machine* machine);

/// The keys `time` and `slot` of the graph's `budget:`, of an image that was just built.
void check_built_time(Run& run, const BuiltProgram& program);

}  // namespace eagerx::gen

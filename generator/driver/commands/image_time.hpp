// The time of an image: the bound of its cycles on its board, against the rates of its graph.
#pragma once

#include <optional>
#include <string>
#include <vector>

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

/// What a page shows of an image of the graph: its bounds without those of functions, and with
/// `fit` whether they fit. nullopt: it has none, which is no problem of the page.
std::optional<Json> time_json(Run& run, const LibraryOptions& options, const std::string& image);

/// Says how much of their time the slots of images that were just built take at most.
void note_built_time(Run& run, const GraphOptions& options,
                     const std::vector<BuiltProgram>& programs);

/// The keys `time` and `slot` of the graph's `budget:`, of an image that was just built.
void check_built_time(Run& run, const BuiltProgram& program);

}  // namespace eagerx::gen

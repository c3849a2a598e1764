// Compares the bound of an image's cycles on its board with the rates of its graph.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/analysis/fit/fit.hpp"
#include "generator/analysis/fit/steps.hpp"
#include "generator/driver/build/built.hpp"

namespace eagerx::gen {

Machine machine_of(const Target& target);

/// The board that an image names, if the library has it; loads the library of a run without graph.
std::optional<Machine> machine_of_image(Run& run, const LibraryOptions& options,
                                        const std::string& image);

/// The bounds of an image, and the load of its graph's slots.
struct ImageTime {
  BoundReport bound;
  std::optional<StepBounds> steps;  // with a graph
  std::optional<Fit> fit;           // with a graph, on a board with cycles
};

/// `of_graph`: whether the image is of the run's plan; else it is bounded alone. Problems: as of
/// bound_instructions(), for which the result is nullopt or has less.
std::optional<ImageTime> time_of_image(Run& run, const LibraryOptions& options,
                                       const std::string& image, bool of_graph,
                                       Diagnostics& diagnostics);
/// Whether the graph has all nodes of an image: E0361.
bool check_image_nodes(const std::string& image, const std::vector<std::string>& nodes,
                       const Graph& graph, Diagnostics& diagnostics);

std::string time_text(const ImageTime& time);
Json time_json(const ImageTime& time, bool with_functions);

/// Says how much of their time the slots of images that were just built take at most.
void note_built_time(Run& run, const GraphOptions& options,
                     const std::vector<BuiltProgram>& programs);

/// The keys `time` and `slot` of the graph's `budget:`, of an image that was just built.
void check_built_time(Run& run, const BuiltProgram& program);

}  // namespace eagerx::gen

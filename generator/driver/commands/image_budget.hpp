// Checks an image against its graph's `budget:`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/analysis/size/size.hpp"
#include "generator/driver/build/built.hpp"
#include "generator/support/json/json.hpp"

namespace eagerx::gen {

struct MeasuredImage {
  const SizeReport& report;
  std::optional<Json> baseline;  // an earlier report: who grew
  std::string what;              // "the image"
  // Nodes and shared parts that may be in it, of a program that was just built: what has a budget
  // and lies elsewhere is left out, and so are instructions. Nothing: all have to be there.
  std::optional<std::vector<std::string>> parts;
};

/// The keys of `budget` that an image is needed for. Exceeded: E0420; E0421 a node that is not in
/// the image, E0422 instructions that were not counted.
void check_image_budget(const MeasuredImage& image, const BudgetSpec& budget,
                        Diagnostics& diagnostics);

/// Measures the programs for boards that were built and checks them. What is checked only by
/// `eagerx-gen size` is said on the standard error.
void check_built_budget(Run& run, const GraphOptions& options,
                        const std::vector<BuiltProgram>& programs);

/// An image with the library of `--of`, or the library alone, against the budget of its graph: of
/// the nodes those that the library has. It has no slots, so instructions are not checked, which is
/// said on the standard error.
void check_library_budget(Run& run, const GraphOptions& options, MeasuredImage image);

}  // namespace eagerx::gen

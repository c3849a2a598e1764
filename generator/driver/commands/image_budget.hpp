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
  // For a program that was just built: the nodes and shared parts that may be in the image. Budgets
  // of other nodes, and of instructions, are not checked. nullopt: the image must have all nodes.
  std::optional<std::vector<std::string>> parts;
};

/// The keys of `budget` that an image is needed for. Exceeded: E0420; E0421 a node that is not in
/// the image, E0422 instructions that were not counted.
void check_image_budget(const MeasuredImage& image, const BudgetSpec& budget,
                        Diagnostics& diagnostics);

/// Measures and checks the built programs for boards. Names limits that only `eagerx-gen size`
/// checks on the standard error.
void check_built_budget(Run& run, const GraphOptions& options,
                        const std::vector<BuiltProgram>& programs);

/// Checks an image with the library of `--of`, or the library alone, against the budget of its
/// graph, for the nodes in the library. A library has no slots, so instructions are not checked,
/// which is reported on the standard error.
void check_library_budget(Run& run, const GraphOptions& options, MeasuredImage image);

}  // namespace eagerx::gen

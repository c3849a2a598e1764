// Checks the stability margins of a graph's loops against its `budget:`.
#pragma once

#include "generator/driver/pipeline/pipeline.hpp"

namespace eagerx::gen {

/// The key `margin` of `budget:`, by `eagerx-gen-tools linearize` for each of its ports. Missed, or
/// not known: E0428. A graph on hardware has no plant to linearize, which is said on the standard
/// error.
void check_margin_budget(Run& run, const GraphOptions& options);

}  // namespace eagerx::gen

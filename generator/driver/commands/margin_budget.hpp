// Checks the stability margins of a graph's loops against its `budget:`.
#pragma once

#include "generator/driver/pipeline/pipeline.hpp"

namespace eagerx::gen {

/// Checks the key `margin` of `budget:` by `eagerx-gen-tools linearize` for each of its ports.
/// E0428 if a margin is missed or unknown. A graph on hardware has no plant to linearize, which is
/// reported on the standard error.
void check_margin_budget(Run& run, const GraphOptions& options);

}  // namespace eagerx::gen

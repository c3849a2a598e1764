// Checks the variants of a graph that were not chosen.
#pragma once

#include <cstddef>

#include "generator/driver/pipeline/pipeline.hpp"

namespace eagerx::gen {

/// Adds to `run`, which has checked the graph as written, problems in the form of its variants:
/// keys, names, kinds of values. The rest depends on the use of a variant: a board, or the library
/// of some nodes. Returns the number of variants.
std::size_t check_variants(Run& run, const GraphOptions& options);

}  // namespace eagerx::gen

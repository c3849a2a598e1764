// Checks the variants of a graph that were not chosen.
#pragma once

#include <cstddef>

#include "generator/driver/pipeline/pipeline.hpp"

namespace eagerx::gen {

/// Adds to `run`, which has checked the graph as it is written, what is wrong with the form of its
/// variants: keys, names, kinds of values. The rest depends on what a variant is for: a board, or
/// the library of some nodes. Returns how many there are.
std::size_t check_variants(Run& run, const GraphOptions& options);

}  // namespace eagerx::gen

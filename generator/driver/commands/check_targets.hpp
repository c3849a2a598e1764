// Problems of a graph that are not in its own text.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/driver/pipeline/pipeline.hpp"

namespace eagerx::gen {

/// The targets of a graph, after checking what is generated for them: with `--of`, the cut-out
/// nodes replace the graph. nullopt after a problem. `output`: a folder from which the headers of
/// entities must have a path that is valid in an include; empty: none.
std::optional<std::vector<const Target*>> check_targets(Run& run, const GraphOptions& options,
                                                        const std::string& output = {});

}  // namespace eagerx::gen

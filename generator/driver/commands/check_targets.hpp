// Problems of a graph that are not in its own text.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/driver/pipeline/pipeline.hpp"

namespace eagerx::gen {

/// The targets of a graph that was made, once there is what is generated for them: with `--of` the
/// nodes that are cut out are in its place. Nothing if there is a problem. `output`: a folder from
/// which the headers of entities must have a path that an include can have; empty: none.
std::optional<std::vector<const Target*>> check_targets(Run& run, const GraphOptions& options,
                                                        const std::string& output = {});

}  // namespace eagerx::gen

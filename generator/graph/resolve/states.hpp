// States of entities, and how they are sampled.
#pragma once

#include <optional>
#include <string>

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

void resolve_states(UnresolvedGraph& draft);  // how states are sampled
/// How `name` is sampled, checked against its space (E0322, E0327).
std::optional<Random> read_random(const std::string& name, const Space& space,
                                  const RandomSpec& spec, Diagnostics& diagnostics);

}  // namespace eagerx::gen

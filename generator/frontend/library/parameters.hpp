// Parameters of an entity, under `config:` of its manifest.
#pragma once

#include <vector>

#include "generator/frontend/library/library.hpp"

namespace eagerx::gen {

/// Of the manifest `root`. Problems: E0205, E0206, E0208.
std::vector<Parameter> read_parameters(const YamlValue& root, Diagnostics& diagnostics);
/// Tunable parameters are states that a graph need not name.
void add_tunable_states(Entity& entity);

}  // namespace eagerx::gen

// JSON schemas of graphs and manifests that know the entities of a library.
#pragma once

#include "generator/frontend/library/library.hpp"
#include "generator/support/json/json.hpp"

namespace eagerx::gen {

/// The schema of graphs in which `type:` is one of the entities, and ports, states and parameters
/// are those of the type.
Json graph_schema(const Library& library);

/// The schema of manifests, whose valid keys depend on `kind`.
Json manifest_schema();

}  // namespace eagerx::gen

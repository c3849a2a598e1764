// JSON schemas (draft-07) from the tables of graphs and manifests.
#pragma once

#include <string>

#include "generator/frontend/spec/format.hpp"
#include "generator/support/json/json.hpp"

namespace eagerx::gen {

/// The schema of values that `format` accepts.
Json schema_of(const Format& format);

/// The schema of graphs in which a graph with `extends:` may omit required keys: those of the
/// graph, of each of its sections, such as `engine` and `task`, and of each object and node.
Json with_extending(Json graph);

/// With the header of a separate file.
std::string schema_text(const Json& schema, const std::string& title, const std::string& id);

}  // namespace eagerx::gen

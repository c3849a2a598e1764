// Entities and targets as JSON: for the reference (toolchains/site) and other
// tools.
#pragma once

#include "generator/frontend/library/library.hpp"
#include "generator/support/json/json.hpp"

namespace eagerx::gen {

/// All that `info ENTITY` says, with the engine nodes and states that an object is made of. Numbers
/// are numbers, references are texts: `$(config size)`. Paths are relative to the folder of the
/// entity's library, so that they are the same on every machine.
Json entity_json(const Entity& entity);

Json target_json(const Target& target);

/// `{"entities": […], "targets": […]}`, by their ids.
Json library_json(const Library& library);

/// "node", "engine node", …; a node with targets is always a reset node.
std::string_view kind_of(const Entity& entity);

/// The type of a parameter as messages call it: "float", "choice", "object of".
std::string_view type_of(const Parameter& parameter);

}  // namespace eagerx::gen

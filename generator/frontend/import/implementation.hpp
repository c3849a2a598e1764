// Implementation of an object on the engine of a saved file, as the `engines:` of a manifest.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "generator/frontend/import/entity_mapping.hpp"

namespace eagerx::gen {

/// The inside of all objects of one class, from a flattened file.
struct SavedImplementation {
  std::vector<std::string> lines;  // below `ENGINE:` and behind the model, without indentation
  /// States of engine nodes that the object has to have, too: "name: {space: …}".
  std::vector<std::string> states;
  /// The engine's parameters for the object, "key: value".
  std::vector<std::string> parameters;

  [[nodiscard]] bool empty() const { return lines.empty() && parameters.empty(); }
};

/// Types of entities that are not written yet, by EAGERx's id.
using MadeTypes = std::map<std::string, std::string>;

/// The type of a manifest's parameter with this default; empty if a manifest cannot express it.
std::string type_of_parameter(const YamlValue& value);
/// The space as saved; bounds tell the length where EAGERx saved no shape.
std::optional<SpaceSpec> whole_space(const SavedPort& port);
/// Whether the manifest of a class that has to be written has this parameter.
bool is_parameter_of_manifest(const YamlValue::Entry& entry);

/// Empty: the file does not say it (Graph.save).
SavedImplementation saved_implementation(const SavedGraph& saved, const SavedEntity& object,
                                         EntityMapping& mapping, const MadeTypes& types);

}  // namespace eagerx::gen

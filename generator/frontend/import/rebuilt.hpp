// An object that replaces its engine nodes.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "generator/frontend/import/saved.hpp"
#include "generator/frontend/library/library.hpp"
#include "generator/frontend/spec/port_name.hpp"

namespace eagerx::gen {

/// One object: its engine nodes in the file, and those of our manifest that they are. Nodes are
/// called as in the manifest.
struct Rebuilt {
  SavedEntity object;
  const Entity* entity = nullptr;
  const ObjectEngine* implementation = nullptr;
  std::map<std::string, std::string> matches;  // engine node of the file → of the manifest

  /// The manifest's name for an engine node of the file, or "".
  [[nodiscard]] std::string match(const std::string& node) const;
  /// Sensors that this output becomes, those of the object's own selection first.
  [[nodiscard]] std::vector<std::string> sensors(const std::string& node,
                                                 const std::string& output) const;
  /// The connection of an actuator to this input, or nullptr.
  [[nodiscard]] const ConnectionSpec* actuator(const std::string& node,
                                               const std::string& input) const;
  /// The connection between two ports ("node.port"), or nullptr.
  [[nodiscard]] const ConnectionSpec* inside(const std::string& from, const std::string& to) const;
  /// Whether the engine node of a sensor or actuator is in the file; `section` is "sensors" or
  /// "actuators".
  [[nodiscard]] bool has_node_of(std::string_view section, const std::string& port) const;
};

}  // namespace eagerx::gen

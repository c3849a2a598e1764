// The file that EAGERx's Graph.save and BaseEnv.save write, typed but not yet in our words.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "generator/frontend/read/tree.hpp"
#include "generator/frontend/spec/graph_spec.hpp"
#include "generator/frontend/spec/reference.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// An input, output, sensor, actuator, state, target or feedthrough with its settings, in which
/// `$(config x)` is replaced.
struct SavedPort {
  Spanned<std::string> name;
  YamlValue settings;
  bool has_spaces_apart = false;  // of a missing class, whose users gave it different ones

  /// The setting, or nullptr if it is not there or null.
  [[nodiscard]] const YamlValue* find(std::string_view key) const;
};

/// Sections are "inputs", "outputs", "states", "sensors", "actuators", "targets", "feedthroughs".
struct SavedEntity {
  enum class Kind : std::uint8_t { environment, engine, node, object };
  Kind kind = Kind::node;
  Spanned<std::string> name;
  Spanned<std::string> id;  // module/Class
  YamlValue config;
  std::map<std::string, std::vector<SavedPort>, std::less<>> ports;  // selected or not
  std::map<std::string, std::vector<Spanned<std::string>>, std::less<>> selected;

  [[nodiscard]] const SavedPort* port(std::string_view section, std::string_view wanted) const;
  [[nodiscard]] bool is_selected(std::string_view section, std::string_view wanted) const;
  /// The parameter, or nullptr if it is not there or null.
  [[nodiscard]] const YamlValue* parameter(std::string_view key) const;
};

struct SavedEnd {
  std::string entity, section, port;
  Span span;
};

struct SavedLink {
  SavedEnd from, to;
};

/// The rest of an object in a flattened file: it has become engine nodes called object/….
struct SavedObject {
  Spanned<std::string> name;
  YamlValue parameters;  // of the engine for this object
  std::vector<Spanned<std::string>> states;
  std::vector<SavedPort> engine_states;  // with `state: {state_type, …}`
  std::vector<Spanned<std::string>> nodes;
};

struct SavedGraph {
  FileId file = FileId::none;
  std::vector<SavedEntity> entities;
  std::vector<SavedLink> links;
  std::vector<SavedEntity> backup;  // the objects as they were added
  /// "node.input" of nodes that were added with a processor.
  std::set<std::string> processors_when_added;
  std::vector<SavedObject> objects;     // flattened files
  std::optional<std::string> env_name;  // flattened files
  std::optional<Spanned<std::string>> engine_id;

  /// Objects that could not be put back, and their engine nodes.
  std::set<std::string> unplaced;

  [[nodiscard]] const SavedEntity* find(std::string_view name) const;
  /// The object that an engine node of a flattened file belongs to, or nullptr.
  [[nodiscard]] const SavedObject* owner_of(std::string_view node) const;
  [[nodiscard]] bool flattened() const;  // written by BaseEnv.save
};

/// Typed form of the tree; nullopt after E0802 (it does not have the form of such a file).
std::optional<SavedGraph> read_saved_graph(const YamlValue& root, Diagnostics& diagnostics);

/// The tree with Python's tuples, texts, numbers and numpy's scalars as plain YAML. Any other value
/// with a Python tag becomes a scalar for which is_python_object() is true.
YamlValue plain_values(const YamlValue& yaml);
bool is_python_object(const YamlValue& yaml);

/// The exact number that a double in the file represents; nullopt if it is not a number.
std::optional<Rational> meant_number(const YamlValue& yaml);

/// Our object instead of the engine nodes of each object, as Graph.save would have written it.
/// False: it could not be done (E0801, E0805); the engine nodes are gone all the same.
class EntityMapping;
bool rebuild_objects(SavedGraph& saved, EntityMapping& mapping, Diagnostics& diagnostics);

}  // namespace eagerx::gen

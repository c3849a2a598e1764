// The steps of import_graph().
#pragma once

#include <set>

#include "generator/frontend/import/entity_mapping.hpp"
#include "generator/frontend/import/import.hpp"

namespace eagerx::gen {

/// The context of a translation.
struct Translation {
  const SavedGraph& saved;
  EntityMapping& mapping;
  const ImportOptions& options;
  Diagnostics& diagnostics;
  ImportedGraph result;
  std::map<std::string, const Entity*> entities;             // by saved name; nullptr: reported
  std::map<std::string, std::string> names;                  // saved name → ours
  std::map<std::string, std::string> actions, observations;  // the same for the environment's

  [[nodiscard]] const Entity* entity(const std::string& name) const {
    const auto found = entities.find(name);
    return found == entities.end() ? nullptr : found->second;
  }
  /// How the object is made on the graph's engine, or nullptr.
  [[nodiscard]] const ObjectEngine* implementation(const Entity& object) const;
};

/// The pictures of a file, and which are left out.
struct Pictures {
  Span place;                  // of the first node; no line: the file has no pictures
  std::string object, sensor;  // what the first RenderNode showed in the end; empty: something else
  std::optional<Rational> rate_hz;
  std::vector<std::string> shown;     // what `render:` stands for, where that object can be drawn
  std::vector<std::string> left_out;  // what nothing stands for
};

/// The nodes that EAGERx ran in separate processes, by their names in the file.
struct Processes {
  Span place;                                 // of the first one; no line: there is none
  std::vector<std::string> alone, elsewhere;  // nodes: NEW_PROCESS, EXTERNAL
  std::vector<std::string> kept;              // the engine and engine nodes, which stay together
};

/// The processes in the file, before objects are restored. Reports invalid processes (E0802).
Processes find_processes(const SavedGraph& saved, Diagnostics& diagnostics);
/// `placement:` of the nodes, and one note on all of it.
void translate_processes(Translation& t, const Processes& processes);

/// Takes nodes that only show or draw pictures out of the graph, with their connections.
Pictures remove_pictures(SavedGraph& saved, const EntityMapping& mapping);
/// `render:` where our object draws, and one note about everything else.
void translate_pictures(Translation& t, const Pictures& pictures);

/// Ports of entities that are known, by the names that our manifests give them.
void rename_ports(SavedGraph& saved, const EntityMapping& mapping);

/// Whether these sensors or actuators have no settings: such a list excludes all others.
bool has_only_names(const std::vector<ComponentSpec>& components);

// In this order.
void translate_names(Translation& t);  // and the name of the graph
void translate_entities(Translation& t);
void choose_engine(Translation& t);
/// Graph.save does not know the states of engine nodes, which EAGERx always has.
void add_states_of_engine_nodes(Translation& t);
void choose_rate(Translation& t);
void translate_connections(Translation& t);
void translate_environment(Translation& t);  // actions and observations

/// A rate in Hz, a delay in seconds; reported (E0802) and nullopt if it is something else.
std::optional<Rational> saved_rate(const YamlValue& yaml, Diagnostics& diagnostics);
std::optional<Rational> saved_delay(const YamlValue& yaml, Diagnostics& diagnostics);

/// The rate of a sensor or actuator as the manifest gives it with these settings, or nullopt.
std::optional<Rational> manifest_rate(const Entity& entity, const PortManifest& port,
                                      const std::vector<Setting>& settings);

/// The space as saved, without infinite bounds; nullopt if it is empty. Not checked: only spaces in
/// the graph are.
std::optional<SpaceSpec> saved_space(const SavedPort& port);
/// Reports spaces that a graph cannot express (E02xx).
bool check_space(const SpaceSpec& space, Diagnostics& diagnostics);
/// Whether a manifest gives all of the space, in numbers.
bool same_space(const SpaceSpec& saved, const SpaceSpec& manifest);
/// The dtype and shape that the manifest leaves open or contradicts; nullopt: none.
std::optional<SpaceSpec> missing_of(const SpaceSpec& saved, const SpaceSpec& manifest);

/// The port of a manifest that a saved port is, or nullptr.
const PortManifest* manifest_port(const Entity& entity, std::string_view section,
                                  std::string_view name);

}  // namespace eagerx::gen

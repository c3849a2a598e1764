// Entities and targets, as their manifests describe them. This is all the generator knows about
// them.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "generator/frontend/library/condition.hpp"
#include "generator/frontend/spec/graph_spec.hpp"

namespace eagerx::gen {

enum class EntityKind : std::uint8_t { node, engine, engine_node, engine_state, object, processor };

/// The counterpart in EAGERx (module/Class), if its parameters there have these values.
struct EagerxId {
  Spanned<std::string> id;
  std::vector<Setting> when;
};

/// One parameter of an entity.
struct Parameter {
  enum class Type : std::uint8_t {
    integer,
    number,
    boolean,
    text,
    keyword,
    integers,
    numbers,
    model
  };
  Spanned<std::string> name;
  Type type = Type::number;
  std::string unit, about;
  std::optional<YamlValue> fallback;  // `default:`; without it the parameter must be given
  std::optional<ConditionNumber> low, high;
  std::vector<std::string> options;  // keyword
  std::string cpp_class;             // keyword: the C++ enumeration
  std::string engine;                // model: the engine whose model of an object it is
  std::string eagerx;                // its name in EAGERx
  bool tunable = false;              // a state, too, where a graph says so
  bool tunes_running = false;        // … that can be set while an episode runs
};

/// The conditions on parameters, ports and the rate.
struct Requirement {
  Condition that;
  std::string text;     // as written
  std::string because;  // the same in words
  Span span;
};

/// An input, output, sensor, actuator or state.
struct PortManifest {
  Spanned<std::string> name;
  SpaceSpec space;
  std::string unit, about;
  std::string eagerx;                // its name in EAGERx
  std::optional<QuantitySpec> rate;  // sensors and actuators
  ConnectionSettings settings;       // with a `max_delay` the entity sets the delay at its reset
  bool optional = false;             // of a node: a graph may do without it
  bool tunes_running = false;        // a state that can be set while an episode runs
};

/// A C++ class and the header that defines it, as generated code includes it.
struct CppClass {
  std::string name;
  std::string include;  // empty: none besides the entity's own
  Span span = {};       // of the name
  Span header = {};     // of the header, in the manifest
};

/// `mine::Gain` as generated code names it: from the global namespace, since a graph may have the
/// name `mine`. None has the name `eagerx`.
std::string from_global_namespace(const std::string& cpp_name);

/// A state of an object that is one of an engine node.
struct NodeState {
  Spanned<std::string> name;  // of the object
  Spanned<std::string> node;  // NODE.STATE
};

/// How an object is made on one engine.
struct ObjectEngine {
  Spanned<std::string> engine;
  CppClass model;
  std::string summary, description;  // of one that has a manifest of its own
  std::vector<EntitySpec> nodes;
  std::vector<ConnectionSpec> connections;
  std::vector<EntitySpec> states;  // name = the object's state, type = an engine state
  std::vector<NodeState> node_states;
  bool vectorized = false;   // whether the model also calculates with SIMD vectors
  std::string include_root;  // folder that the model's include is relative to
};

/// An object's implementation for an engine in a separate manifest.
struct Implementation {
  Spanned<std::string> object;
  ObjectEngine engine;
};

struct Entity {
  EntityKind kind = EntityKind::node;
  Spanned<std::string> id;
  std::vector<EagerxId> eagerx_ids;
  std::string summary, description;
  CppClass cpp;        // of a node in Python alone without a name
  std::string python;  // nodes: the file with its class in Python, which is called as the id
  std::optional<CppClass> vectorized_cpp;  // where it is another class
  CppClass simulator;                      // engines
  std::vector<std::string> engines;  // engine nodes and states: where they work; empty: everywhere
  std::vector<std::string> runs;     // engines: others whose implementations of objects they run
  bool asynchronous = false;         // engines: whether they have a clock for inputs
  std::vector<Parameter> config;
  std::vector<Requirement> requirements;
  std::vector<PortManifest> inputs, outputs, states, sensors, actuators;
  std::vector<PortManifest> reset_targets;  // of a reset node; others have none
  std::vector<ObjectEngine> object_engines;
  std::vector<std::string> counts;  // nodes: what for_each_count() counts
  std::vector<std::string> moves;   // engine states: what they set that changes in an episode
  std::string simd_registers;       // engines: of a SIMD vector; empty: the runtime's choice
  Condition vectorized;  // where its class also calculates with SIMD vectors; empty: nowhere
  std::vector<std::string> packages;           // pkg-config's names of libraries that it needs
  std::optional<Spanned<std::string>> system;  // the operating system it needs
  std::optional<Spanned<std::string>> family;  // the family of boards it needs
  std::string path;                            // of the manifest, as messages show it
  std::string include_root;                    // folder that the include is relative to
  bool own = false;                            // the user's: of a folder of `--path` or `library:`
  // The manifest of a composite, a graph with ports, from which `compose/` makes the contents. Its
  // own ports have the settings of their bindings, and no spaces.
  std::shared_ptr<const YamlValue> composite;

  [[nodiscard]] const PortManifest* input(std::string_view name) const;
  [[nodiscard]] const PortManifest* output(std::string_view name) const;
  [[nodiscard]] const PortManifest* sensor(std::string_view name) const;
  [[nodiscard]] const PortManifest* actuator(std::string_view name) const;
  [[nodiscard]] const PortManifest* state(std::string_view name) const;
  [[nodiscard]] const PortManifest* reset_target(std::string_view name) const;
  [[nodiscard]] bool is_reset_node() const { return !reset_targets.empty(); }
  [[nodiscard]] bool is_composite() const { return composite != nullptr; }
  /// Whether this engine node or state works on `engine`, or on one whose implementations that
  /// runs.
  [[nodiscard]] bool works_on(const Entity& engine) const;
  /// How this object is made on `engine`: for the engine itself, else for one that it runs; nullptr
  /// if it is not.
  [[nodiscard]] const ObjectEngine* implementation(const Entity& engine) const;
};

/// A board or system that generated programs run on.
struct Target {
  Spanned<std::string> id;
  std::string summary, description;
  std::vector<std::pair<std::string, std::string>>
      templates;  // template file (full path) → output name
  std::vector<std::pair<std::string, std::string>>
      partner;           // the same of the board's half of a split graph; empty: it cannot be one
  std::string language;  // of a part's program that is not of C++; empty: C++
  std::vector<std::pair<std::string, std::string>> yours;  // as `partner`, written once
  std::string cmake, toolchain;
  bool vectorized = false;                 // whether it also takes the program over SIMD vectors
  bool derivatives = false;                // whether over numbers with derivatives (eagerx::Number)
  std::string system;                      // its operating system; empty: none
  std::string family;                      // the family of boards it is of; empty: none
  std::optional<std::uint32_t> baud;       // of its serial port, if that can send telemetry
  std::optional<std::uint64_t> ram_bytes;  // of the memory for data, if it is written
  std::string cpu;                         // the core's name: "Cortex-M4F"
  std::optional<std::uint64_t> clock_hz;   // of the core
  std::optional<unsigned> wait_states;     // of the memory for code
  std::vector<std::pair<std::string, double>> interrupts;  // its own handlers: most times a second
  std::vector<std::pair<std::string, std::string>> facts;  // for people: clock_hz, flash, run, …
  std::vector<std::string> run;
  std::string image;  // the file that is built, with `{name}`; empty: as CMake calls a program

  /// Boards define the addresses of their memories.
  [[nodiscard]] bool is_board() const { return system.empty() && ram_bytes.has_value(); }
};

class ManifestLoader;

/// All entities and targets. Problems of a manifest are added to the library's diagnostics when the
/// manifest is read: for an installed one, when its id is requested.
struct Library {
  mutable std::map<std::string, Entity> entities;  // those that were read
  mutable std::map<std::string, Target> targets;
  std::shared_ptr<ManifestLoader> unread;  // has the other manifests; nullptr if there are none

  /// nullptr if there is none.
  [[nodiscard]] const Entity* find(const std::string& id) const;
  [[nodiscard]] const Target* find_target(const std::string& id) const;
  [[nodiscard]] const std::map<std::string, Entity>& all_entities() const;
  [[nodiscard]] const std::map<std::string, Target>& all_targets() const;
  void read_all() const;
  [[nodiscard]] std::vector<std::string> ids(EntityKind kind) const;
  /// A name that objects are implemented for and several engines run, but that is no engine itself.
  /// These engines; empty if `name` is none.
  [[nodiscard]] std::vector<std::string> engines_of_family(const std::string& name) const;
};

std::string_view to_string(EntityKind kind);

/// Reads every manifest.yaml below the folders, in the order of their paths; a folder's span is the
/// place that names it. From the `installed` folders, which come last, it reads only the ids,
/// because parsing all manifests takes 60 ms: a manifest is parsed when its id is requested. So
/// `sources` and `diagnostics` must outlive the library. Codes: E0301 a folder that cannot be read,
/// E0302 an id defined twice, E0303 an implementation of a missing object, E02xx what is wrong in a
/// manifest.
Library load_library(const std::vector<Spanned<std::string>>& folders, SourceMap& sources,
                     Diagnostics& diagnostics,
                     const std::vector<Spanned<std::string>>& installed = {});

/// The id in a manifest's text, if there is exactly one line for it and the id is a plain word.
std::optional<std::string_view> declared_id(std::string_view text);

/// Typed form of one manifest.
std::optional<Entity> read_entity_manifest(const YamlValue& root, const std::string& path,
                                           Diagnostics& diagnostics);
std::optional<Implementation> read_implementation_manifest(const YamlValue& root,
                                                           const std::string& path,
                                                           Diagnostics& diagnostics);
std::optional<Target> read_target_manifest(const YamlValue& root, const std::string& path,
                                           Diagnostics& diagnostics);

/// The table for manifests of this kind ("node", "engine", …, "target"); nullptr if there is none.
const Format* manifest_format(std::string_view kind);
/// The same for a manifest with `graph:`; nullptr for kinds that are no composites.
const Format* composite_format(std::string_view kind);
std::vector<std::string> manifest_kinds();

}  // namespace eagerx::gen

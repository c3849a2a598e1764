// A second front end: files that EAGERx's Graph.save and BaseEnv.save write, as a GraphSpec.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "generator/frontend/library/library.hpp"

namespace eagerx::gen {

/// Values that Graph.save does not write; empty: chosen, with a note.
struct ImportOptions {
  std::string engine;
  std::optional<Rational> engine_rate_hz, rate_hz;
  bool keep_processes = false;  // nodes with NEW_PROCESS become parts
};

struct ImportedGraph {
  GraphSpec spec;
  /// Reasons for values, for the reader of the converted file: "name", "rate", "engine",
  /// "engine.rate".
  std::map<std::string, std::string> remarks;
};

/// Whether this is such a file: a mapping with `nodes`, `connects` and `gui_state`.
bool is_saved_graph(const YamlValue& root);

/// Translates the file through the manifests of `library`. Spans point into the saved file.
/// Problems, all reported, nullopt: E0801 an entity without a counterpart, E0802 not such a file,
/// E0803 a Python object instead of a value, E0804 a missing engine or rate, E0805 an object that
/// cannot be restored. Warnings: E0806 differences between the program and EAGERx's behavior.
std::optional<ImportedGraph> import_graph(const YamlValue& root, const std::string& path,
                                          const Library& library, const ImportOptions& options,
                                          Diagnostics& diagnostics);

/// An entity that a file needs and that does not exist in C++, with its interface as a manifest.
struct MissingEntity {
  struct Port {
    std::string name, space;
    bool optional = false;
  };
  std::string id;                  // module/Class
  std::string kind;                // of manifests: "node", "reset_node", "engine_state", …
  std::string type;                // its name here
  std::vector<std::string> users;  // "the node `smooth`"
  std::string manifest;            // but for `header:` and `class:`, which a folder knows
  std::vector<Port> inputs, outputs, states, targets;
  // Of an object in a file that says how its engine makes it:
  std::string engine;                       // empty: the file does not say it
  std::vector<std::string> implementation;  // lines below `engines: {ENGINE: …}`, but for `model:`
  std::vector<std::string> model;           // what the engine is given, "key: value"
};

/// All of them; nullopt after E0802.
std::optional<std::vector<MissingEntity>> missing_entities(const YamlValue& root,
                                                           const Library& library,
                                                           const ImportOptions& options,
                                                           Diagnostics& diagnostics);

/// The graph as a person would write it: reading it back gives the same graph.
std::string write_graph(const ImportedGraph& graph);

}  // namespace eagerx::gen

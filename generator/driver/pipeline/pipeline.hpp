// The steps from a graph file to a plan, with everything that they read.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "generator/driver/pipeline/options.hpp"
#include "generator/frontend/compose/port_bindings.hpp"
#include "generator/frontend/import/import.hpp"
#include "generator/graph/plan/plan.hpp"
#include "generator/policy/agent/policies.hpp"
#include "generator/support/command_line/command_line.hpp"
#include "generator/support/command_line/output.hpp"

namespace eagerx::gen {

/// One run of the generator. It stays where it is: graph and plan point into the library, and the
/// library reads on from the sources.
struct Run {
  Run() = default;
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  SourceMap sources;
  Diagnostics diagnostics;
  std::string root;  // of the built-in models, targets, templates
  Library library;
  YamlValue written;        // the graph's file
  YamlValue tree;           // of it, in the chosen variant
  YamlValue flat;           // without composites and arrays
  PortBindings composites;  // of the graph: their ports
  std::optional<GraphSpec> spec;
  std::optional<SafetySpec> safety_of_cut;  // what the graph says for the nodes that are cut out
  std::vector<std::string> tables;          // files with numbers of the graph
  std::optional<Graph> graph;
  Policies policies;
  std::optional<Plan> plan;
};

/// Loads the library for a command that has no graph.
void load(Run& run, const LibraryOptions& options);
/// The graph file; of EAGERx's own too, with Python's tags.
YamlValue read_graph_file(Run& run, const std::string& path);
/// EAGERx's file through the manifests of the library, which is loaded.
std::optional<ImportedGraph> import_file(Run& run, const YamlValue& tree,
                                         const GraphOptions& options);
/// All stages, from the graph's file to the plan. True if there was no problem.
bool make(Run& run, const GraphOptions& options);
/// The same of a graph that is the text of `options.graph`, which need not be there.
bool make_of_text(Run& run, const GraphOptions& options, const std::string& text);
/// Stops at the spec, made from `run.written`: checks its form only, independent of its use.
bool make_spec(Run& run, const GraphOptions& options);
/// All that `check` looks for in such a graph; true if there was no problem.
bool check_text(Run& run, const GraphOptions& options, const std::string& text);
/// The targets that are generated for, as the command line says.
std::vector<std::string> wanted_targets(const GraphOptions& options);
/// Prints the diagnostics to the standard error, and returns the exit code.
int finish(Run& run, const MessageOptions& options);

}  // namespace eagerx::gen

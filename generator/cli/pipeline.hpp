// The way from a graph file to a plan, with everything that was read on the way.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "generator/agent/use.hpp"
#include "generator/cli/commands.hpp"
#include "generator/import/import.hpp"
#include "generator/network/network.hpp"
#include "generator/plan/plan.hpp"

namespace eagerx::gen {

/// The weights of a node that runs a policy: `spec` is its place among the nodes of the graph file.
struct NodeNetwork {
  std::size_t spec = 0;
  Network network;
};

/// One run of the generator. Graph and plan point into the library and stay where they are.
struct Run {
  SourceMap sources;
  Diagnostics diagnostics;
  std::string root;  // of the built-in models, targets, templates
  Library library;
  std::optional<GraphSpec> spec;
  std::optional<Graph> graph;
  std::optional<Network> network;
  std::vector<NodeNetwork> node_networks;
  std::optional<Plan> plan;
};

/// Loads the library for a command that has no graph.
void load(Run& run, const Options& options);
/// The graph file; of EAGERx's own too, with Python's tags.
YamlValue read_graph_file(Run& run, const std::string& path);
/// EAGERx's file through the manifests of the library, which is loaded.
std::optional<ImportedGraph> import_file(Run& run, const YamlValue& tree, const Options& options);
/// read → spec (or import) → resolve → plan, and the policy. True if there was no problem.
bool make(Run& run, const Options& options);
/// The weights that `policy` names, with the known answers that every program checks.
std::optional<Network> read_weights(Run& run, const AgentSpec& policy);
/// The weights of all nodes, each of which becomes an entity of its own in the library.
void read_node_policies(Run& run);
/// Where the nodes' policies are used, in the graph.
std::vector<NodePolicy> node_policies(const Run& run);
/// Prints what was found to the standard error and returns the exit code.
int finish(Run& run, const Options& options);

}  // namespace eagerx::gen

// The graph while it is being resolved: ports are known, spaces and connections not yet all.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "generator/resolve/config.hpp"
#include "generator/resolve/graph.hpp"

namespace eagerx::gen {

/// As much of a space as is written down.
struct PartialSpace {
  std::optional<Dtype> dtype;
  std::optional<std::vector<std::uint64_t>> shape;
  std::vector<double> low, high;
  std::optional<std::string> like;  // an input of the same node; for actions a port of the graph
  Span span;
};

/// Settings of a connection; later ones win over earlier ones.
struct ConnectionSettings {
  std::optional<std::uint32_t> window;
  std::optional<Rational> delay_s;
  std::optional<bool> skip;
  std::optional<ProcessorSpec> processor;
};

struct DraftEdge {
  std::size_t node = 0;
  std::size_t output = 0;
  Span span;
};

struct DraftInput {
  std::string name;
  Span span;
  PartialSpace declared;
  ConnectionSettings settings;
  std::optional<DraftEdge> edge;
};

struct DraftOutput {
  std::string name;
  Span span;
  PartialSpace declared;
  std::optional<ProcessorSpec> processor;
};

struct DraftNode {
  GraphNode node;
  std::vector<DraftInput> inputs;
  std::vector<DraftOutput> outputs;

  [[nodiscard]] DraftInput* input(std::string_view name);
  [[nodiscard]] DraftOutput* output(std::string_view name);
};

struct PortIndex {
  std::size_t node = 0;
  std::size_t port = 0;
};

struct DraftObject {
  std::string name;
  const Entity* entity = nullptr;
  std::map<std::string, PortIndex> sensors;                 // to outputs of engine nodes
  std::map<std::string, std::vector<PortIndex>> actuators;  // to inputs of engine nodes
};

struct Draft {
  const GraphSpec& spec;
  const Library& library;
  Diagnostics& diagnostics;
  Graph graph;
  std::vector<DraftNode> nodes;
  std::vector<DraftObject> objects;
};

/// What a SpaceSpec says, with references replaced. Problems: E0325 shape, E0326 bounds.
PartialSpace partial_space(const SpaceSpec& spec, const References& references, Diagnostics& diagnostics);
/// `base` with everything that `over` says.
PartialSpace overlay(PartialSpace base, const PartialSpace& over);
/// The settings of a manifest, a selection or a connection.
template <class Spec>
ConnectionSettings settings_of(const Spec& spec);
ConnectionSettings overlay(ConnectionSettings base, const ConnectionSettings& over);

// The steps of resolve(), in their order; each adds to the draft.
void add_environment(Draft& draft);
void add_engine(Draft& draft, const ResolveOptions& options);
void add_nodes(Draft& draft);
void add_objects(Draft& draft);
void connect(Draft& draft);            // the user's connections; unconnected ports
void resolve_spaces(Draft& draft);     // spaces and processors; fills the graph's inputs and outputs
void resolve_states(Draft& draft);     // how states are drawn
void check_cycles(const Graph& graph, Diagnostics& diagnostics);

template <class Spec>
ConnectionSettings settings_of(const Spec& spec) {
  ConnectionSettings result;
  if (spec.window) result.window = spec.window->value;
  if (spec.delay_s) result.delay_s = spec.delay_s->value;
  if (spec.skip) result.skip = spec.skip->value;
  result.processor = spec.processor;
  return result;
}

}  // namespace eagerx::gen

// The graph while it is being resolved: all ports are known, but not yet all spaces and
// connections.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "generator/frontend/parameters/config.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/frontend/spec/port_name.hpp"
#include "generator/graph/resolve/graph.hpp"
#include "generator/graph/resolve/partial_space.hpp"

namespace eagerx::gen {

struct UnresolvedEdge {
  std::size_t node = 0;
  std::size_t output = 0;
  Span span;
};

struct UnresolvedInput {
  std::string name;
  std::string
      written;  // as the graph calls it: "smooth.signal", "pendulum.u", "observations.angle"
  Span span;
  PartialSpace declared;        // what the callback takes, after the processor
  ConnectionSettings settings;  // once it is connected; before, what its manifest says
  ConnectionSettings said;      // of the port, in the graph
  std::optional<UnresolvedEdge> edge;
  std::optional<PartialSpace> outside = {};  // an actuator that has a processor: what comes to that
  bool entity_sets_delay = false;
  bool optional = false;  // of a node: a graph may do without it
  bool feedthrough = false;
  bool actuator = false;
  std::string sensor = {};  // that it reads, as connections call it: "pendulum.theta"
};

struct UnresolvedOutput {
  std::string name;
  Span span;
  PartialSpace declared;  // what the callback gives
  std::optional<ProcessorSpec> processor;
  PartialSpace published = {};              // what comes out of the processor
  std::vector<std::string> sensors = {};    // what it stands for: "pendulum.theta"
  std::vector<std::string> converted = {};  // those with a processor of their own
  bool of_sensor = false;      // the processor: other readers get what is in front of it
  bool of_connection = false;  // the processor, which is written there
};

struct UnresolvedNode {
  GraphNode node;
  std::vector<UnresolvedInput> inputs;
  std::vector<UnresolvedOutput> outputs;

  /// By name, feedthroughs apart.
  [[nodiscard]] UnresolvedInput* input(std::string_view name);
  [[nodiscard]] const UnresolvedInput* input(std::string_view name) const;
  [[nodiscard]] UnresolvedOutput* output(std::string_view name);
};

struct PortIndex {
  std::size_t node = 0;
  std::size_t port = 0;
};

/// The message that readers of a sensor get from an engine node's output.
struct UnresolvedSensor {
  std::string written;  // "pendulum.theta"
  PortIndex output;
  // Overrides for these readers only, because the output has other sensors. Empty members are those
  // of the output.
  PartialSpace taken;  // bounds of what comes from there
  std::optional<ProcessorSpec> processor;
  PartialSpace space = {};     // what that gives
  bool of_connection = false;  // the processor, which is written there
};

struct UnresolvedObject {
  std::string name;
  const Entity* entity = nullptr;
  std::map<std::string, UnresolvedSensor> sensors;
  std::map<std::string, std::vector<PortIndex>> actuators;  // to inputs of engine nodes
  std::map<std::string, ConnectionSettings> delays;         // defaults of what comes from sensors
};

struct UnresolvedGraph {
  const GraphSpec& spec;
  const Library& library;
  Diagnostics& diagnostics;
  Graph graph;
  std::vector<UnresolvedNode> nodes;
  std::vector<UnresolvedObject> objects;
  std::set<std::string> erroneous;  // objects and nodes with a reported problem of their ports:
                                    // what follows from it is not said
  References safety = {};           // `$(safety KEY)`, in defaults of parameters
  std::optional<std::size_t> task = {};  // its node
  std::optional<std::size_t> render = {};
  std::deque<EntitySpec> added = {};  // nodes that the graph file has not, as it would say them
  std::map<std::string, std::size_t, std::less<>> node_of_name = {};  // once all are there
  std::map<std::string, std::size_t, std::less<>> object_of_name = {};

  /// nullptr: the graph has no engine, or one that is not known.
  [[nodiscard]] const Entity* engine() const {
    return spec.has_engine() ? nodes[Graph::kEngine].node.entity : nullptr;
  }
  /// Whether the generator itself adds the node, which is not an entity of the graph.
  [[nodiscard]] bool is_added(std::size_t node) const { return node == task || node == render; }
  void add_object(UnresolvedObject object);
  /// nullptr if no object has this name.
  [[nodiscard]] const UnresolvedObject* find_object(std::string_view name) const;
  /// Whether a node, or the object that an engine node is of, has such a problem.
  [[nodiscard]] bool is_doubtful(const UnresolvedNode& node) const;
};

/// Active while the ports of an object or a node are made. If a problem is reported in that time,
/// problems of connections to these ports are consequences, and are not reported.
class MakingPorts {
 public:
  MakingPorts(UnresolvedGraph& draft, std::string name)
      : draft_(draft), name_(std::move(name)), before_(draft.diagnostics.error_count()) {}
  ~MakingPorts() {
    if (draft_.diagnostics.error_count() != before_) draft_.erroneous.insert(name_);
  }
  MakingPorts(const MakingPorts&) = delete;
  MakingPorts& operator=(const MakingPorts&) = delete;

 private:
  UnresolvedGraph& draft_;
  std::string name_;
  std::size_t before_;
};

}  // namespace eagerx::gen

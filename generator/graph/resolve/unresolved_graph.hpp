// The graph while it is being resolved: ports are known, spaces and connections not yet all.
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

namespace eagerx::gen {

/// As much of a space as is written down.
struct PartialSpace {
  std::optional<Dtype> dtype;
  std::optional<std::vector<std::uint64_t>> shape;
  std::vector<double> low, high;
  std::optional<std::string> like;  // an input of the same node; for actions a port of the graph
  Span span, like_span;
  Span bounds_span;  // of the bound that was written last
};

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
  // For these readers alone, as the output has other sensors. What is empty is as the output says.
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
  /// A node that no entity of the graph is: what the generator itself adds.
  [[nodiscard]] bool is_added(std::size_t node) const { return node == task || node == render; }
  void add_object(UnresolvedObject object);
  /// nullptr: there is none of this name.
  [[nodiscard]] const UnresolvedObject* find_object(std::string_view name) const;
  /// Whether a node, or the object that an engine node is of, has such a problem.
  [[nodiscard]] bool is_doubtful(const UnresolvedNode& node) const;
};

/// While the ports of an object or a node are made: if a problem is reported meanwhile, it is the
/// cause, and what would be said of connections to these ports only follows from it.
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

/// The space of a SpaceSpec, with references replaced. Problems: E0325 shape, E0326 bounds.
PartialSpace partial_space(const SpaceSpec& spec, const References& references,
                           Diagnostics& diagnostics);
/// `base` with everything that `over` says.
PartialSpace overlay(PartialSpace base, const PartialSpace& over);
/// The same where dtype and shape must not change: `what` has the space `base` (E0305, E0306).
PartialSpace narrow(PartialSpace base, const PartialSpace& over, const std::string& what,
                    Diagnostics& diagnostics);
/// A manifest's settings of the connections to a port, with references replaced (E0204 where one is
/// no number of messages or seconds).
ConnectionSettings manifest_settings(const PortManifest& port, const References& references,
                                     Diagnostics& diagnostics);
/// An input or output as its manifest describes it.
UnresolvedOutput draft_output(const PortManifest& port, Span span, const References& references,
                              Diagnostics& diagnostics);
UnresolvedInput draft_input(const PortManifest& port, const std::string& written, Span span,
                            const References& references, Diagnostics& diagnostics);
/// The space if dtype and shape are known.
std::optional<Space> complete(const PartialSpace& partial);
PartialSpace partial_of(const Space& space);
/// Bounds must be one number or one for each element, fit the dtype, and leave something between
/// them (E0326 at `place`). Nothing else may look at bounds that were not checked.
bool check_bounds(const Space& space, Span place, Diagnostics& diagnostics);
/// Where the bounds are written, if that is in the file of `otherwise`.
Span place_of_bounds(const PartialSpace& space, Span otherwise);
/// The bound of an element; `otherwise` if there is none.
double bound_of(const std::vector<double>& bounds, std::size_t element, double otherwise);
/// float32 bounds are written as decimals: 3.14 is allowed where the bound is float32(3.14), and
/// back.
double rounded(const Space& space, double value);
/// Whether what arrives has the dtype and shape that are declared, where they are.
bool fits(const PartialSpace& declared, const Space& arriving);
/// Applies what a graph adds to an output of a manifest: a processor, and the space of what is
/// published.
void apply_overrides(UnresolvedOutput& output, const ComponentSpec& said,
                     const std::string& written, Diagnostics& diagnostics);
/// The settings of a port, or nullptr.
const ComponentSpec* find_component(const Selection& selection, std::string_view name);
/// Reports names in the selection that are none of the entity's `ports` (E0307); true if there was
/// any. `what` they are: "sensor", "input", …
bool report_unknown(const Selection& selection, const std::vector<PortManifest>& ports,
                    const Entity& entity, std::string_view what, Diagnostics& diagnostics);
/// E0308: an engine node or state that is of other engines.
void report_wrong_engine(const Entity& entity, const Entity& engine, Span span,
                         Diagnostics& diagnostics);
/// "float32 [2]", "any dtype, any shape"
std::string describe(const PartialSpace& space);
// The steps of resolve(), in their order; each adds to the draft.
void add_environment(UnresolvedGraph& draft);
void add_engine(UnresolvedGraph& draft, const ResolveOptions& options);
void add_nodes(UnresolvedGraph& draft);
/// One of them, whose optional inputs are there if `connected` has their names.
UnresolvedNode node_of(UnresolvedGraph& draft, const EntitySpec& spec,
                       const std::set<std::string_view>& connected);
void add_objects(UnresolvedGraph& draft);
void add_task(UnresolvedGraph& draft);       // its node
void add_render(UnresolvedGraph& draft);     // its node
void let_task_skip(UnresolvedGraph& draft);  // its inputs that wait for the action of the same tick
void check_cycles(UnresolvedGraph& draft);
void connect(UnresolvedGraph& draft);  // the user's connections; unconnected ports
void resolve_spaces(
    UnresolvedGraph& draft);  // spaces and processors; fills the graph's inputs and outputs
void resolve_safety(UnresolvedGraph& draft);  // safe actions, in the spaces of the actions
/// Expressions of the task, once its inputs' spaces are known. Problems: E0323 a time of too many
/// steps, E0339 an expression.
void resolve_task(UnresolvedGraph& draft);
/// A node that adds noise to each observation that `task.noise` names, once it is connected (E0307,
/// E0315).
void add_noise(UnresolvedGraph& draft);
/// The inputs of a training's critic (E0307). Its inputs of the task get an output each, of the
/// task's node, behind the terms (E0315).
void add_critic_outputs(UnresolvedGraph& draft, UnresolvedNode& task);
void resolve_critic(UnresolvedGraph& draft);
/// The stages of a training (E0307 names, E0327 ranges, E0352 what no
/// stage can be).
void resolve_stages(UnresolvedGraph& draft);
/// Whether the source of `render:` can be shown (E0360), and which nodes only pictures need.
void resolve_render(UnresolvedGraph& draft);
void resolve_states(UnresolvedGraph& draft);         // how states are drawn
void resolve_reset_targets(UnresolvedGraph& draft);  // which states the reset nodes bring about
/// `sync: false` (E0338 what does not go together with it).
void check_sync(UnresolvedGraph& draft);

/// The placement of nodes in programs (E0332 what cannot be placed, E0333 what is placed twice,
/// E0334 targets that are no partners).
void place_parts(UnresolvedGraph& draft, const std::vector<PlacementSpec>& placement);

/// Names in `settings` that are not among those of a graph. `what` they are: "action" (E0307).
void report_unknown_names(const std::vector<Setting>& settings,
                          const std::vector<std::string>& known, std::string_view what,
                          const char* otherwise, Diagnostics& diagnostics);
/// The safe outputs of a graph without engine (E0307, E0327, E0348).
void resolve_safe_outputs(UnresolvedGraph& draft);

/// The values of `$(safety KEY)` in manifests.
References safety_references(const GraphSpec& spec);
/// Adds what `$(safe ACTUATOR)` means in the implementation of `object`, whose own references are
/// `references`: its value in `safety:`, else that of the action that is connected to it, else zero
/// moved into its space. Problems: E0307, E0327.
void add_safe_actuators(UnresolvedGraph& draft, const EntitySpec& object, const Entity& entity,
                        References& references);
/// A processor between a port with the space `arriving` and its receiver; `source`: where the
/// message comes from. Problems: E0303 to E0306, E0312.
std::optional<Processor> make_processor(UnresolvedGraph& draft, const ProcessorSpec& spec,
                                        const Space& arriving, Span source);
/// The processors that turn a message with the space `arriving` into what is declared, as a
/// connection names them: "processor: {type: GetIndex, config: {index: [0]}}".
std::vector<std::string> fitting_processors(const Library& library, const PartialSpace& takes,
                                            const Space& arriving);
/// How `name` is drawn, checked against its space (E0322, E0327).
std::optional<Random> read_random(const std::string& name, const Space& space,
                                  const RandomSpec& spec, Diagnostics& diagnostics);
/// Which messages boards send (E0206, E0307), which is nothing for half of a split graph (E0342).
void resolve_telemetry(UnresolvedGraph& draft);
/// The delay of the connection to `from`, in `into`: what it is at first, the longest that a reset
/// may make it, and how it is drawn (E0327).
void resolve_delay(const UnresolvedGraph& draft, const UnresolvedInput& from, Input& into);
/// The requirements of a reset on the finished graph (E0317, E0318); marks what cannot run during
/// one.
void check_resets(Graph& graph, Diagnostics& diagnostics);
/// Checks the conditions of manifests on parameters, ports and rates (E0328).
void check_limits(UnresolvedGraph& draft);
/// Parameters that are too large for float, where the program computes with it (E0323).
void check_float_range(UnresolvedGraph& draft);
/// The same of a processor and those before it; false if there was a problem.
bool check_limits(const Processor& processor, Diagnostics& diagnostics);
/// The space that an input is declared with, by the name that connections call it; nullopt if there
/// is none.
std::optional<PartialSpace> declared_space(const UnresolvedGraph& draft, const std::string& port);
/// Whether a connection asks a reset node for a state: `to: node.targets.name`.
bool is_reset_target(const ConnectionSpec& connection);
/// All names that `to:` may say.
std::vector<std::string> input_names(const UnresolvedGraph& draft);

}  // namespace eagerx::gen

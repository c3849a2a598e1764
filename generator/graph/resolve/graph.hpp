// The graph with every name bound: what runs, with spaces, parameters and connections known and
// checked.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "generator/frontend/expression/expression.hpp"
#include "generator/frontend/library/library.hpp"
#include "generator/frontend/parameters/config.hpp"
#include "generator/frontend/spec/dtype.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {

/// The space of a message. Bounds are empty (unbounded), one for all elements, or one for each.
struct Space {
  Dtype dtype = Dtype::float32;
  std::vector<std::uint64_t> shape;
  std::vector<double> low, high;
  [[nodiscard]] std::uint64_t size() const;
  /// "float32 [2]"
  [[nodiscard]] std::string describe() const;
};

/// The processor of a message; of several the last one, with those before it.
struct Processor {
  const Entity* entity = nullptr;
  Config config;
  Space input, output;
  Span span;
  std::vector<Processor> before = {};  // in the order in which they convert

  /// All of them, in that order.
  [[nodiscard]] std::vector<const Processor*> stages() const;
  /// "AddProc, Negate"
  [[nodiscard]] std::string names() const;
};

/// An output: `raw` is the space of the callback's message, `space` that of the published message
/// after the processor.
struct Output {
  std::string name;
  std::vector<std::string>
      sensors;  // that it stands for, as the graph calls them: "pendulum.theta"
  Space raw, space;
  std::optional<Processor> processor;
  Span span;
  std::vector<std::string> converted = {};  // of `sensors`: a processor of its own makes it of this

  /// The sensors that this message is.
  [[nodiscard]] std::vector<std::string> names() const;
};

/// How a state or a delay gets its value at a reset. Vectors hold one value for each element.
struct Random {
  RandomSpec::Kind kind = RandomSpec::Kind::value;
  std::vector<double> first, second;         // value; low, high; mean, std
  std::vector<std::vector<double>> choices;  // choice
  Span span;
  /// "uniform from [0] to [1]"
  [[nodiscard]] std::string describe() const;
};

/// An input and the connection that feeds it.
struct Input {
  std::string name;
  std::string written;  // as messages call it: "smooth.signal", "pendulum.u", "observations.angle"
  std::size_t source_node = 0;
  std::size_t source_output = 0;
  std::string sensor;  // that it reads: "pendulum.theta"; empty if it reads none
  Space space;         // as the callback sees it, after the processor
  std::optional<Processor> processor;
  std::size_t of_sensor = 0;  // the number of its first stages that make the sensor's message
  bool original = false;      // before the processor of its output, which is that of a sensor
  std::uint32_t window = 1;
  Rational delay_s;
  std::optional<Rational> max_delay_s;  // a reset may change the delay up to this
  bool entity_sets_delay = false;       // at its reset; else only the program's interface does
  std::optional<Random> random_delay;
  bool skip = false;
  bool actuator = false;  // of an object, `written` is its name
  // The input space of an actuator, before a processor of the object; unknown after a processor of
  // the graph.
  std::optional<Space> actuator_space;
  bool feedthrough = false;  // of a reset node: `name` is the output that it is passed on to
  Span span;
};

/// The target of a reset node: a state of an object or of a node.
struct ResetTarget {
  std::string name;
  std::optional<std::size_t> object;  // the state's owner
  std::size_t node = 0;               // the same, if it is no object
  std::size_t state = 0;
  Space space;  // as the callback sees it, after the processor
  std::optional<Processor> processor;
  Span span;
};

/// A state of a node or an object.
struct State {
  std::string name;
  Space space;
  bool settable = true;          // named in the graph; a node also has states that are never set
  bool tunes_running = false;    // can be set while an episode runs
  std::optional<Random> random;  // without: only set through the program's interface
  std::optional<Processor> processor;  // `space` is before it, as States holds it
  // objects only: the engine state that carries it out
  const Entity* engine_state = nullptr;
  Config config;
  Span span;
  /// The parameters of its owner.
  [[nodiscard]] const Space& received() const { return processor ? processor->output : space; }
};

enum class NodeRole : std::uint8_t { environment, engine, node, engine_node };

/// Everything that ticks.
struct GraphNode {
  std::string name;  // "smooth", "pendulum/theta", "environment", "engine"
  NodeRole role = NodeRole::node;
  const Entity* entity = nullptr;  // null for the environment
  Rational rate_hz;
  Config config;
  std::vector<Input> inputs;
  std::vector<Output> outputs;
  std::vector<State> states;
  std::vector<ResetTarget> reset_targets;  // of a reset node; others have none
  bool waits_during_reset = false;         // needs the environment's actions, which a reset has not
  bool drawn = false;                      // only pictures need it
  std::optional<std::size_t> object;       // engine nodes: whose
  Span span;

  [[nodiscard]] bool is_reset_node() const { return !reset_targets.empty(); }
  /// How the graph calls an output: each sensor that it is, "smooth.filtered", or "actions.u".
  [[nodiscard]] std::vector<std::string> ports_of(const Output& output) const;
};

/// A state of an object that the graph does not set: a reset keeps its value.
struct KeptState {
  std::string name;
  bool bounded = false;                  // its space has both bounds, so it could be sampled
  const Entity* engine_state = nullptr;  // what would set it
  Config config;
};

struct Object {
  std::string name;
  const Entity* entity = nullptr;
  const ObjectEngine* implementation = nullptr;
  Config config;
  std::vector<State> states;
  std::vector<KeptState> kept;
  Span span;
};

struct Agent {
  AgentSpec::Kind kind = AgentSpec::Kind::zero;
  std::string file;  // as written
  std::string path;  // where it is
  std::vector<std::size_t>
      observations;                   // policy: inputs of the environment, in the policy's order
  std::optional<std::string> output;  // policy: as written, else decided by the network
  std::optional<Spanned<Rational>> trained_at;  // policy: as written
  std::vector<std::string> other_files;         // statistics and known answers: where they are
  Span span;
};

/// The safe value of an observation of a graph without engine.
struct SafeOutput {
  std::size_t input = 0;      // of the environment
  std::vector<double> value;  // one for each element
  Space space;                // what leaves is within
  Rational hold_s;            // for which the last good one stays first
  bool holds_always = false;
  double ramp_per_s = 0.0;  // 0: at once
  Span span;
};

/// The safe values and when they apply; defaults filled in.
struct Safety {
  bool declared = false;
  std::uint32_t late = 1, missed = 2, recover = 3;  // instants in a row
  Rational max_lateness_s;                          // a period of the environment if none is given
  Rational link_timeout_s;
  Rational heartbeat_timeout_s;              // 0: never
  bool clips = true;                         // actions outside of their space
  bool holds = false;                        // the action before one that is not finite
  std::vector<std::vector<double>> actions;  // of the environment, a value for each element
  // Without an engine the observations leave to the world:
  std::vector<SafeOutput> outputs;
  std::vector<std::size_t> undeclared;  // observations that `outputs:` says nothing of
  std::vector<std::uint32_t> frozen;    // steps in a row, of each action; 0: never
  bool resets_nodes = true;             // when safe outputs are over
  Span span;
};

/// The applicable range of an action: the intersection of its space with those of its actuators.
struct AppliedAction {
  Space space;
  std::string narrowed_by;  // "pendulum.u"; empty if that is the action's own space
  Span span;
};

/// An expression of the task; its variables are the inputs of the task's node.
struct TaskExpression {
  std::string name, text;  // as written
  TypedExpression value;
  double weight = 1.0;  // of a term
  Span span;            // of the name
};

/// An input of a training's critic in addition to the observations: an input of the task, which
/// then has an output `critic_NAME`, or the initial value of a state.
struct CriticInput {
  std::string name;                  // "speed", "pendulum.mass"
  std::optional<std::size_t> input;  // of the task's node; without: a state
  Space space;
  bool sampled = true;  // a state: at each reset
  Span span;
};

/// Noise on an observation, which a SensorModel adds.
struct ObservationNoise {
  std::string observation, text;    // "angle", "0.01", "at most 0.1"
  std::optional<std::size_t> node;  // that adds it; without: real sensors have noise of their own
};

/// A state that a stage samples otherwise.
struct StageState {
  std::string name;                   // "pendulum.model_state"
  std::optional<std::size_t> object;  // its owner
  std::size_t node = 0;               // the same, if it is no object
  std::size_t state = 0;
  Random random;
};

/// A part of a training, before the graph as written. Programs ignore it.
struct Stage {
  std::string name;
  std::vector<StageState> states;
  std::vector<double> weights;                 // of all terms of the reward
  std::optional<double> success, mean_return;  // that end it
  Span span;
};

/// Reward and end of a step: a node at the rate of the environment, whose class is generated.
struct Task {
  std::size_t node = 0;
  std::vector<TaskExpression> terms;  // of the reward, in their order
  std::vector<TaskExpression> terminated, truncated, success;
  std::vector<ObservationNoise> noise;
  std::vector<CriticInput> critic;  // inputs in the order of their outputs, behind the terms
  std::vector<Stage> stages;        // of a training
  std::uint64_t after = 0;          // steps of an episode that is cut off; 0: none is
  std::uint64_t over_last = 1;      // steps in a row in which success must hold
  std::shared_ptr<const Entity> entity;
  Span span;
  /// "pendulum.model_state uniform from [0] to [1]; effort times -0.1; until success 0.9"
  [[nodiscard]] std::string describe(const Stage& stage) const;
  /// The first outputs of its node; the terms follow, then the critic's inputs.
  enum Output : std::uint8_t { reward, terminated_output, truncated_output, success_output, term };
};

/// The pictures of a program: a node without outputs.
struct Render {
  std::size_t node = 0;
  std::shared_ptr<const Entity> entity;
  Span span;
};

/// A message that boards send of themselves.
struct TelemetryChannel {
  std::size_t node = 0, output = 0;
  std::string port;  // as it is written: "pendulum.theta"
  Span span;
};
struct Telemetry {
  std::vector<TelemetryChannel> channels;
  Rational share = Rational(1, 2);  // of the line
  std::optional<Rational> rate_hz;  // most messages a second of a channel
  std::uint32_t baud = 115'200;
  Span span, baud_span;
};

/// A separate program for some nodes, linked to the program of the rest.
struct PlacedPart {
  std::string name;                // of its folder and in messages
  const Target* target = nullptr;  // a board, or Linux
  std::string host;                // the machine that it runs on; empty: this one, or a board
  Span span;
  std::string key;  // a file, for the line to that machine; empty: none
};
/// The parts of a star: the rest, the hub, runs on Linux and has a link to each part.
struct Placement {
  static constexpr std::size_t kHub = ~std::size_t{0};

  std::vector<PlacedPart> parts;
  std::vector<std::size_t>
      part_of;  // by node, or kHub; the environment's is where the agent decides
  [[nodiscard]] Span span() const { return parts.front().span; }
};

/// A port of nodes that were cut out of a larger graph.
struct CutPort {
  std::string name;                     // of the action or observation
  std::string sender;                   // as the graph calls it: "pendulum.theta"
  std::string channel;                  // of the whole graph's traces: "pendulum/theta/observation"
  Rational rate_hz;                     // of its messages
  std::optional<std::string> actuator;  // of an observation: what it drives, as it is
};
/// The facts of such a graph; its environment represents everything outside.
struct Cut {
  std::vector<CutPort> actions, observations;  // in the order of the environment's
  std::shared_ptr<const Entity> port;          // of nodes that take actions at slower rates
  std::vector<std::shared_ptr<const Entity>> generated;  // whose classes have this graph's name
};

struct Graph {
  std::string name;
  std::string path, file_name;  // of the graph file; file_name without folders
  bool double_precision = false;
  std::vector<GraphNode>
      nodes;  // [0] environment, [1] engine if there is one, then the others as written
  std::vector<Object> objects;
  Agent agent;
  Safety safety;
  std::vector<AppliedAction> applied;  // of each action
  std::optional<Placement> placement;  // without: one program
  std::optional<Task> task;
  std::optional<Render> render;
  std::optional<Telemetry> telemetry;
  std::optional<Cut> cut;
  /// For each port behind a composite's port, its name in the graph: "robot/meter.y" is "robot.v".
  std::multimap<std::string, std::string> composite_ports;
  bool asynchronous = false;  // inputs take what has arrived instead of counting
  Rational reset_timeout_s = Rational(60);
  std::vector<std::string> include_roots;  // further folders with headers, besides the built-in one
  Span span;

  static constexpr std::size_t kEnvironment = 0;
  static constexpr std::size_t kEngine = 1;
  [[nodiscard]] const GraphNode& environment() const { return nodes[kEnvironment]; }
  /// A graph of nodes alone has none.
  [[nodiscard]] bool has_engine() const {
    return nodes.size() > kEngine && nodes[kEngine].role == NodeRole::engine;
  }
  [[nodiscard]] const GraphNode& engine() const { return nodes[kEngine]; }
  /// The ports of composites that an output is: "robot.speed".
  [[nodiscard]] std::vector<std::string> aliases_of(const GraphNode& node,
                                                    const Output& output) const;
  /// Its id, or "none".
  [[nodiscard]] std::string engine_id() const {
    return has_engine() ? engine().entity->id.value : "none";
  }
  [[nodiscard]] bool has_reset_nodes() const {
    return ranges::any_of(nodes, &GraphNode::is_reset_node);
  }
};

/// Whether the classes of these also calculate with SIMD vectors, as their manifests say for
/// these parameters.
bool runs_vectorized(const GraphNode& node);
bool runs_vectorized(const Processor& processor);

/// Where an input's messages come from, as the graph calls it: "pendulum.theta",
/// "actions.voltage".
std::string name_of_source(const Graph& graph, const Input& input);

/// The settings of the command line.
struct ResolveOptions {
  std::string engine;                    // empty: the graph's
  std::string real;                      // empty: the graph's
  std::vector<PlacementSpec> placement;  // empty: the graph's
};

/// Puts the safe outputs of a graph without engine into `safety`; `written` is nullptr
/// where a graph says nothing. Problems: E0307, E0327, E0348.
void read_safe_outputs(const GraphNode& environment, const SafetySpec* written, Safety& safety,
                       Diagnostics& diagnostics);
/// Zero, moved into the space.
std::vector<double> zero_in(const Space& space);
/// The safe value of `name`, checked against its space (E0322, E0327), one number for each element;
/// nullopt if it is wrong.
std::optional<std::vector<double>> safe_value(const std::string& name, const Space& space,
                                              const YamlValue& yaml, Diagnostics& diagnostics);
void find_applied_spaces(Graph& graph);

/// Binds every name. All problems are reported, E03xx; nullopt if there was any.
std::optional<Graph> resolve(const GraphSpec& spec, const Library& library,
                             const ResolveOptions& options, Diagnostics& diagnostics);

}  // namespace eagerx::gen

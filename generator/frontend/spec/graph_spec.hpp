// The graph as written, with types, before lookup: no entity, space or port has been checked.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "generator/frontend/read/rational.hpp"
#include "generator/frontend/read/tree.hpp"
#include "generator/frontend/spec/budget_spec.hpp"
#include "generator/frontend/spec/format.hpp"
#include "generator/frontend/spec/render_spec.hpp"
#include "generator/frontend/spec/settings.hpp"
#include "generator/frontend/spec/task_spec.hpp"
#include "generator/frontend/spec/telemetry_spec.hpp"

namespace eagerx::gen {

/// Parts of a space; missing ones come from the other end of a connection or from a manifest.
struct SpaceSpec {
  Span span;
  std::optional<Spanned<std::string>> like;  // an input (manifests) or a port (actions)
  std::optional<Spanned<std::string>> dtype;
  std::optional<YamlValue> shape;
  std::optional<YamlValue> low;
  std::optional<YamlValue> high;
};

/// A sensor, actuator, input, output, action or observation that the user named, with its settings.
struct ComponentSpec {
  Spanned<std::string> name;
  std::optional<Spanned<Rational>> rate;
  std::optional<SpaceSpec> space;
  ConnectionSettings settings;  // as far as the table lets this kind of component have them
};

/// The components that are named; not there: as connected.
using Selection = std::optional<std::vector<ComponentSpec>>;

struct StateSpec {
  Spanned<std::string> name;
  std::optional<RandomSpec> random;  // without: only the program's interface sets it
  std::optional<ProcessorSpec> processor;
  std::optional<SpaceSpec> space = {};  // replaces the manifest's bounds
};

/// The source of decisions: the agent of a graph, or a node that runs a policy.
struct AgentSpec {
  enum class Kind : std::uint8_t { zero, random, csv, policy };
  Kind kind = Kind::zero;
  Span span;
  Spanned<std::string> file;
  std::vector<Spanned<std::string>> observations;  // order of the policy's inputs; empty: by name
  std::optional<Spanned<std::string>> output;      // squashed | raw | argmax | binary
  std::optional<Spanned<Rational>> trained_at;     // Hz, for files that do not say it
  std::optional<Spanned<bool>> normalize_actions;  // trained with actions from -1 to 1
  std::optional<Spanned<std::string>> normalize;   // file of statistics
  std::optional<Spanned<std::string>> activation;  // of hidden layers
  std::optional<Spanned<std::string>> output_activation;  // after the last layer
  std::optional<Spanned<bool>> state_dependent_std;       // half of the outputs are deviations
  std::vector<Spanned<std::string>> layers;               // of a table, in order, activations too
  std::vector<Spanned<std::int64_t>> input_sizes;         // of TorchScript
  std::optional<Spanned<std::string>> actor;              // how names of its tensors begin
  std::optional<Spanned<std::string>> output_name;        // of ONNX
  std::optional<Spanned<std::string>> golden;             // file of known answers
  std::optional<Spanned<std::string>> weights;            // float32 | int8
  std::optional<Spanned<double>> max_error;               // of an output, against float32
  std::optional<Spanned<std::string>> profile;            // exact | fast
};

/// An engine, object or node of the graph, or an engine node of a manifest.
struct EntitySpec {
  Spanned<std::string> name;
  Spanned<std::string> type;
  std::optional<QuantitySpec> rate;
  std::vector<Setting> config;
  std::vector<StateSpec> states;
  Selection sensors, actuators, inputs, outputs;
  // A node that runs a weight file; its type is then one that no manifest can have.
  std::optional<AgentSpec> policy = {};
};

struct ConnectionSpec {
  Span span;
  Spanned<std::string> from;
  Spanned<std::string> to;
  ConnectionSettings settings;
};

/// The safe value of an observation of a graph without engine.
struct SafeOutputSpec {
  Spanned<std::string> name;
  Span span;             // of what was written
  bool is_free = false;  // `none`: it leaves as the nodes made it
  std::optional<YamlValue> value, low, high;
  std::optional<Spanned<Rational>> hold_s;
  bool holds_always = false;
  std::optional<double> ramp_per_s;
};

/// The safe values and when they apply; the defaults are `safety_defaults`.
struct SafetySpec {
  Span span;
  std::optional<Span> outputs_span;
  bool no_outputs = false;  // `outputs: none`
  std::vector<SafeOutputSpec> outputs;
  std::vector<Setting> frozen;     // by action: a number of steps
  std::vector<Setting> actions;    // by name: a number or a list
  std::vector<Setting> actuators;  // by object.actuator
  std::vector<Setting> settings;   // the others, by key
};

/// A part with its own program.
struct PlacementSpec {
  Spanned<std::string> name;    // of a node, `agent` or `controller`
  Spanned<std::string> target;  // that the part is a program for
  Spanned<std::string> part;    // its name; empty: its host's, or its target's
  Spanned<std::string> host;    // the machine; empty: this one, or a board
  Spanned<std::string> key;     // a file in the graph's folder; empty: none
};

/// A node or an object that contains others; the flat graph has only its contents.
struct CompositeSpec {
  std::string name;                 // "arm/shoulder"
  std::string type, about;          // id and summary of its manifest
  std::optional<Rational> rate_hz;  // where it has one
  bool is_object = false;
  /// Its ports, and the corresponding ports of the flat graph: "arm/shoulder/position.setpoint".
  std::vector<std::pair<std::string, std::vector<std::string>>> inputs, outputs;
  Span span;
};

struct GraphSpec {
  FileId file = FileId::none;
  std::string path;
  Spanned<std::string> name;
  Spanned<Rational> rate;
  std::string real = "float";
  std::vector<Spanned<std::string>> library;
  std::optional<Spanned<Rational>> reset_timeout_s;  // of reset nodes
  std::optional<Spanned<bool>> simulate_delays;      // of the engine; default true
  std::optional<Spanned<bool>> sync;                 // of the engine; default true
  EntitySpec engine;  // without a type: a graph of nodes alone has none
  std::vector<EntitySpec> objects;
  std::vector<EntitySpec> nodes;
  std::vector<ComponentSpec> actions;
  std::vector<ComponentSpec> observations;
  std::vector<ConnectionSpec> connections;
  AgentSpec agent;
  std::optional<SafetySpec> safety;
  std::optional<TaskSpec> task;      // its inputs are among the connections
  std::optional<RenderSpec> render;  // its source is among the connections
  std::optional<TelemetrySpec> telemetry;
  std::optional<BudgetSpec> budget;
  std::vector<PlacementSpec> placement;
  std::vector<Spanned<std::string>> allow;  // codes of warnings
  std::vector<CompositeSpec> composites;    // what pictures show besides

  [[nodiscard]] bool has_engine() const { return !engine.type.value.empty(); }
};

/// Most elements of an array.
inline constexpr std::int64_t kLongestArray = 10'000;

/// The table of the graph file; `flat`: that of the result of `compose/`, with names such as
/// `arm/leg[2]`.
enum class GraphForm : std::uint8_t { written, flat };
const Format& graph_format(GraphForm form = GraphForm::written);
/// Of one of its entities.
FormatPtr object_format();
FormatPtr node_format();

/// Keys of `safety:` that have a default, and the number or the word that it is.
struct SafetyDefault {
  const char* key;
  std::variant<ComputedNumber, const char*> value;
};
const std::vector<SafetyDefault>& safety_defaults();

/// Typed form of a tree; all problems are reported. nullopt if the tree does not have the form of
/// the table; after other problems (E0206) there is still enough to look for more.
std::optional<GraphSpec> read_graph_spec(const YamlValue& root, const std::string& path,
                                         Diagnostics& diagnostics,
                                         GraphForm form = GraphForm::written);
/// A manifest instead of a graph: E0210.
bool refuse_manifest(const YamlValue& root, Diagnostics& diagnostics);

// Pieces that manifests are written in too.
enum class ReferenceRule : std::uint8_t {
  refuse,
  accept
};  // whether `$(config x)` may stand for a number
FormatPtr space_format(ReferenceRule references, bool like);
FormatPtr connections_format();
/// Of a connection, or of an input.
std::vector<Field> connection_settings();
FormatPtr node_policy_format();
FormatPtr agent_format();
FormatPtr engine_nodes_format();
FormatPtr safety_format();
FormatPtr task_format();
/// The distribution of a state alone.
FormatPtr distribution_format();
FormatPtr telemetry_format();
FormatPtr budget_format();
FormatPtr config_format();
FormatPtr processor_format();
SpaceSpec read_space(const YamlValue& yaml);
std::vector<ConnectionSpec> read_connections(const YamlValue* yaml, Diagnostics& diagnostics);
EntitySpec read_entity(const std::string& name, Span span, const YamlValue& yaml,
                       Diagnostics& diagnostics);

}  // namespace eagerx::gen

#include "generator/frontend/spec/graph_spec.hpp"

#include <fmt/format.h>

#include "generator/frontend/read/number.hpp"
#include "generator/frontend/read/scalar.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/support/diagnostics/search.hpp"

// Everything here runs on a tree that `check` has accepted, so kinds and numbers are known to be
// right.
namespace eagerx::gen {
namespace {

constexpr const char* kFreeOutput = "none";
constexpr const char* kHoldAlways = "always";

Spanned<std::string> spanned_text(const YamlValue& yaml) {
  return {yaml.text, yaml.span};
}

template <class T, class Convert>
std::optional<Spanned<T>> optional_of(const YamlValue& yaml, const char* key, Convert&& convert) {
  const YamlValue* value = yaml.find(key);
  if (value == nullptr) return std::nullopt;
  return Spanned<T>{convert(*value), value->span};
}

Rational rational_of(const YamlValue& yaml) {
  return exact_of(yaml).value_or(Rational{});
}
bool bool_of(const YamlValue& yaml) {
  return parse_bool(yaml.text).value_or(false);
}

ComponentSpec read_component(const std::string& name, Span span, const YamlValue& settings,
                             Diagnostics& diagnostics) {
  ComponentSpec spec;
  spec.name = {name, span};
  spec.rate = optional_of<Rational>(settings, "rate", rational_of);
  if (const YamlValue* space = settings.find("space")) spec.space = read_space(*space);
  spec.settings = read_connection_settings(settings, diagnostics);
  return spec;
}

std::vector<ComponentSpec> read_selection(const YamlValue& yaml, Diagnostics& diagnostics) {
  std::vector<ComponentSpec> result;
  for (const auto& entry : yaml.entries) {
    result.push_back(read_component(entry.key, entry.key_span, entry.value, diagnostics));
  }
  for (const auto& item : yaml.items) {
    if (const ComponentSpec* earlier = find_named(result, item.text)) {
      diagnostics.error("E0206", item.span, fmt::format("`{}` is listed twice", item.text))
          .notes.push_back({"first here", earlier->name.span, ""});
      continue;
    }
    result.push_back(read_component(item.text, item.span, YamlValue{}, diagnostics));
  }
  return result;
}

Selection read_optional_selection(const YamlValue& yaml, const char* key,
                                  Diagnostics& diagnostics) {
  const YamlValue* selection = yaml.find(key);
  if (selection == nullptr) return std::nullopt;
  return read_selection(*selection, diagnostics);
}

void read_policy_settings(const YamlValue& yaml, AgentSpec& spec) {
  const auto text = [](const YamlValue& n) { return n.text; };
  spec.output = optional_of<std::string>(yaml, "output", text);
  spec.trained_at = optional_of<Rational>(yaml, "trained_at", rational_of);
  spec.normalize_actions = optional_of<bool>(yaml, "normalize_actions", bool_of);
  spec.normalize = optional_of<std::string>(yaml, "normalize", text);
  spec.activation = optional_of<std::string>(yaml, "activation", text);
  spec.output_activation = optional_of<std::string>(yaml, "output_activation", text);
  spec.state_dependent_std = optional_of<bool>(yaml, "state_dependent_std", bool_of);
  if (const YamlValue* layers = yaml.find("layers")) {
    for (const auto& item : layers->items) spec.layers.push_back(spanned_text(item));
  }
  if (const YamlValue* sizes = yaml.find("input_sizes")) {
    for (const auto& item : sizes->items) {
      spec.input_sizes.push_back({whole_of(item).value_or(0), item.span});
    }
  }
  spec.actor = optional_of<std::string>(yaml, "actor", text);
  spec.output_name = optional_of<std::string>(yaml, "output_name", text);
  spec.golden = optional_of<std::string>(yaml, "golden", text);
  spec.weights = optional_of<std::string>(yaml, "weights", text);
  spec.profile = optional_of<std::string>(yaml, "profile", text);
  spec.max_error = optional_of<double>(
      yaml, "max_error", [](const YamlValue& n) { return rational_of(n).to_double(); });
}

AgentSpec read_agent(const YamlValue* yaml, Diagnostics& diagnostics) {
  AgentSpec spec;
  if (yaml == nullptr) return spec;
  spec.span = yaml->span;
  if (yaml->is_scalar()) {
    spec.kind = yaml->text == "random" ? AgentSpec::Kind::random : AgentSpec::Kind::zero;
    return spec;
  }
  const YamlValue* policy = yaml->find("policy");
  const YamlValue* csv = yaml->find("csv");
  if ((policy == nullptr) == (csv == nullptr)) {
    diagnostics.error("E0206", yaml->span, "an agent has either a `policy` or a `csv`");
    return spec;
  }
  spec.kind = policy != nullptr ? AgentSpec::Kind::policy : AgentSpec::Kind::csv;
  spec.file = spanned_text(policy != nullptr ? *policy : *csv);
  for (const char* key :
       {"observations", "output", "trained_at", "normalize_actions", "normalize", "activation",
        "output_activation", "state_dependent_std", "layers", "input_sizes", "actor", "output_name",
        "golden", "weights", "max_error", "profile"}) {
    if (csv == nullptr || yaml->find(key) == nullptr) continue;
    diagnostics.error("E0206", yaml->find(key)->span,
                      fmt::format("`{}` goes with a `policy`, not with a `csv`", key));
  }
  if (const YamlValue* order = yaml->find("observations")) {
    for (const auto& item : order->items) spec.observations.push_back(spanned_text(item));
  }
  read_policy_settings(*yaml, spec);
  return spec;
}

/// A node's own policy: `policy: FILE` or `policy: {file: FILE, …}`.
AgentSpec read_node_policy(const YamlValue& yaml) {
  AgentSpec spec;
  spec.kind = AgentSpec::Kind::policy;
  spec.span = yaml.span;
  spec.file = spanned_text(yaml.is_scalar() ? yaml : *yaml.find("file"));
  if (!yaml.is_scalar()) read_policy_settings(yaml, spec);
  return spec;
}

/// Help for a node that says nothing of what it runs: perhaps a variant means another of `nodes`.
Help help_for_nothing_to_run(const std::string& name, const YamlValue& nodes) {
  std::vector<std::string> others;
  for (const auto& other : nodes.entries)
    if (other.value.find("type") != nullptr || other.value.find("policy") != nullptr)
      others.push_back(other.key);
  return did_you_mean_or(name, others,
                         "add `type: NODE` (`eagerx-gen info` lists them) or `policy: FILE`");
}

/// Of one of the `nodes` of the graph: what it runs. A mistake leaves a type that nothing more is
/// said of.
void read_what_runs(const YamlValue& yaml, const YamlValue& nodes, EntitySpec& spec,
                    Diagnostics& diagnostics) {
  const YamlValue* type = yaml.find("type");
  const YamlValue* policy = yaml.find("policy");
  if (policy != nullptr) {
    spec.policy = read_node_policy(*policy);
    spec.type = {"policy of " + spec.name.value, spec.policy->file.span};  // no manifest's id
  }
  if ((type == nullptr) == (policy == nullptr)) {
    diagnostics
        .error("E0206", spec.name.span,
               fmt::format("`{}` needs either a `type` or a `policy`", spec.name.value))
        .help =
        type == nullptr ? help_for_nothing_to_run(spec.name.value, nodes) : "leave one of them out";
  }
}

SafeOutputSpec read_safe_output(const YamlValue::Entry& entry) {
  SafeOutputSpec spec;
  spec.name = {entry.key, entry.key_span};
  const YamlValue& yaml = entry.value;
  spec.span = yaml.is_null() ? entry.key_span : yaml.span;
  if (yaml.is_map()) {
    spec.value = value_at(yaml, "value");
    spec.low = value_at(yaml, "low");
    spec.high = value_at(yaml, "high");
    if (const YamlValue* ramp = yaml.find("ramp")) spec.ramp_per_s = real_of(*ramp);
    const YamlValue* hold = yaml.find("hold");
    spec.holds_always = hold != nullptr && hold->text == kHoldAlways;
    if (!spec.holds_always) spec.hold_s = optional_of<Rational>(yaml, "hold", rational_of);
  } else {
    spec.is_free = yaml.is_scalar() && yaml.text == kFreeOutput;
    if (!spec.is_free && !yaml.is_null()) spec.value = yaml;
  }
  return spec;
}

void read_safe_outputs(const YamlValue& yaml, Span key, SafetySpec& spec) {
  spec.outputs_span = key;
  spec.no_outputs = yaml.is_scalar();
  for (const auto& entry : yaml.entries) spec.outputs.push_back(read_safe_output(entry));
}

std::optional<SafetySpec> read_safety(const YamlValue* yaml) {
  if (yaml == nullptr) return std::nullopt;
  SafetySpec spec;
  spec.span = yaml->span;
  spec.actions = read_config(yaml->find("actions"));
  spec.actuators = read_config(yaml->find("actuators"));
  spec.frozen = read_config(yaml->find("frozen"));
  const auto outputs = ranges::find(yaml->entries, "outputs", &YamlValue::Entry::key);
  if (outputs != yaml->entries.end()) read_safe_outputs(outputs->value, outputs->key_span, spec);
  for (const auto& setting : read_config(yaml)) {
    const std::string& key = setting.name;
    if (key != "actions" && key != "actuators" && key != "outputs" && key != "frozen")
      spec.settings.push_back(setting);
  }
  return spec;
}

/// The task; its inputs become connections, so that whatever looks at these sees them too.
void read_task(const YamlValue::Entry& entry, GraphSpec& spec, Diagnostics& diagnostics) {
  spec.task = read_task_spec(entry.value, diagnostics);
  spec.task->span = entry.key_span;
  for (const TaskInputSpec& input : spec.task->inputs) {
    ConnectionSpec connection;
    connection.span = input.name.span;
    connection.from = input.from;
    connection.to = {fmt::format("{}.{}", kTask, input.name.value), input.name.span};
    connection.settings.processor = input.processor;
    spec.connections.push_back(std::move(connection));
  }
}

std::vector<RenderKey> read_keys(const YamlValue& yaml) {
  std::vector<RenderKey> keys;
  for (const auto& entry : yaml.entries) {
    RenderKey& key = keys.emplace_back();
    key.key = {entry.key, entry.key_span};
    key.parameter = spanned_text(*entry.value.find("parameter"));
    const YamlValue& add = *entry.value.find("add");
    for (const YamlValue& number : add.items) key.add.push_back(real_of(number).value_or(0.0));
    if (add.is_scalar()) key.add.push_back(real_of(add).value_or(0.0));
  }
  return keys;
}

/// The picture's input; its source becomes a connection, as an input of the task does.
void read_render(const YamlValue::Entry& entry, GraphSpec& spec) {
  RenderSpec render;
  render.span = entry.key_span;
  render.source = spanned_text(*entry.value.find("source"));
  render.rate = optional_of<Rational>(entry.value, "rate", rational_of);
  if (const YamlValue* keys = entry.value.find("keys")) render.keys = read_keys(*keys);
  ConnectionSpec connection;
  connection.span = entry.key_span;
  connection.from = render.source;
  connection.to = {fmt::format("{}.source", kRender), render.source.span};
  spec.connections.push_back(std::move(connection));
  spec.render = std::move(render);
}

TelemetrySpec read_telemetry(const YamlValue::Entry& entry) {
  TelemetrySpec telemetry;
  telemetry.span = entry.key_span;
  for (const auto& item : entry.value.find("channels")->items)
    telemetry.channels.push_back(spanned_text(item));
  telemetry.share = optional_of<Rational>(entry.value, "share", rational_of);
  telemetry.rate = optional_of<Rational>(entry.value, "rate", rational_of);
  telemetry.baud = optional_of<Rational>(entry.value, "baud", rational_of);
  return telemetry;
}

}  // namespace

SpaceSpec read_space(const YamlValue& yaml) {
  const auto text = [](const YamlValue& n) { return n.text; };
  SpaceSpec spec;
  spec.span = yaml.span;
  spec.like = optional_of<std::string>(yaml, "like", text);
  spec.dtype = optional_of<std::string>(yaml, "dtype", text);
  spec.shape = value_at(yaml, "shape");
  spec.low = value_at(yaml, "low");
  spec.high = value_at(yaml, "high");
  return spec;
}

std::vector<ConnectionSpec> read_connections(const YamlValue* yaml, Diagnostics& diagnostics) {
  std::vector<ConnectionSpec> result;
  if (yaml == nullptr) return result;
  for (const auto& item : yaml->items) {
    ConnectionSpec spec;
    spec.span = item.span;
    spec.from = spanned_text(*item.find("from"));
    spec.to = spanned_text(*item.find("to"));
    spec.settings = read_connection_settings(item, diagnostics);
    result.push_back(std::move(spec));
  }
  return result;
}

EntitySpec read_entity(const std::string& name, Span span, const YamlValue& yaml,
                       Diagnostics& diagnostics) {
  EntitySpec spec;
  spec.name = {name, span};
  if (const YamlValue* type = yaml.find("type")) spec.type = spanned_text(*type);
  if (const YamlValue* rate = yaml.find("rate")) spec.rate = read_quantity(*rate);
  spec.config = read_config(yaml.find("config"));
  if (const YamlValue* states = yaml.find("states")) {
    for (const auto& entry : states->entries) {
      StateSpec state{{entry.key, entry.key_span}, std::nullopt, std::nullopt};
      if (!entry.value.is_null()) state.random = read_random(entry.value, diagnostics);
      if (const YamlValue* processor = entry.value.find("processor"))
        state.processor = read_processor(*processor);
      if (const YamlValue* space = entry.value.find("space")) state.space = read_space(*space);
      spec.states.push_back(std::move(state));
    }
  }
  spec.sensors = read_optional_selection(yaml, "sensors", diagnostics);
  spec.actuators = read_optional_selection(yaml, "actuators", diagnostics);
  spec.inputs = read_optional_selection(yaml, "inputs", diagnostics);
  spec.outputs = read_optional_selection(yaml, "outputs", diagnostics);
  return spec;
}

namespace {

/// How a graph uses an entity with a manifest of this kind.
std::string use_in_graph(const std::string& kind, const std::string& id) {
  if (kind == "object") return fmt::format("`objects: {{NAME: {{type: {}}}}}`", id);
  if (kind == "node" || kind == "reset_node")
    return fmt::format("`nodes: {{NAME: {{type: {}, rate: …}}}}`", id);
  if (kind == "engine") return fmt::format("`engine: {{type: {}, rate: …}}`", id);
  if (kind == "processor") return fmt::format("`processor: {}` on a connection", id);
  return {};
}

}  // namespace

/// A manifest has keys that no graph has. Nothing else needs to be said of it.
bool refuse_manifest(const YamlValue& root, Diagnostics& diagnostics) {
  const YamlValue* kind = root.is_map() ? root.find("kind") : nullptr;
  const YamlValue* id = kind != nullptr ? root.find("id") : nullptr;
  const bool apart = kind != nullptr && root.find("object") != nullptr;  // an implementation
  if (kind == nullptr || !kind->is_scalar() || (id == nullptr && !apart)) return false;
  auto& problem = diagnostics.error("E0210", kind->span,
                                    fmt::format("this is the manifest of {} `{}`, not a graph",
                                                kind->text, (id != nullptr ? *id : *kind).text));
  const std::string use = id != nullptr ? use_in_graph(kind->text, id->text) : "";
  problem.help = use.empty() ? "give the graph that uses it; `eagerx-gen info` reads manifests"
                             : fmt::format("give a graph that uses it: {}", use);
  return true;
}

PlacementSpec read_placement(const YamlValue::Entry& entry) {
  PlacementSpec item;
  item.name = {entry.key, entry.key_span};
  if (!entry.value.is_map()) {
    item.target = spanned_text(entry.value);
    return item;
  }
  item.target = {"linux-sim", entry.value.span};
  const auto take = [&](const char* key, Spanned<std::string>& into) {
    if (const YamlValue* value = entry.value.find(key)) into = spanned_text(*value);
  };
  take("target", item.target);
  take("part", item.part);
  take("host", item.host);
  take("key", item.key);
  return item;
}

std::optional<GraphSpec> read_graph_spec(const YamlValue& written, const std::string& path,
                                         Diagnostics& diagnostics, GraphForm form) {
  if (refuse_manifest(written, diagnostics)) return std::nullopt;
  if (!check(written, graph_format(form), diagnostics)) return std::nullopt;
  const YamlValue root = in_base_units(written, graph_format(form));
  GraphSpec spec;
  spec.file = root.span.file;
  spec.path = path;
  spec.name = spanned_text(*root.find("name"));
  spec.rate = {rational_of(*root.find("rate")), root.find("rate")->span};
  if (const YamlValue* real = root.find("real")) spec.real = real->text;
  if (const YamlValue* library = root.find("library")) {
    for (const auto& item : library->items) spec.library.push_back(spanned_text(item));
  }
  const auto engine = ranges::find(root.entries, "engine", &YamlValue::Entry::key);
  if (engine != root.entries.end()) {
    spec.engine = read_entity("engine", engine->key_span, engine->value, diagnostics);
    spec.simulate_delays = optional_of<bool>(engine->value, "simulate_delays", bool_of);
    spec.sync = optional_of<bool>(engine->value, "sync", bool_of);
  }
  spec.reset_timeout_s = optional_of<Rational>(root, "reset_timeout", rational_of);
  const auto read_all = [&](const char* key, std::vector<EntitySpec>& into) {
    const YamlValue* map = root.find(key);
    if (map == nullptr) return;
    for (const auto& entry : map->entries) {
      into.push_back(read_entity(entry.key, entry.key_span, entry.value, diagnostics));
      if (&into == &spec.nodes) read_what_runs(entry.value, *map, into.back(), diagnostics);
    }
  };
  read_all("objects", spec.objects);
  read_all("nodes", spec.nodes);
  spec.actions = read_selection(*root.find("actions"), diagnostics);
  spec.observations = read_selection(*root.find("observations"), diagnostics);
  spec.connections = read_connections(root.find("connections"), diagnostics);
  spec.agent = read_agent(root.find("agent"), diagnostics);
  spec.safety = read_safety(root.find("safety"));
  const auto task = ranges::find(root.entries, kTask, &YamlValue::Entry::key);
  if (task != root.entries.end()) read_task(*task, spec, diagnostics);
  const auto render = ranges::find(root.entries, kRender, &YamlValue::Entry::key);
  if (render != root.entries.end()) read_render(*render, spec);
  const auto telemetry = ranges::find(root.entries, kTelemetry, &YamlValue::Entry::key);
  if (telemetry != root.entries.end()) spec.telemetry = read_telemetry(*telemetry);
  if (const YamlValue* budget = root.find("budget")) spec.budget = read_budget(*budget);
  if (const YamlValue* allow = root.find("allow")) {
    for (const auto& item : allow->items) spec.allow.push_back(spanned_text(item));
  }
  if (const YamlValue* placement = root.find("placement")) {
    for (const auto& entry : placement->entries) spec.placement.push_back(read_placement(entry));
  }
  return spec;
}

}  // namespace eagerx::gen

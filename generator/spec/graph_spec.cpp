#include "generator/spec/graph_spec.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/read/scalar.hpp"

// Everything here runs on a tree that `check` has accepted, so kinds and numbers are known to be
// right.
namespace eagerx::gen {
namespace {

Spanned<std::string> text_of(const Node& node) {
  return {node.text, node.span};
}

template <class T, class Convert>
std::optional<Spanned<T>> optional_of(const Node& node, const char* key, Convert&& convert) {
  const Node* value = node.find(key);
  if (value == nullptr) return std::nullopt;
  return Spanned<T>{convert(*value), value->span};
}

Rational rational_of(const Node& node) {
  return Rational::parse(node.text).value_or(Rational{});
}
std::uint32_t count_of(const Node& node) {
  return static_cast<std::uint32_t>(parse_int(node.text).value_or(0));
}
bool bool_of(const Node& node) {
  return parse_bool(node.text).value_or(false);
}

ProcessorSpec read_processor(const Node& node) {
  if (node.is_scalar()) return {text_of(node), {}};
  return {text_of(*node.find("type")), read_config(node.find("config"))};
}

/// nullopt if nothing is said of the value.
std::optional<RandomSpec> read_random(const Node& node, Diagnostics& diagnostics);

template <class Spec>
void read_delay(const Node& node, Spec& spec, Diagnostics& diagnostics) {
  if (node.is_scalar()) {
    spec.delay_s = Spanned<Rational>{rational_of(node), node.span};
  } else {
    spec.random_delay = read_random(node, diagnostics);
  }
}

template <class Spec>
void read_connection_settings(const Node& node, Spec& spec, Diagnostics& diagnostics) {
  spec.window = optional_of<std::uint32_t>(node, "window", count_of);
  if (const Node* delay = node.find("delay")) read_delay(*delay, spec, diagnostics);
  spec.max_delay_s = optional_of<Rational>(node, "max_delay", rational_of);
  spec.skip = optional_of<bool>(node, "skip", bool_of);
  if (const Node* processor = node.find("processor")) spec.processor = read_processor(*processor);
}

ComponentSpec read_component(const std::string& name, Span span, const Node& settings,
                             Diagnostics& diagnostics) {
  ComponentSpec spec;
  spec.name = {name, span};
  spec.rate = optional_of<Rational>(settings, "rate", rational_of);
  if (const Node* space = settings.find("space")) spec.space = read_space(*space);
  read_connection_settings(settings, spec, diagnostics);
  return spec;
}

std::vector<ComponentSpec> read_selection(const Node& node, Diagnostics& diagnostics) {
  std::vector<ComponentSpec> result;
  for (const auto& entry : node.entries) {
    result.push_back(read_component(entry.key, entry.key_span, entry.value, diagnostics));
  }
  for (const auto& item : node.items) {
    const auto earlier = std::find_if(result.begin(), result.end(), [&](const ComponentSpec& c) {
      return c.name.value == item.text;
    });
    if (earlier != result.end()) {
      diagnostics.error("E0206", item.span, fmt::format("`{}` is listed twice", item.text))
          .notes.push_back({"first here", earlier->name.span, ""});
      continue;
    }
    result.push_back(read_component(item.text, item.span, Node{}, diagnostics));
  }
  return result;
}

std::optional<std::vector<ComponentSpec>> read_optional_selection(const Node& node, const char* key,
                                                                  Diagnostics& diagnostics) {
  const Node* selection = node.find(key);
  if (selection == nullptr) return std::nullopt;
  return read_selection(*selection, diagnostics);
}

std::optional<RandomSpec> read_random(const Node& node, Diagnostics& diagnostics) {
  RandomSpec spec;
  spec.span = node.span;
  if (node.is_scalar()) return spec;  // uniform in its space
  std::vector<const Node::Entry*> ways;
  for (const auto& entry : node.entries) {
    if (entry.key != "processor" && entry.key != "space") ways.push_back(&entry);
  }
  if (ways.empty() && !node.entries.empty()) return std::nullopt;
  if (ways.size() != 1) {
    diagnostics.error("E0206", node.span, "a value is drawn in exactly one way").help =
        "write one of value, uniform, normal, log_uniform, choice";
    return std::nullopt;
  }
  const auto& [key, key_span, value] = *ways.front();
  spec.span = key_span;
  if (key == "value" || key == "choice") {
    spec.kind = key == "value" ? RandomSpec::Kind::value : RandomSpec::Kind::choice;
    spec.first = value;
    return spec;
  }
  if (value.is_scalar()) return spec;  // `uniform: space`
  const bool normal = key == "normal";
  spec.kind = normal
                  ? RandomSpec::Kind::normal
                  : (key == "uniform" ? RandomSpec::Kind::uniform : RandomSpec::Kind::log_uniform);
  spec.first = *value.find(normal ? "mean" : "low");
  spec.second = *value.find(normal ? "std" : "high");
  return spec;
}

void read_policy_settings(const Node& node, AgentSpec& spec) {
  const auto text = [](const Node& n) { return n.text; };
  spec.output = optional_of<std::string>(node, "output", text);
  spec.normalize = optional_of<std::string>(node, "normalize", text);
  spec.activation = optional_of<std::string>(node, "activation", text);
  spec.golden = optional_of<std::string>(node, "golden", text);
  spec.weights = optional_of<std::string>(node, "weights", text);
  spec.profile = optional_of<std::string>(node, "profile", text);
  spec.max_error = optional_of<double>(node, "max_error",
                                       [](const Node& n) { return rational_of(n).to_double(); });
}

AgentSpec read_agent(const Node* node, Diagnostics& diagnostics) {
  AgentSpec spec;
  if (node == nullptr) return spec;
  spec.span = node->span;
  if (node->is_scalar()) {
    spec.kind = node->text == "random" ? AgentSpec::Kind::random : AgentSpec::Kind::zero;
    return spec;
  }
  const Node* policy = node->find("policy");
  const Node* csv = node->find("csv");
  if ((policy == nullptr) == (csv == nullptr)) {
    diagnostics.error("E0206", node->span, "an agent has either a `policy` or a `csv`");
    return spec;
  }
  spec.kind = policy != nullptr ? AgentSpec::Kind::policy : AgentSpec::Kind::csv;
  spec.file = text_of(policy != nullptr ? *policy : *csv);
  for (const char* key : {"observations", "output", "normalize", "activation", "golden", "weights",
                          "max_error", "profile"}) {
    if (csv == nullptr || node->find(key) == nullptr) continue;
    diagnostics.error("E0206", node->find(key)->span,
                      fmt::format("`{}` goes with a `policy`, not with a `csv`", key));
  }
  if (const Node* order = node->find("observations")) {
    for (const auto& item : order->items) spec.observations.push_back(text_of(item));
  }
  read_policy_settings(*node, spec);
  return spec;
}

/// A node's own policy: `policy: FILE` or `policy: {file: FILE, …}`.
AgentSpec read_node_policy(const Node& node) {
  AgentSpec spec;
  spec.kind = AgentSpec::Kind::policy;
  spec.span = node.span;
  spec.file = text_of(node.is_scalar() ? node : *node.find("file"));
  if (!node.is_scalar()) read_policy_settings(node, spec);
  return spec;
}

/// Of a node of the graph: what it runs. A mistake leaves a type that nothing more is said of.
void read_what_runs(const Node& node, EntitySpec& spec, Diagnostics& diagnostics) {
  const Node* type = node.find("type");
  const Node* policy = node.find("policy");
  if (policy != nullptr) {
    spec.policy = read_node_policy(*policy);
    spec.type = {"policy of " + spec.name.value, spec.policy->file.span};  // no manifest's id
  }
  if ((type == nullptr) == (policy == nullptr)) {
    diagnostics.error("E0206", spec.name.span,
                      fmt::format("`{}` needs either a `type` or a `policy`", spec.name.value));
  }
}

std::optional<SafetySpec> read_safety(const Node* node) {
  if (node == nullptr) return std::nullopt;
  SafetySpec spec;
  spec.span = node->span;
  spec.actions = read_config(node->find("actions"));
  spec.actuators = read_config(node->find("actuators"));
  for (const auto& setting : read_config(node)) {
    if (setting.name != "actions" && setting.name != "actuators") spec.settings.push_back(setting);
  }
  return spec;
}

}  // namespace

SpaceSpec read_space(const Node& node) {
  const auto text = [](const Node& n) { return n.text; };
  SpaceSpec spec;
  spec.span = node.span;
  spec.like = optional_of<std::string>(node, "like", text);
  spec.dtype = optional_of<std::string>(node, "dtype", text);
  const auto copy = [&](const char* key) {
    const Node* value = node.find(key);
    return value != nullptr ? std::optional<Node>(*value) : std::nullopt;
  };
  spec.shape = copy("shape");
  spec.low = copy("low");
  spec.high = copy("high");
  return spec;
}

std::vector<Setting> read_config(const Node* node) {
  std::vector<Setting> result;
  if (node == nullptr) return result;
  for (const auto& entry : node->entries)
    result.push_back({entry.key, entry.key_span, entry.value});
  return result;
}

std::vector<ConnectionSpec> read_connections(const Node* node, Diagnostics& diagnostics) {
  std::vector<ConnectionSpec> result;
  if (node == nullptr) return result;
  for (const auto& item : node->items) {
    ConnectionSpec spec;
    spec.span = item.span;
    spec.from = text_of(*item.find("from"));
    spec.to = text_of(*item.find("to"));
    read_connection_settings(item, spec, diagnostics);
    result.push_back(std::move(spec));
  }
  return result;
}

EntitySpec read_entity(const std::string& name, Span span, const Node& node,
                       Diagnostics& diagnostics) {
  EntitySpec spec;
  spec.name = {name, span};
  if (const Node* type = node.find("type")) spec.type = text_of(*type);
  if (const Node* rate = node.find("rate")) spec.rate = Spanned<Node>{*rate, rate->span};
  spec.config = read_config(node.find("config"));
  if (const Node* states = node.find("states")) {
    for (const auto& entry : states->entries) {
      StateSpec state{{entry.key, entry.key_span}, std::nullopt, std::nullopt};
      if (!entry.value.is_null()) state.random = read_random(entry.value, diagnostics);
      if (const Node* processor = entry.value.find("processor"))
        state.processor = read_processor(*processor);
      if (const Node* space = entry.value.find("space")) state.space = read_space(*space);
      spec.states.push_back(std::move(state));
    }
  }
  spec.sensors = read_optional_selection(node, "sensors", diagnostics);
  spec.actuators = read_optional_selection(node, "actuators", diagnostics);
  spec.inputs = read_optional_selection(node, "inputs", diagnostics);
  spec.outputs = read_optional_selection(node, "outputs", diagnostics);
  return spec;
}

std::optional<GraphSpec> read_graph_spec(const Node& root, const std::string& path,
                                         Diagnostics& diagnostics) {
  if (!check(root, graph_format(), diagnostics)) return std::nullopt;
  GraphSpec spec;
  spec.file = root.span.file;
  spec.path = path;
  spec.name = text_of(*root.find("name"));
  spec.rate = {rational_of(*root.find("rate")), root.find("rate")->span};
  if (const Node* real = root.find("real")) spec.real = real->text;
  if (const Node* library = root.find("library")) {
    for (const auto& item : library->items) spec.library.push_back(text_of(item));
  }
  const auto engine = std::find_if(root.entries.begin(), root.entries.end(),
                                   [](const Node::Entry& entry) { return entry.key == "engine"; });
  spec.engine = read_entity("engine", engine->key_span, engine->value, diagnostics);
  spec.simulate_delays = optional_of<bool>(engine->value, "simulate_delays", bool_of);
  spec.sync = optional_of<bool>(engine->value, "sync", bool_of);
  spec.reset_timeout_s = optional_of<Rational>(root, "reset_timeout", rational_of);
  const auto read_all = [&](const char* key, std::vector<EntitySpec>& into) {
    const Node* map = root.find(key);
    if (map == nullptr) return;
    for (const auto& entry : map->entries) {
      into.push_back(read_entity(entry.key, entry.key_span, entry.value, diagnostics));
      if (&into == &spec.nodes) read_what_runs(entry.value, into.back(), diagnostics);
    }
  };
  read_all("objects", spec.objects);
  read_all("nodes", spec.nodes);
  spec.actions = read_selection(*root.find("actions"), diagnostics);
  spec.observations = read_selection(*root.find("observations"), diagnostics);
  spec.connections = read_connections(root.find("connections"), diagnostics);
  spec.agent = read_agent(root.find("agent"), diagnostics);
  spec.safety = read_safety(root.find("safety"));
  if (const Node* budget = root.find("budget")) spec.budget = *budget;
  if (const Node* placement = root.find("placement")) {
    for (const auto& entry : placement->entries)
      spec.placement.push_back({{entry.key, entry.key_span}, text_of(entry.value)});
  }
  return spec;
}

}  // namespace eagerx::gen

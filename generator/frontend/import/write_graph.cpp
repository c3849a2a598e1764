// A GraphSpec as text, in the order in which a person writes a graph.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "generator/frontend/import/import.hpp"
#include "generator/frontend/import/written.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/frontend/spec/port_name.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kWidth = 110;

std::string text_of(const QuantitySpec& quantity) {
  const Rational* number = quantity.number();
  return number != nullptr ? number->to_string() : text_of(*quantity.expression());
}

/// Settings that EAGERx has for a connection: it has no `max_delay` and samples no delays.
void add_settings(const ConnectionSettings& settings, std::vector<std::string>& items) {
  if (settings.window) items.push_back("window: " + text_of(*settings.window));
  if (settings.delay) {
    // With its unit where it could be taken for milliseconds (W0114).
    const Rational seconds = delay_of(settings).value_or(Rational());
    const bool is_long = seconds >= Rational(1);
    items.push_back(fmt::format("delay: {}{}", seconds.to_string(), is_long ? " s" : ""));
  }
  if (settings.skip) items.push_back(fmt::format("skip: {}", settings.skip->value));
  if (settings.processor) items.push_back("processor: " + processor_text(*settings.processor));
}

std::string connection_text(const ConnectionSpec& connection) {
  std::vector<std::string> items = {"from: " + yaml_scalar(connection.from.value),
                                    "to: " + yaml_scalar(connection.to.value)};
  add_settings(connection.settings, items);
  return in_braces(items);
}

std::string component_text(const ComponentSpec& component) {
  std::vector<std::string> items;
  if (component.rate) items.push_back("rate: " + component.rate->value.to_string());
  if (component.space) items.push_back("space: " + space_text(*component.space));
  add_settings(component.settings, items);
  return items.empty() ? "" : " " + in_braces(items);
}

class GraphWriter {
 public:
  explicit GraphWriter(const ImportedGraph& graph) : graph_(graph), spec_(graph.spec) {}

  std::string write() {
    add_heading();
    line(0, fmt::format("name: {}", yaml_text(spec_.name.value)), "name");
    line(0, fmt::format("rate: {}", spec_.rate.value.to_string()), "rate");
    if (!spec_.library.empty()) add_library();
    add_engine();
    add_entities("objects", spec_.objects);
    add_entities("nodes", spec_.nodes);
    text_ += '\n';
    add_selection(0, "actions", spec_.actions);
    add_selection(0, "observations", spec_.observations);
    add_connections();
    add_render();
    add_placement();
    add_place_of_task();
    return std::move(text_);
  }

 private:
  void line(std::size_t indent, const std::string& content, const std::string& remark = "") {
    text_ += std::string(indent, ' ') + content;
    const auto found = graph_.remarks.find(remark);
    if (found != graph_.remarks.end()) text_ += " # " + in_comment(found->second);
    text_ += '\n';
  }

  void add_heading() {
    const std::string file = std::filesystem::path(spec_.path).filename().string();
    line(0, fmt::format("# Written by `eagerx-gen import` from {}.", in_comment(file)));
  }

  /// EAGERx computes reward and end of an episode in Python. The names are those of the graph.
  void add_place_of_task() {
    std::vector<std::string> inputs;
    for (const auto& connection : spec_.connections) {
      const PortName to = parse_port(connection.to.value), from = parse_port(connection.from.value);
      if (to.owner == "observations")
        inputs.push_back(fmt::format("{}: {}", to.name, connection.from.value));
      if (from.owner == "actions" && !contains(inputs, from.name + ": " + connection.from.value))
        inputs.push_back(fmt::format("{}: {}", from.name, connection.from.value));
    }
    text_ += '\n';
    line(0,
         "# Reward and end of an episode are Python in EAGERx (`step` of the environment). Their "
         "place:");
    line(0, "# task:");
    line(0, "#   inputs:");
    for (const auto& input : inputs) line(0, "#     " + in_comment(input));
    line(0, "#   reward:");
    line(0, "#     NAME: {value: EXPRESSION, weight: -1.0}");
    line(0, "#   terminated: {NAME: CONDITION}");
    line(0, "#   truncated: {after: SECONDS}");
  }

  void add_library() {
    std::vector<std::string> folders;
    for (const auto& folder : spec_.library) folders.push_back(yaml_scalar(folder.value));
    line(0, fmt::format("library: [{}]", join(folders, ", ")));
  }

  void add_engine() {
    text_ += '\n';
    line(0, "engine:");
    line(2, "type: " + yaml_scalar(spec_.engine.type.value), "engine");
    line(2, "rate: " + text_of(*spec_.engine.rate), "engine.rate");
    if (!spec_.engine.config.empty()) line(2, "config: " + config_text(spec_.engine.config));
    add_states(2, spec_.engine.states);
  }

  void add_entities(const char* section, const std::vector<EntitySpec>& entities) {
    if (entities.empty()) return;
    text_ += '\n';
    line(0, fmt::format("{}:", section));
    for (const auto& entity : entities) {
      line(2, yaml_text(entity.name.value) + ":");
      line(4, "type: " + yaml_scalar(entity.type.value));
      if (entity.rate) line(4, "rate: " + text_of(*entity.rate));
      if (!entity.config.empty()) line(4, "config: " + config_text(entity.config));
      if (entity.sensors) add_selection(4, "sensors", *entity.sensors);
      if (entity.actuators) add_selection(4, "actuators", *entity.actuators);
      if (entity.inputs) add_selection(4, "inputs", *entity.inputs);
      if (entity.outputs) add_selection(4, "outputs", *entity.outputs);
      add_states(4, entity.states);
    }
  }

  void add_states(std::size_t indent, const std::vector<StateSpec>& states) {
    if (states.empty()) return;
    line(indent, "states:");
    for (const auto& state : states) {
      const std::string settings =
          state.processor ? fmt::format(" {{processor: {}}}", processor_text(*state.processor))
                          : "";
      line(indent + 2,
           yaml_text(state.name.value) + ":" + settings + " # set through the program's interface");
    }
  }

  void add_selection(std::size_t indent, const char* key,
                     const std::vector<ComponentSpec>& components) {
    std::vector<std::string> names;
    bool settings = false;
    for (const auto& component : components) {
      names.push_back(yaml_text(component.name.value));
      settings = settings || !component_text(component).empty();
    }
    const std::string list = fmt::format("{}: [{}]", key, join(names, ", "));
    if (!settings && indent + list.size() <= kWidth) {
      line(indent, list);
      return;
    }
    line(indent, fmt::format("{}:", key));
    for (const auto& component : components)
      line(indent + 2,
           fmt::format("{}:{}", yaml_text(component.name.value), component_text(component)));
  }

  void add_connections() {
    text_ += '\n';
    std::vector<std::string> lines;
    for (const auto& connection : spec_.connections) {
      if (parse_port(connection.to.value).owner != kRender)
        lines.push_back("- " + connection_text(connection));
    }
    line(0, lines.empty() ? "connections: []" : "connections:");
    for (const auto& text : lines) line(2, text);
  }

  void add_render() {
    if (!spec_.render) return;
    std::vector<std::string> items = {"source: " + yaml_scalar(spec_.render->source.value)};
    if (spec_.render->rate) items.push_back("rate: " + spec_.render->rate->value.to_string());
    text_ += '\n';
    line(0, "render: " + in_braces(items));
  }

  void add_placement() {
    if (spec_.placement.empty()) return;
    text_ += '\n';
    line(0, "placement:");
    for (const PlacementSpec& item : spec_.placement) {
      std::vector<std::string> keys = {"part: " + yaml_text(item.part.value)};
      if (!item.host.value.empty()) keys.push_back("host: " + yaml_text(item.host.value));
      line(2, fmt::format("{}: {}", yaml_text(item.name.value), in_braces(keys)),
           "placement." + item.name.value);
    }
  }

  const ImportedGraph& graph_;
  const GraphSpec& spec_;
  std::string text_;
};

}  // namespace

std::string write_graph(const ImportedGraph& graph) {
  return GraphWriter(graph).write();
}

}  // namespace eagerx::gen

#include "generator/frontend/compose/tunable.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/frontend/compose/port_bindings.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// Parameters, and states that can be set while an episode runs.
std::vector<std::string> tunable_parameters(const Entity& entity) {
  std::vector<std::string> names;
  for (const Parameter& parameter : entity.config)
    if (parameter.tunable) names.push_back(parameter.name.value);
  for (const PortManifest& state : entity.states)
    if (state.tunes_running && !contains(names, state.name.value))
      names.push_back(state.name.value);
  return names;
}

void report(const YamlValue& item, std::string message, Help help, Diagnostics& diagnostics) {
  diagnostics.error("E0396", item.span, std::move(message)).help = std::move(help);
}

/// Names of nodes, and of composites what is inside.
std::string nearest_node(const YamlValue& nodes, const std::string& name) {
  std::vector<std::string> known;
  for (const auto& entry : nodes.entries) known.push_back(entry.key);
  return nearest(name, known);
}

void take(YamlValue& nodes, const YamlValue& item, const Library& library,
          Diagnostics& diagnostics) {
  const std::size_t dot = item.text.rfind('.');
  if (dot == std::string::npos) return;  // no port: said where the graph is read
  const std::string name = item.text.substr(0, dot);
  const std::string parameter = item.text.substr(dot + 1);
  const auto node = ranges::find(nodes.entries, name, &YamlValue::Entry::key);
  if (node == nodes.entries.end()) {
    const auto inside = ranges::find_if(
        nodes.entries, [&](const auto& each) { return each.key.starts_with(name + "/"); });
    const std::string near = nearest_node(nodes, name);
    report(item, fmt::format("there is no node `{}`", name),
           inside != nodes.entries.end()
               ? fmt::format("of a composite, name the parameter of a node inside: `{}.…`",
                             inside->key)
           : near.empty() ? "only parameters of nodes are tunable: `controller.kp`"
                          : meaning(fmt::format("{}.{}", near, parameter)),
           diagnostics);
    return;
  }
  const YamlValue* type = node->value.find("type");
  const Entity* entity = type != nullptr ? library.find(type->text) : nullptr;
  if (entity == nullptr) return;  // unknown, or a policy: said elsewhere
  const std::vector<std::string> known = tunable_parameters(*entity);
  if (!contains(known, parameter)) {
    const std::string near = nearest(parameter, known);
    report(item,
           fmt::format("`{}` is not a tunable parameter of `{}`", parameter, entity->id.value),
           !near.empty()   ? meaning(fmt::format("{}.{}", name, near))
           : known.empty() ? "its class takes none of its parameters at a reset"
                           : fmt::format("tunable: {}", join(known, ", ")),
           diagnostics);
    return;
  }
  YamlValue& states = map_at(node->value, "states", item.span);
  if (states.find(parameter) == nullptr) states.entries.push_back({parameter, item.span, {}});
}

}  // namespace

void take_tunable(YamlValue& root, const Library& library, Diagnostics& diagnostics) {
  const YamlValue* list = root.find("tunable");
  const auto nodes = ranges::find(root.entries, "nodes", &YamlValue::Entry::key);
  if (list == nullptr || !list->is_sequence() || nodes == root.entries.end()) return;
  const YamlValue items = *list;
  for (const YamlValue& item : items.items)
    if (item.is_scalar()) take(nodes->value, item, library, diagnostics);
}

}  // namespace eagerx::gen

// Ports that are not connected, and connections to ports that were left out.
#include <fmt/format.h>

#include <map>
#include <set>

#include "generator/analysis/plausibility/plausibility.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/frontend/spec/port_name.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// Ports of objects that connections of the graph name, by object.
struct Connected {
  std::map<std::string, std::set<std::string>> sensors, actuators;

  explicit Connected(const GraphSpec& spec) {
    for (const auto& connection : spec.connections) {
      const PortName from = parse_port(connection.from.value), to = parse_port(connection.to.value);
      if (from.section != "states") sensors[from.owner].insert(from.name);
      actuators[to.owner].insert(to.name);
    }
  }
};

bool is_implemented(const Object& object, const std::string& actuator) {
  return ranges::any_of(object.implementation->connections, [&](const ConnectionSpec& connection) {
    const PortName from = parse_port(connection.from.value);
    return from.owner == "actuators" && from.within_owner() == actuator;
  });
}

/// Robots offer torque, speed and position of the same joint: one is driven, the others are not
/// missed. Another actuator in the unit of a driven one is.
bool is_alternative(const PortManifest& actuator, const std::vector<const PortManifest*>& driven) {
  return !driven.empty() && ranges::none_of(driven, [&](const PortManifest* other) {
    return !other->unit.empty() && other->unit == actuator.unit;
  });
}

void check_driven(const Object& object, const EntitySpec& said,
                  const std::set<std::string>& connected, Diagnostics& diagnostics) {
  if (said.actuators) return;  // a list of what is in use leaves the others out on purpose
  std::vector<const PortManifest*> driven;
  std::vector<std::string> still, used;
  for (const auto& actuator : object.entity->actuators) {
    if (!connected.contains(actuator.name.value)) continue;
    driven.push_back(&actuator);
    used.push_back(actuator.name.value);
  }
  for (const auto& actuator : object.entity->actuators) {
    const std::string& name = actuator.name.value;
    if (connected.contains(name) || !is_implemented(object, name)) continue;
    if (!is_alternative(actuator, driven)) still.push_back(object.name + "." + name);
  }
  if (still.empty()) return;
  auto& problem = diagnostics.warning("W0103", said.name.span,
                                      fmt::format("nothing drives `{}`", join(still, "`, `")));
  problem.help = fmt::format(
      "connect something to it, or leave it out on purpose: `actuators: [{}]`", join(used, ", "));
}

/// A list selects. A mapping may be there for the settings in it.
bool is_plain_list(const std::vector<ComponentSpec>& components) {
  return ranges::none_of(components, [](const ComponentSpec& component) {
    const ConnectionSettings& settings = component.settings;
    return component.rate || component.space || settings.processor || settings.window ||
           settings.delay || settings.random_delay || settings.max_delay || settings.skip;
  });
}

void check_listed(const Selection& listed, const char* key, const std::string& object,
                  const GraphSpec& spec, Diagnostics& diagnostics) {
  if (!listed || !is_plain_list(*listed)) return;
  const bool sensors = std::string_view(key) == "sensors";
  std::set<std::string> reported;
  for (const auto& connection : spec.connections) {
    const Spanned<std::string>& end = sensors ? connection.from : connection.to;
    const PortName port = parse_port(end.value);
    if (port.owner != object || (!port.section.empty() && port.section != key)) continue;
    if (find_named(*listed, port.name) != nullptr || !reported.insert(port.name).second) continue;
    diagnostics
        .warning("W0105", end.span,
                 fmt::format("`{}.{}` is connected, but `{}:` of `{}` leaves it out", object,
                             port.name, key, object))
        .help = {fmt::format("add `{}` to that list, or take the connection away", port.name),
                 add_to_list(port.name, key, object)};
  }
}

/// Nodes whose messages end up somewhere: at an actuator, at an observation, or in a node that
/// sends nothing itself and so does something else with them.
std::vector<bool> nodes_that_matter(const Graph& graph) {
  std::vector<bool> matters(graph.nodes.size(), false);
  std::vector<std::size_t> open;
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    const GraphNode& node = graph.nodes[n];
    const bool counts = node.entity != nullptr && !node.entity->counts.empty();
    if (node.role != NodeRole::node || node.outputs.empty() || node.is_reset_node() || counts ||
        (graph.task && n == graph.task->node))
      open.push_back(n);
  }
  while (!open.empty()) {
    const std::size_t n = open.back();
    open.pop_back();
    if (matters[n]) continue;
    matters[n] = true;
    for (const auto& input : graph.nodes[n].inputs) open.push_back(input.source_node);
  }
  return matters;
}

void check_nodes(const Graph& graph, Diagnostics& diagnostics) {
  const std::vector<bool> matters = nodes_that_matter(graph);
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    if (matters[n]) continue;
    const GraphNode& node = graph.nodes[n];
    auto& problem =
        diagnostics.warning("W0104", node.span, fmt::format("`{}` reaches nothing", node.name));
    problem.label = "it reaches no observation or actuator";
    problem.help = "connect an output of it, or leave the node out";
  }
}

/// Objects of which something is in the program, or whose states a reset node brings about.
std::vector<bool> objects_in_use(const Graph& graph) {
  std::vector<bool> used(graph.objects.size(), false);
  for (const auto& node : graph.nodes) {
    if (node.object) used[*node.object] = true;
    for (const auto& target : node.reset_targets) {
      if (target.object) used[*target.object] = true;
    }
  }
  return used;
}

void check_objects(const CheckedGraph& checked, Diagnostics& diagnostics) {
  Connected connected(checked.spec);
  const std::vector<bool> used = objects_in_use(checked.graph);
  for (std::size_t i = 0; i < checked.graph.objects.size(); ++i) {
    const Object& object = checked.graph.objects[i];
    const EntitySpec& said = checked.spec.objects[i];
    const std::set<std::string>& driven = connected.actuators[object.name];
    if (used[i] || !driven.empty() || !connected.sensors[object.name].empty()) {
      check_driven(object, said, driven, diagnostics);
      continue;
    }
    diagnostics
        .warning("W0104", said.name.span, fmt::format("nothing is connected to `{}`", object.name))
        .help = "connect a sensor or an actuator of it, or leave the object out";
  }
}

}  // namespace

void check_wiring(const CheckedGraph& checked, Diagnostics& diagnostics) {
  check_nodes(checked.graph, diagnostics);
  check_objects(checked, diagnostics);
  for (const auto& object : checked.spec.objects) {
    check_listed(object.sensors, "sensors", object.name.value, checked.spec, diagnostics);
    check_listed(object.actuators, "actuators", object.name.value, checked.spec, diagnostics);
  }
}

}  // namespace eagerx::gen

// Units at both ends of a connection.
#include <fmt/format.h>

#include "generator/analysis/plausibility/plausibility.hpp"
#include "generator/analysis/plausibility/units.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/frontend/spec/port_name.hpp"

namespace eagerx::gen {
namespace {

/// A port of an object, by the name that the graph calls it; nullptr if it is none.
const PortManifest* port_of_object(const Graph& graph, const std::string& written, bool sensor) {
  const PortName name = parse_port(written);
  for (const auto& object : graph.objects) {
    if (object.name != name.owner) continue;
    return sensor ? object.entity->sensor(name.name) : object.entity->actuator(name.name);
  }
  return nullptr;
}

/// Whether the graph itself converts what the sensor publishes.
bool is_converted(const GraphSpec& spec, const std::string& sensor) {
  const PortName name = parse_port(sensor);
  const EntitySpec* object = find_named(spec.objects, name.owner);
  const ComponentSpec* said =
      object != nullptr && object->sensors ? find_named(*object->sensors, name.name) : nullptr;
  return said != nullptr && said->settings.processor.has_value();
}

/// The port that sends; nullptr if the graph converts it, so that nothing is known of its unit.
const PortManifest* sender(const CheckedGraph& checked, const Input& input) {
  const GraphNode& node = checked.graph.nodes[input.source_node];
  const Output& output = node.outputs[input.source_output];
  if (!input.sensor.empty()) {
    return is_converted(checked.spec, input.sensor)
               ? nullptr
               : port_of_object(checked.graph, input.sensor, true);
  }
  const bool known = node.role == NodeRole::node && node.entity != nullptr && !output.processor;
  return known ? node.entity->output(output.name) : nullptr;
}

const PortManifest* receiver(const CheckedGraph& checked, const GraphNode& node,
                             const Input& input) {
  // An object's own processor is behind its actuator; `actuator_space` is not known behind others.
  if (input.actuator) {
    return input.actuator_space ? port_of_object(checked.graph, input.written, false) : nullptr;
  }
  // Behind a processor of the connection; one of the sensor gives what the sensor says.
  const bool converted = input.processor && input.processor->stages().size() > input.of_sensor;
  if (node.role != NodeRole::node || node.entity == nullptr || converted) return nullptr;
  return input.feedthrough ? node.entity->output(input.name) : node.entity->input(input.name);
}

void check(const Graph& graph, const Input& input, const PortManifest& from, const PortManifest& to,
           Diagnostics& diagnostics) {
  const auto sent = unit_of(from.unit), taken = unit_of(to.unit);
  if (!sent || !taken) return;
  const bool same = same_quantity(*sent, *taken);
  if (same && same_scale(*sent, *taken)) return;
  auto& problem = diagnostics.warning(
      "W0102", input.span,
      fmt::format("`{}` is in {}, but `{}` takes {}", name_of_source(graph, input), from.unit,
                  input.written, to.unit));
  problem.notes.push_back({"the unit of what is sent", from.name.span, ""});
  problem.notes.push_back({"the unit of what is taken", to.name.span, ""});
  problem.help = same ? fmt::format("put a `processor` on the connection: 1 {} is {:.6g} {}",
                                    from.unit, sent->scale / taken->scale, to.unit)
                      : "connect another port, or put a `processor` on the connection";
}

}  // namespace

void check_units(const CheckedGraph& checked, Diagnostics& diagnostics) {
  for (const auto& node : checked.graph.nodes) {
    for (const auto& input : node.inputs) {
      const PortManifest* from = sender(checked, input);
      const PortManifest* to = from != nullptr ? receiver(checked, node, input) : nullptr;
      if (to != nullptr) check(checked.graph, input, *from, *to, diagnostics);
    }
  }
}

}  // namespace eagerx::gen

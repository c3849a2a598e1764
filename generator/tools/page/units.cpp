#include "generator/tools/page/units.hpp"

#include <vector>

namespace eagerx::gen {

std::string unit_of(const Graph& graph, const GraphNode& node, const Output& output) {
  const PortManifest* port = node.entity != nullptr ? node.entity->output(output.name) : nullptr;
  const std::vector<std::string> sensors = output.names();
  if (node.object && !sensors.empty()) {
    const auto& object = *graph.objects[*node.object].entity;
    const std::string& written = sensors.front();
    if (const auto* sensor = object.sensor(written.substr(written.find('.') + 1))) port = sensor;
  }
  return port != nullptr && !output.processor ? port->unit : std::string();
}

}  // namespace eagerx::gen

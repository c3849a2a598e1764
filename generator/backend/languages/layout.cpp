#include "generator/backend/languages/layout.hpp"

#include "generator/graph/plan/split.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

const std::string& unit_of(const std::vector<PortManifest>& ports, std::string_view name) {
  static const std::string kNoUnit;
  const auto found =
      ranges::find_if(ports, [&](const PortManifest& port) { return port.name.value == name; });
  return found == ports.end() ? kNoUnit : found->unit;
}

/// As the manifest of the node or, where it is the engine's, of the object says.
std::string unit_of(const Graph& graph, const GraphNode& node, const Output& output) {
  if (!output.sensors.empty() && node.object) {
    const std::string& sensor = output.sensors.front();
    return unit_of(graph.objects[*node.object].entity->sensors,
                   std::string_view(sensor).substr(sensor.rfind('.') + 1));
  }
  return node.entity == nullptr || output.processor ? ""
                                                    : unit_of(node.entity->outputs, output.name);
}

class LayoutMaker {
 public:
  LayoutMaker(const Plan& plan, std::size_t part) : plan_(plan), graph_(*plan.graph) {
    layout_.part = part;
  }

  PartLayout run() {
    layout_.actions = messages_of(Graph::kEnvironment);
    layout_.before = turns(plan_.before);
    layout_.after = turns(plan_.after);
    return std::move(layout_);
  }

 private:
  /// Adds what crosses the line of a node's outputs.
  std::vector<std::size_t> messages_of(std::size_t n) {
    std::vector<std::size_t> added;
    std::uint64_t offset = 0;
    const GraphNode& node = graph_.nodes[n];
    for (std::size_t o = 0; o < node.outputs.size(); ++o) {
      const LinkUse use = link_use(plan_, Part::placed(layout_.part), n, o);
      if (!use.any()) continue;
      LayoutMessage message;
      message.channel = channel_of(n, o);
      message.unit = unit_of(graph_, node, node.outputs[o]);
      message.to_hub = !use.to.empty();
      message.offset = offset;
      message.bytes = bytes_of(node.outputs[o].space);
      message.keep = plan_.rings[plan_.nodes[n].rings[o]].capacity;
      offset += message.bytes;
      added.push_back(layout_.messages.size());
      layout_.messages.push_back(std::move(message));
    }
    return added;
  }

  std::size_t channel_of(std::size_t node, std::size_t output) const {
    const auto found = ranges::find_if(plan_.channels, [&](const Channel& channel) {
      return channel.node == node && channel.output == output;
    });
    return static_cast<std::size_t>(found - plan_.channels.begin());
  }

  std::vector<LayoutTurn> turns(const std::vector<std::size_t>& nodes) {
    std::vector<LayoutTurn> result;
    for (const std::size_t n : nodes) {
      LayoutTurn turn{n, runs_here(graph_, Part::placed(layout_.part), n), messages_of(n)};
      if (turn.runs || !turn.messages.empty()) result.push_back(std::move(turn));
    }
    return result;
  }

  const Plan& plan_;
  const Graph& graph_;
  PartLayout layout_;
};

}  // namespace

std::size_t PartLayout::find(const Plan& plan, std::size_t node, std::size_t output) const {
  const auto found = ranges::find_if(messages, [&](const LayoutMessage& message) {
    const Channel& channel = plan.channels[message.channel];
    return channel.node == node && channel.output == output;
  });
  return static_cast<std::size_t>(found - messages.begin());
}

PartLayout layout_of_part(const Plan& plan, std::size_t part) {
  return LayoutMaker(plan, part).run();
}

}  // namespace eagerx::gen

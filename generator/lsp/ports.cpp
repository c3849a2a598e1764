#include "generator/lsp/ports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace eagerx::gen::lsp {
namespace {

struct Group {
  const char* key;
  PortSide side;
};
constexpr std::array kOfObjects = {Group{"sensors", PortSide::sends},
                                   Group{"actuators", PortSide::receives}};
constexpr std::array kOfNodes = {Group{"outputs", PortSide::sends},
                                 Group{"inputs", PortSide::receives}};

/// Keys of a map, items of a list.
std::vector<std::string> names_in(const OutlineNode* node) {
  std::vector<std::string> names;
  if (node == nullptr) return names;
  for (const OutlineEntry& entry : node->entries)
    names.push_back(node->kind == OutlineNode::Kind::map ? entry.key : entry.value.text);
  return names;
}

class Collector {
 public:
  Collector(const Json& schema, const OutlineNode& graph) : schema_(schema), graph_(graph) {}

  void owners(const std::string& section, const std::array<Group, 2>& groups) {
    const OutlineNode* const all = graph_.find(section);
    if (all == nullptr || all->kind != OutlineNode::Kind::map) return;
    for (const OutlineEntry& owner : all->entries) {
      if (!owner.has_colon) continue;
      for (const Group& group : groups) {
        const std::vector<std::string> chosen = names_in(owner.value.find(group.key));
        for (const SchemaKey& port :
             keys_in(schemas_at(schema_, graph_, {section, owner.key, std::string(group.key)}))) {
          const bool is_chosen =
              chosen.empty() || std::ranges::find(chosen, port.name) != chosen.end();
          add({fmt::format("{}.{}", owner.key, port.name), port.about, group.side, is_chosen});
        }
        for (const std::string& name : chosen)
          add({fmt::format("{}.{}", owner.key, name), {}, group.side, true});
      }
    }
  }
  void agent(const std::string& section, PortSide side) {
    for (const std::string& name : names_in(graph_.find(section)))
      add({fmt::format("{}.{}", section, name), {}, side, true});
  }
  std::vector<NamedPort> take() { return std::move(ports_); }

 private:
  void add(NamedPort port) {
    const bool known =
        port.name.ends_with('.') || std::ranges::any_of(ports_, [&](const auto& each) {
          return each.name == port.name && each.side == port.side;
        });
    if (!known) ports_.push_back(std::move(port));
  }

  const Json& schema_;
  const OutlineNode& graph_;
  std::vector<NamedPort> ports_;
};

}  // namespace

std::vector<NamedPort> ports_of(const Json& schema, const OutlineNode& graph) {
  Collector ports(schema, graph);
  ports.agent("actions", PortSide::sends);
  ports.owners("objects", kOfObjects);
  ports.owners("nodes", kOfNodes);
  ports.agent("observations", PortSide::receives);
  return ports.take();
}

std::vector<std::string> connected(const OutlineNode& graph, PortSide side) {
  std::vector<std::string> names;
  const OutlineNode* const connections = graph.find("connections");
  if (connections == nullptr) return names;
  for (const OutlineEntry& each : connections->entries) {
    const OutlineNode* const end = each.value.find(side == PortSide::sends ? "from" : "to");
    if (end != nullptr && !end->text.empty()) names.push_back(end->text);
  }
  return names;
}

}  // namespace eagerx::gen::lsp

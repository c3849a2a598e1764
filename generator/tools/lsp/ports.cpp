#include "generator/tools/lsp/ports.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "generator/support/diagnostics/search.hpp"

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
  Collector(const LibraryFacts& library, const OutlineNode& graph)
      : library_(library), graph_(graph) {}

  void owners(const std::string& section, const std::array<Group, 2>& groups) {
    for_each_owner(section, [&](const OutlineEntry& owner) {
      for (const Group& group : groups) {
        const std::vector<std::string> chosen = names_in(owner.value.find(group.key));
        for (const SchemaKey& port : keys_of(section, owner.key, group.key)) {
          const bool is_chosen = chosen.empty() || ranges::contains(chosen, port.name);
          add({fmt::format("{}.{}", owner.key, port.name), port.about, group.side, is_chosen});
        }
        for (const std::string& name : chosen)
          add({fmt::format("{}.{}", owner.key, name), {}, group.side, true});
      }
    });
  }
  void agent(const std::string& section, PortSide side) {
    for (const std::string& name : names_in(graph_.find(section)))
      add({fmt::format("{}.{}", section, name), {}, side, true});
  }
  void reset_nodes() {
    bool is_any = false;
    for_each_owner("nodes", [&](const OutlineEntry& node) {
      const OutlineNode* const type = node.value.find("type");
      const auto found =
          type != nullptr ? library_.reset_targets.find(type->text) : library_.reset_targets.end();
      if (found == library_.reset_targets.end()) return;
      is_any = true;
      for (const std::string& target : found->second)
        add({fmt::format("{}.targets.{}", node.key, target), {}, PortSide::receives, true});
      for (const SchemaKey& output : keys_of("nodes", node.key, "outputs"))
        add({fmt::format("{}.feedthroughs.{}", node.key, output.name), output.about,
             PortSide::receives, true});
    });
    if (!is_any) return;
    for_each_owner("objects", [&](const OutlineEntry& object) {
      for (const SchemaKey& state : keys_of("objects", object.key, "states"))
        add({fmt::format("{}.states.{}", object.key, state.name), state.about, PortSide::sends,
             true});
    });
  }
  std::vector<NamedPort> take() { return std::move(ports_); }

 private:
  template <class F>
  void for_each_owner(const std::string& section, const F& f) {
    const OutlineNode* const all = graph_.find(section);
    if (all == nullptr || all->kind != OutlineNode::Kind::map) return;
    for (const OutlineEntry& owner : all->entries) {
      if (owner.has_colon) f(owner);
    }
  }
  std::vector<SchemaKey> keys_of(const std::string& section, const std::string& owner,
                                 const std::string& group) {
    return keys_in(schemas_at(library_.schema, graph_, {section, owner, group}));
  }
  void add(NamedPort port) {
    const bool known = port.name.ends_with('.') || ranges::any_of(ports_, [&](const auto& each) {
                         return each.name == port.name && each.side == port.side;
                       });
    if (!known) ports_.push_back(std::move(port));
  }

  const LibraryFacts& library_;
  const OutlineNode& graph_;
  std::vector<NamedPort> ports_;
};

}  // namespace

std::vector<NamedPort> ports_of(const LibraryFacts& library, const OutlineNode& graph) {
  Collector ports(library, graph);
  ports.agent("actions", PortSide::sends);
  ports.owners("objects", kOfObjects);
  ports.owners("nodes", kOfNodes);
  ports.agent("observations", PortSide::receives);
  ports.reset_nodes();
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

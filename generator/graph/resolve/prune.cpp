#include "generator/graph/resolve/prune.hpp"

namespace eagerx::gen {
namespace {

void need(std::size_t index, const std::vector<InnerLink>& links, std::vector<bool>& needed) {
  if (needed[index]) return;
  needed[index] = true;
  for (const auto& link : links) {
    if (link.to == index) need(link.from, links, needed);
  }
}

void reach(std::size_t index, const std::vector<InnerLink>& links, std::vector<bool>& reached) {
  if (reached[index]) return;
  reached[index] = true;
  for (const auto& link : links) {
    if (link.from == index) reach(link.to, links, reached);
  }
}

}  // namespace

std::vector<bool> needed_engine_nodes(const std::vector<UnresolvedNode>& nodes,
                                      const std::vector<InnerLink>& links,
                                      const std::vector<std::size_t>& sensors,
                                      const std::vector<std::size_t>& actuators) {
  std::vector<bool> needed(nodes.size(), false), reached(nodes.size(), false);
  for (const std::size_t node : sensors) need(node, links, needed);
  for (const std::size_t node : actuators) {
    reach(node, links, reached);
    need(node, links, needed);
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (reached[i] && nodes[i].input("tick") != nullptr) need(i, links, needed);
  }
  return needed;
}

}  // namespace eagerx::gen

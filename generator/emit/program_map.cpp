// program.map: what of program.hpp is whose.
#include "generator/emit/names.hpp"
#include "generator/emit/reset_view.hpp"

namespace eagerx::gen {

ProgramMap program_map(const Plan& plan, const ProgramNames& names, const MarkedText& program) {
  const Graph& graph = *plan.graph;
  ProgramMap map;
  map.program_hash = hash_text(program.text);
  map.blocks = program.blocks;
  std::map<std::string, std::string> types;
  for (const auto& node : graph.nodes) {
    if (node.entity != nullptr) types.emplace(node.name, node.entity->id.value);
  }
  for (const auto& block : map.blocks) map.type_of_node[block.node] = types.at(block.node);

  map.owner_of_member["trace"] = {false, "runtime"};
  for (const std::size_t n : nodes_in_order(plan)) {
    if (names.runs(n) && !graph.nodes[n].drawn)
      map.owner_of_member[names.node_member[n]] = {true, graph.nodes[n].name};
  }
  for (std::size_t r = 0; r < plan.rings.size(); ++r) {
    if (names.has_ring(r) && !is_drawn(plan, plan.rings[r]))
      map.owner_of_member[names.ring_member[r]] = {false, "rings"};
  }
  for (const auto& member : names.simulator_member) {
    if (names.has_engine()) map.owner_of_member[member] = {false, "simulators"};
  }
  return map;
}

}  // namespace eagerx::gen

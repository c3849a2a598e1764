// program.map: assigns the lines of program.hpp to nodes.
#include <runtime/host/base/hash.hpp>

#include "generator/backend/emit/names.hpp"
#include "generator/backend/emit/reset_view.hpp"
#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {
namespace {

/// Places in the graph of the elements that comments of generated code name. The comments contain
/// names only, so that a comment added to the graph changes only this file.
std::vector<ProgramMap::Place> places_of(const Graph& graph) {
  std::vector<ProgramMap::Place> places;
  const auto add = [&](const Span& span, const std::string& element) {
    // Elements of a composite are in another file.
    if (span.line > 0 && span.file == graph.span.file)
      places.push_back({span.line, span.column, element});
  };
  const auto add_states = [&](const std::vector<State>& states, const std::string& owner) {
    for (const auto& state : states) add(state.span, owner + ".states." + state.name);
  };
  for (const auto& action : graph.environment().outputs) add(action.span, "actions." + action.name);
  for (const auto& observation : graph.environment().inputs)
    add(observation.span, observation.written);
  for (const auto& object : graph.objects) {
    add(object.span, object.name);
    add_states(object.states, object.name);
  }
  for (const auto& node : graph.nodes) {
    if (node.entity == nullptr) continue;
    add(node.span, node.name);
    add_states(node.states, node.name);
  }
  if (graph.task) {
    const Task& task = *graph.task;
    add(task.span, "task");
    for (const auto& term : task.terms) add(term.span, "task.reward." + term.name);
    for (const auto& end : task.terminated) add(end.span, "task.terminated." + end.name);
    for (const auto& end : task.truncated) add(end.span, "task.truncated." + end.name);
    for (const auto& success : task.success) add(success.span, "task.success." + success.name);
  }
  if (graph.safety.declared) add(graph.safety.span, "safety");
  add(graph.agent.span, "agent");
  return places;
}

}  // namespace

ProgramMap program_map(const Plan& plan, const ProgramNames& names, const MarkedText& program) {
  const Graph& graph = *plan.graph;
  ProgramMap map;
  map.program_hash = host::fnv1a(program.text);
  map.blocks = program.blocks;
  std::map<std::string, std::string> types;
  for (const auto& node : graph.nodes) {
    if (node.entity != nullptr) types.emplace(node.name, node.entity->id.value);
  }
  for (const auto& loop : names.loops) {
    const std::size_t length = loop.repeat.length();
    for (std::size_t i = length; i < loop.repeat.nodes.size(); ++i) {
      const std::string& node = graph.nodes[loop.repeat.nodes[i]].name;
      map.shares[node] = graph.nodes[loop.repeat.nodes[i % length]].name;
      map.type_of_node[node] = types.at(node);
    }
  }
  for (const auto& block : map.blocks) map.type_of_node[block.node] = types.at(block.node);

  map.graph_file = in_comment(graph.file_name);
  map.places = places_of(graph);
  map.owner_of_member["hooks"] = {false, "runtime"};
  for (const std::size_t n : nodes_in_order(plan)) {
    if (names.runs(n) && !graph.nodes[n].drawn)
      map.owner_of_member.try_emplace(names.nodes[n].member.name,
                                      ProgramMap::Owner{true, graph.nodes[n].name});
  }
  for (std::size_t r = 0; r < plan.rings.size(); ++r) {
    if (names.has_ring(r) && !is_drawn(plan, plan.rings[r]))
      map.owner_of_member[names.rings[r].name] = {false, "rings"};
  }
  for (const EmitObject& object : names.objects) {
    if (names.has_engine()) map.owner_of_member[object.simulator_member] = {false, "simulators"};
  }
  return map;
}

}  // namespace eagerx::gen

#include "generator/backend/emit/shared_io.hpp"

#include <fmt/format.h>

#include <map>

#include "generator/backend/emit/config.hpp"
#include "generator/backend/emit/types.hpp"

namespace eagerx::gen {
namespace {

/// All of a node's Io but its name, as one text.
std::string structure_of(const Plan& plan, std::size_t n) {
  const GraphNode& node = plan.graph->nodes[n];
  std::string text = node.entity->id.value + "|" + node.rate_hz.to_string();
  for (const auto& item : node.config) text += "|" + cpp_value(item).value;
  for (std::size_t i = 0; i < node.inputs.size(); ++i)
    text += "|" + node.inputs[i].name + window_type(plan, n, i) +
            (node.inputs[i].entity_sets_delay ? "d" : "");
  for (const auto& output : node.outputs) text += "|" + output.name + message_type(output.raw);
  for (const auto& state : node.states) text += "|" + state.name + message_type(state.received());
  for (const auto& target : node.reset_targets)
    text += "|" + target.name + message_type(target.space);
  if (node.object) text += fmt::format("|{}", *node.object);
  return text;
}

}  // namespace

bool has_io(const Graph& graph, Part part, std::size_t node) {
  return node != Graph::kEnvironment &&
         (runs_here(graph, part, node) || !graph.nodes[node].reset_targets.empty());
}

std::vector<std::size_t> io_owners(const Plan& plan, Part part) {
  std::vector<std::size_t> owners;
  std::map<std::string, std::size_t> first_of;
  for (std::size_t n = 0; n < plan.graph->nodes.size(); ++n) {
    owners.push_back(n);
    if (has_io(*plan.graph, part, n))
      owners[n] = first_of.try_emplace(structure_of(plan, n), n).first->second;
  }
  return owners;
}

}  // namespace eagerx::gen

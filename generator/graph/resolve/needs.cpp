#include "generator/graph/resolve/needs.hpp"

#include <fmt/format.h>

#include <set>

#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// f(entity, where the graph brings it in) for every entity with a C++ class, the engine first.
template <class F>
void for_each_entity(const Graph& graph, Part part, F&& f) {
  const auto processor = [&](const std::optional<Processor>& item) {
    if (!item) return;
    for (const Processor* stage : item->stages()) f(*stage->entity, stage->span);
  };
  if (!part.is_placed() && graph.has_engine()) f(*graph.engine().entity, graph.engine().span);
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    const GraphNode& node = graph.nodes[n];
    if (receives_here(graph, part, n)) {
      for (const auto& input : node.inputs) processor(input.processor);
    }
    for (const auto& reset_target : node.reset_targets) processor(reset_target.processor);
    if (!runs_here(graph, part, n)) continue;
    if (node.entity != nullptr && node.role != NodeRole::engine) f(*node.entity, node.span);
    for (const auto& output : node.outputs) processor(output.processor);
    for (const auto& state : node.states) processor(state.processor);
  }
  if (part.is_placed()) return;
  for (const auto& object : graph.objects) {
    for (const auto& state : object.states) {
      if (state.engine_state != nullptr) f(*state.engine_state, object.span);
      processor(state.processor);
    }
  }
}

/// The targets that have what an entity needs. `Member`: Target::system or Target::family.
std::string targets_help(const Library& library, std::string Target::*member,
                         const std::string& wanted) {
  std::vector<std::string> ids;
  for (const auto& [id, target] : library.all_targets()) {
    if (target.*member == wanted && target.language.empty()) ids.push_back("`--target " + id + "`");
  }
  return fmt::format("{}{}another engine: `--engine NAME`", join(ids, ", "),
                     ids.empty() ? "" : ", or ");
}

std::string system_of(const Target& target) {
  return target.system.empty() ? "has no operating system" : "runs " + target.system;
}

/// Properties that an entity needs and the target lacks, in words; empty if there are none.
std::string missing(const Entity& entity, const Target& target) {
  if (entity.system && entity.system->value != target.system)
    return fmt::format("`{}` needs {}, but target `{}` {}", entity.id.value, entity.system->value,
                       target.id.value, system_of(target));
  if (entity.family && entity.family->value != target.family)
    return fmt::format("`{}` needs a board of the family {}, but target `{}` is none",
                       entity.id.value, entity.family->value, target.id.value);
  return {};
}

void report_no_class(const Graph& graph, const Entity& entity, Span span,
                     Diagnostics& diagnostics) {
  const auto node = ranges::find(graph.nodes, &entity, &GraphNode::entity);
  diagnostics.error("E0351", span, fmt::format("`{}` is written in Python alone", entity.id.value))
      .help = fmt::format(
      "place it in a part: `placement: {{{}: {{part: PART, target: python}}}}`; or write its class "
      "in C++, too",
      node == graph.nodes.end() ? "NODE" : node->name);
}

}  // namespace

bool runs_here(const Graph& graph, Part part, std::size_t node) {
  return part == Part::whole || graph.placement->part_of[node] == part.index();
}

bool receives_here(const Graph& graph, Part part, std::size_t node) {
  return runs_here(graph, part, node) || (node == Graph::kEnvironment && part == Part::hub);
}

std::vector<std::string> packages_of(const Graph& graph, Part part) {
  std::set<std::string> packages;
  for_each_entity(graph, part, [&](const Entity& entity, Span /*span*/) {
    packages.insert(entity.packages.begin(), entity.packages.end());
  });
  return {packages.begin(), packages.end()};
}

void check_system(const Graph& graph, Part part, const Target& target, const Library& library,
                  Diagnostics& diagnostics) {
  std::set<std::string> reported;
  // If the engine cannot run here, its own entities are not reported as well.
  bool is_engine = !part.is_placed() && graph.has_engine();
  const bool engine_runs = !is_engine || missing(*graph.engine().entity, target).empty();
  for_each_entity(graph, part, [&](const Entity& entity, Span span) {
    if (entity.kind == EntityKind::node && entity.cpp.name.empty() && target.language.empty() &&
        reported.insert(entity.id.value).second)
      report_no_class(graph, entity, span, diagnostics);
    const bool follows = !is_engine && !engine_runs && !entity.engines.empty();
    is_engine = false;
    const std::string what = missing(entity, target);
    if (what.empty() || follows || !reported.insert(entity.id.value).second) return;
    const bool is_system = entity.system && entity.system->value != target.system;
    diagnostics.error("E0330", span, what).help =
        is_system ? targets_help(library, &Target::system, entity.system->value)
                  : targets_help(library, &Target::family, entity.family->value);
  });
}

}  // namespace eagerx::gen

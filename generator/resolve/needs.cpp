#include "generator/resolve/needs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace eagerx::gen {
namespace {

/// f(entity, where the graph brings it in) for every entity with a C++ class, the engine first.
template <class F>
void for_each_entity(const Graph& graph, F&& f) {
  const auto processor = [&](const std::optional<Processor>& item) {
    if (item) f(*item->entity, item->span);
  };
  f(*graph.engine().entity, graph.engine().span);
  for (const auto& node : graph.nodes) {
    if (node.entity != nullptr && node.role != NodeRole::engine) f(*node.entity, node.span);
    for (const auto& input : node.inputs) processor(input.processor);
    for (const auto& output : node.outputs) processor(output.processor);
    for (const auto& state : node.states) processor(state.processor);
    for (const auto& target : node.targets) processor(target.processor);
  }
  for (const auto& object : graph.objects) {
    for (const auto& state : object.states) {
      if (state.engine_state != nullptr) f(*state.engine_state, object.span);
      processor(state.processor);
    }
  }
}

std::string systems_help(const Library& library, const std::string& system) {
  std::vector<std::string> ids;
  for (const auto& [id, target] : library.targets) {
    if (target.system == system) ids.push_back("`--target " + id + "`");
  }
  return fmt::format("{}, or another engine: `--engine NAME`", fmt::join(ids, ", "));
}

}  // namespace

std::vector<std::string> packages_of(const Graph& graph) {
  std::set<std::string> packages;
  for_each_entity(graph, [&](const Entity& entity, Span /*span*/) {
    packages.insert(entity.packages.begin(), entity.packages.end());
  });
  return {packages.begin(), packages.end()};
}

void check_system(const Graph& graph, const Target& target, const Library& library,
                  Diagnostics& diagnostics) {
  std::set<std::string> reported;
  bool engine = true;
  for_each_entity(graph, [&](const Entity& entity, Span span) {
    // What belongs to an engine that cannot run here need not be named too.
    const bool follows = !engine && graph.engine().entity->system && !entity.engines.empty();
    engine = false;
    if (!entity.system || entity.system->value == target.system || follows) return;
    if (!reported.insert(entity.id.value).second) return;
    diagnostics
        .error("E0330", span,
               fmt::format("`{}` needs {}, but target `{}` {}", entity.id.value,
                           entity.system->value, target.id.value,
                           target.system.empty() ? "has no operating system"
                                                 : fmt::format("runs {}", target.system)))
        .help = systems_help(library, entity.system->value);
  });
}

}  // namespace eagerx::gen

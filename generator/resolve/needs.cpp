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

/// The targets that have what an entity needs. `Member`: Target::system or Target::family.
std::string targets_help(const Library& library, std::string Target::*member,
                         const std::string& wanted) {
  std::vector<std::string> ids;
  for (const auto& [id, target] : library.targets) {
    if (target.*member == wanted) ids.push_back("`--target " + id + "`");
  }
  return fmt::format("{}{}another engine: `--engine NAME`", fmt::join(ids, ", "),
                     ids.empty() ? "" : ", or ");
}

std::string system_of(const Target& target) {
  return target.system.empty() ? "has no operating system" : "runs " + target.system;
}

/// What an entity needs and the target is not, in words; empty if there is nothing.
std::string missing(const Entity& entity, const Target& target) {
  if (entity.system && entity.system->value != target.system)
    return fmt::format("`{}` needs {}, but target `{}` {}", entity.id.value, entity.system->value,
                       target.id.value, system_of(target));
  if (entity.family && entity.family->value != target.family)
    return fmt::format("`{}` needs a board of the family {}, but target `{}` is none",
                       entity.id.value, entity.family->value, target.id.value);
  return {};
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
  // What belongs to an engine that cannot run here need not be named too.
  const bool engine_runs = missing(*graph.engine().entity, target).empty();
  bool is_engine = true;
  for_each_entity(graph, [&](const Entity& entity, Span span) {
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

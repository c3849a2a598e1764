// States of objects that continue from one episode to the next.
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "generator/analysis/plausibility/plausibility.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// Values that an engine state sets and that change during an episode: "positions shoulder". Texts
/// among its parameters are names of joints or bodies.
std::set<std::string> moved_by(const Entity& engine_state, const Config& config) {
  std::set<std::string> names;
  for (const ConfigValue& each : config) {
    const auto* text = std::get_if<std::string>(&each.value);
    if (text == nullptr) continue;
    std::istringstream words(*text);
    for (std::string word; words >> word;) names.insert(word);
  }
  if (names.empty()) names.insert("");
  std::set<std::string> result;
  for (const std::string& part : engine_state.moves) {
    for (const std::string& name : names) result.insert(fmt::format("{} {}", part, name));
  }
  return result;
}

/// Whether an episode ends because of what happens in it. One that only a time limit cuts off may
/// well continue where the last one stopped.
const TaskExpression* end_of_episodes(const Task& task) {
  for (const auto* conditions : {&task.terminated, &task.truncated}) {
    for (const TaskExpression& condition : *conditions) {
      bool of_messages = false;
      for_each_part(condition.value, [&](const TypedExpression& part) {
        of_messages = of_messages || part.op == TypedExpression::Op::variable ||
                      part.op == TypedExpression::Op::before;
      });
      if (of_messages) return &condition;
    }
  }
  return nullptr;
}

/// Whether a reset node brings a state of the object about. One whose goal is a state of a node
/// moves what it is connected to.
bool is_brought_about(const Graph& graph, std::size_t object) {
  return ranges::any_of(graph.nodes, [&](const GraphNode& node) {
    return ranges::any_of(node.reset_targets, [&](const ResetTarget& target) {
      return !target.object || *target.object == object;
    });
  });
}

/// States that are never set, and of which other states do not set everything. Where one of them
/// would set what another one does, it alone.
std::vector<const KeptState*> still_moving(const Object& object) {
  std::set<std::string> set;
  for (const State& state : object.states) {
    if (state.engine_state != nullptr) set.merge(moved_by(*state.engine_state, state.config));
  }
  struct Moving {
    const KeptState* state;
    std::set<std::string> moved;
  };
  std::vector<Moving> moving;
  for (const KeptState& state : object.kept) {
    auto moved = moved_by(*state.engine_state, state.config);
    if (!std::ranges::includes(set, moved)) moving.push_back({&state, std::move(moved)});
  }
  std::vector<const KeptState*> result;
  for (const Moving& one : moving) {
    const bool within = ranges::any_of(moving, [&](const Moving& other) {
      return other.moved.size() > one.moved.size() && std::ranges::includes(other.moved, one.moved);
    });
    if (!within) result.push_back(one.state);
  }
  return result;
}

}  // namespace

void check_kept_states(const CheckedGraph& checked, Diagnostics& diagnostics) {
  if (!checked.graph.task) return;
  const TaskExpression* end = end_of_episodes(*checked.graph.task);
  if (end == nullptr) return;
  for (std::size_t i = 0; i < checked.graph.objects.size(); ++i) {
    const Object& object = checked.graph.objects[i];
    if (is_brought_about(checked.graph, i)) continue;
    const auto kept = still_moving(object);
    if (kept.empty()) continue;
    std::vector<std::string> names, sampled;
    bool bounded = true;
    for (const KeptState* state : kept) {
      names.push_back(object.name + "." + state->name);
      sampled.push_back(
          fmt::format("{}: {}", state->name, state->bounded ? "uniform" : "{value: …}"));
      bounded = bounded && state->bounded;
    }
    auto& problem = diagnostics.warning(
        "W0113", checked.spec.objects[i].name.span,
        fmt::format("no reset sets `{}`: each episode begins where the last one ended",
                    join(names, "`, `")));
    problem.notes.push_back({fmt::format("`{}` ends episodes", end->name), end->span, ""});
    problem.help = fmt::format(
        "write `states: {{{}}}`{}; without a value (`{}:`) if a program of your own sets it",
        join(sampled, ", "), bounded ? ", or always the same: `{value: …}`" : "",
        kept.front()->name);
  }
}

}  // namespace eagerx::gen

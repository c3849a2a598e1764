// What the header of a library is rendered with.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/backend/emit/names.hpp"
#include "generator/backend/emit/types.hpp"

namespace eagerx::gen {
namespace {

/// "float32 [2], from -1 to 1"
std::string described(const Space& space) {
  const auto one = [](const std::vector<double>& bounds) {
    return !bounds.empty() && std::ranges::count(bounds, bounds.front()) == std::ssize(bounds);
  };
  if (!one(space.low) || !one(space.high)) return space.describe();
  return fmt::format("{}, from {} to {}", space.describe(), space.low.front(), space.high.front());
}

/// `cut`: what is said of the port where it was cut out of a larger graph.
View port(const std::string& field, const Space& space, const CutPort* cut) {
  View view = object();
  view["of_graph"] = View(false);
  if (cut != nullptr) {
    View of_graph = object();
    of_graph.set("sender", cut->sender);
    of_graph.set("rate", cut->rate_hz.to_string());
    view["of_graph"] = std::move(of_graph);
  }
  view.set("field", field);
  view.set("type", message_type(space));
  view.set("space", described(space));
  return view;
}

}  // namespace

View library_view(const Plan& plan, bool has_policy, bool has_memory) {
  const Graph& graph = *plan.graph;
  View actions = list(), observations = list();
  const auto& outputs = graph.environment().outputs;
  const auto& inputs = graph.environment().inputs;
  for (std::size_t i = 0; i < outputs.size(); ++i)
    actions.push_back(
        port(outputs[i].name, outputs[i].space, graph.cut ? &graph.cut->actions[i] : nullptr));
  for (std::size_t i = 0; i < inputs.size(); ++i)
    observations.push_back(
        port(inputs[i].name, inputs[i].space, graph.cut ? &graph.cut->observations[i] : nullptr));
  View view = object();
  view.set("is_cut", graph.cut.has_value());
  view.set("period", (Rational(1) / graph.environment().rate_hz).to_string());
  view.set("has_policy", has_policy);
  view.set("has_memory", has_memory);
  view.set("an_action", !has_policy  ? "Graph::zero()"
                        : has_memory ? "Graph::policy(seen, program.policy_memory)"
                                     : "Graph::policy(seen)");
  view.set("guards", actions.is_non_empty_list());
  view.set("guards_outputs", !graph.safety.outputs.empty());
  view.set("has_safety", graph.safety.declared);
  view.set("has_task", graph.task.has_value());
  view["actions"] = has_policy ? list() : std::move(actions);
  view["observations"] = std::move(observations);
  return view;
}

View loop_view(const Plan& plan, bool has_policy, bool has_memory) {
  const Graph& graph = *plan.graph;
  View view = library_view(plan, has_policy, has_memory);
  const Rational rate = graph.environment().rate_hz;
  view.set("rate", rate.to_string());
  view.set("has_actions", view.get("actions")->is_non_empty_list());
  view.set("has_observations", view.get("observations")->is_non_empty_list());
  // Long enough for a step that is late, short enough for what is at the outputs meanwhile.
  constexpr double kPeriods = 10.0;
  constexpr double kShortestMs = 100.0;
  constexpr double kMsPerSecond = 1e3;
  const double wanted_ms = std::ceil(kPeriods * kMsPerSecond / rate.to_double());
  view.set("watchdog_ms", fmt::format("{:.0f}", std::max(kShortestMs, wanted_ms)));
  return view;
}

}  // namespace eagerx::gen

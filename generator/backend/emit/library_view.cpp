// The view of a library's header.
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
  if (std::isinf(space.low.front()) && std::isinf(space.high.front()))
    return space.describe() + ", without bounds";
  return fmt::format("{}, from {} to {}", space.describe(), space.low.front(), space.high.front());
}

/// "rad; the measured angle": unit and text of a port of a node; empty if its manifest says
/// neither.
std::string meaning(const PortManifest* manifest) {
  if (manifest == nullptr) return {};
  std::string text = manifest->unit;
  if (!text.empty() && !manifest->about.empty()) text += "; ";
  text += manifest->about;
  std::ranges::replace(text, '\n', ' ');
  return text;
}

/// Of an action: what the first node that takes it as it is says of it.
std::string meaning_of_action(const Graph& graph, std::size_t action) {
  for (const auto& node : graph.nodes) {
    if (node.role != NodeRole::node || node.entity == nullptr) continue;
    for (const auto& input : node.inputs) {
      if (input.source_node != 0 || input.source_output != action || input.processor) continue;
      const std::string text = meaning(node.entity->input(input.name));
      if (!text.empty()) return text;
    }
  }
  return {};
}

/// Of an observation: what the node that sends it says of it.
std::string meaning_of_observation(const Graph& graph, const Input& input) {
  const GraphNode& node = graph.nodes[input.source_node];
  const Output& output = node.outputs[input.source_output];
  const bool known = node.role == NodeRole::node && node.entity != nullptr && !output.processor;
  return known && !input.processor ? meaning(node.entity->output(output.name)) : std::string();
}

/// `cut`: what is said of the port where it was cut out of a larger graph.
View port(const std::string& field, const Space& space, const std::string& meaning,
          const CutPort* cut) {
  View view = object();
  view["meaning"] = View(false);
  if (!meaning.empty()) {
    View text = object();
    text.set("text", meaning);
    view["meaning"] = std::move(text);
  }
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
  view.set("is_array", !space.shape.empty());
  return view;
}

/// Of an observation: with the limits of `safety: outputs:`, where it has some.
const Space& space_that_leaves(const Graph& graph, std::size_t observation) {
  const auto safe = std::ranges::find(graph.safety.outputs, observation, &SafeOutput::input);
  return safe != graph.safety.outputs.end() ? safe->space
                                            : graph.environment().inputs[observation].space;
}

}  // namespace

View library_view(const Plan& plan, bool has_policy, bool has_memory) {
  const Graph& graph = *plan.graph;
  View actions = list(), observations = list();
  const auto& outputs = graph.environment().outputs;
  const auto& inputs = graph.environment().inputs;
  for (std::size_t i = 0; i < outputs.size(); ++i)
    actions.push_back(port(outputs[i].name, outputs[i].space, meaning_of_action(graph, i),
                           graph.cut ? &graph.cut->actions[i] : nullptr));
  for (std::size_t i = 0; i < inputs.size(); ++i)
    observations.push_back(port(inputs[i].name, space_that_leaves(graph, i),
                                meaning_of_observation(graph, inputs[i]),
                                graph.cut ? &graph.cut->observations[i] : nullptr));
  View view = object();
  view.set("is_cut", graph.cut.has_value());
  view.set("period", (Rational(1) / graph.environment().rate_hz).to_string());
  view.set("has_policy", has_policy);
  view.set("has_memory", has_memory);
  // Without engine and agent the actions are measurements.
  const bool measures = !has_policy && !graph.has_engine() && actions.is_non_empty_list();
  view.set("measures", measures);
  view.set("an_action", measures      ? "not_measured()"
                        : !has_policy ? "Graph::zero()"
                        : has_memory  ? "Graph::policy(seen, program.policy_memory)"
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

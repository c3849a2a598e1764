// Stages of a training. Only libraries of environments contain them.
#include <fmt/format.h>

#include <limits>

#include "generator/backend/emit/names.hpp"
#include "generator/backend/emit/samples.hpp"
#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {
namespace {

std::string limit(const std::optional<double>& wanted) {
  return double_literal(wanted.value_or(-std::numeric_limits<double>::infinity()));
}

View sampled_in_stage(const Plan& plan, const ProgramNames& names, const StageState& each) {
  const Graph& graph = *plan.graph;
  const std::string& owner =
      each.object ? graph.objects[*each.object].name : graph.nodes[each.node].name;
  const State& state = each.object ? graph.objects[*each.object].states[each.state]
                                   : graph.nodes[each.node].states[each.state];
  const std::string& field = each.object ? names.objects[*each.object].states[each.state].field
                                         : names.nodes[each.node].states[each.state].field;
  View view = object();
  view.set("state", owner + "/" + state.name);
  view.set("needs_random", each.random.kind != RandomSpec::Kind::value);
  view["range"] = View(false);
  if (needs_range(each.random)) {
    View range = object();
    range.set("type", message_type(state.space));
    range.set("literal", space_literal(range_of(each.random, state.space)));
    view["range"] = std::move(range);
  }
  view.set("lines", sample_lines(each.random, state.space, field, "kRange"));
  return view;
}

}  // namespace

View stages_view(const Plan& plan, const ProgramNames& names) {
  const auto& task = plan.graph->task;
  if (!task || task->stages.empty() || names.is_split()) return View(false);
  std::vector<std::string> stage_names, untils, scales;
  View samples = list();
  for (const Stage& stage : task->stages) {
    stage_names.push_back(cpp_string(stage.name));
    untils.push_back(braced({limit(stage.success), limit(stage.mean_return)}));
    std::vector<std::string> own;
    for (std::size_t i = 0; i < stage.weights.size(); ++i) {
      const double weight = task->terms[i].weight;
      own.push_back(float_literal(
          stage.weights[i] == weight ? 1.0F : static_cast<float>(stage.weights[i] / weight)));
    }
    scales.push_back(braced(own));
    View item = object();
    item.set("number", fmt::format("{}", samples.list_value().size()));
    item.set("stage", stage.name);
    View states = list();
    for (const StageState& state : stage.states)
      states.push_back(sampled_in_stage(plan, names, state));
    item["states"] = std::move(states);
    samples.push_back(std::move(item));
  }
  View view = object();
  view.set("stage_names", joined(stage_names));
  view.set("untils", joined(untils));
  view.set("scales", joined(scales));
  view.set("terms", fmt::format("{}", task->terms.size()));
  view["samples"] = std::move(samples);
  return view;
}

}  // namespace eagerx::gen

#include "generator/backend/languages/timetable.hpp"

#include <fmt/format.h>

#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

/// "0u, 2u"; an array of C has at least one element.
std::string indices(const std::vector<std::size_t>& values) {
  return values.empty() ? "0u" : fmt::format("{}u", join(values, "u, "));
}

View messages_view(const Plan& plan, const PartLayout& layout) {
  View views = list();
  for (std::size_t i = 0; i < layout.messages.size(); ++i) {
    const LayoutMessage& message = layout.messages[i];
    const Channel& channel = plan.channels[message.channel];
    const Space& space = plan.graph->nodes[channel.node].outputs[channel.output].space;
    View view = object();
    view.set("index", fmt::format("{}", i));
    view.set("bytes", fmt::format("{}", message.bytes));
    view.set("keep", fmt::format("{}", message.keep));
    view.set("is_bool", space.dtype == Dtype::boolean ? "1" : "0");
    view.set("channel", channel.name);
    views.push_back(view);
  }
  return views;
}

}  // namespace

void add_timetable(const Plan& plan, const PartLayout& layout,
                   const std::map<std::size_t, std::string>& names, View& view) {
  View turns = list();
  for (const auto* phase : {&layout.before, &layout.after}) {
    for (std::size_t i = 0; i < phase->size(); ++i) {
      const LayoutTurn& turn = (*phase)[i];
      View item = object();
      item.set("is_before", phase == &layout.before);
      item.set("list", phase == &layout.before ? "before" : "after");
      item.set("index", fmt::format("{}", i));
      item.set("indices", indices(turn.messages));
      item.set("count", fmt::format("{}", turn.messages.size()));
      item.set("rate", fmt::format("{}", plan.nodes[turn.node].rate));
      item.set("run", turn.runs ? "run_" + names.at(turn.node) : "0");
      item.set("node", plan.graph->nodes[turn.node].name);
      turns.push_back(item);
    }
  }
  view["turns"] = std::move(turns);
  view["messages"] = messages_view(plan, layout);
  std::vector<std::string> periods;
  for (const RateClass& rate : plan.rates) periods.push_back(fmt::format("{}u", rate.period));
  view.set("periods", fmt::format("{}", join(periods, ", ")));
  view.set("rate_count", fmt::format("{}", plan.rates.size()));
  view.set("step_rate", fmt::format("{}", plan.nodes[Graph::kEnvironment].rate));
  view.set("safe_steps", plan.graph->safety.declared ? "1" : "0");
  view.set("actions", indices(layout.actions));
  view.set("action_count", fmt::format("{}", layout.actions.size()));
  view.set("before_count", fmt::format("{}", layout.before.size()));
  view.set("after_count", fmt::format("{}", layout.after.size()));
}

}  // namespace eagerx::gen

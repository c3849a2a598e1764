// What limits.hpp is rendered with: spaces, and what `safety:` says.
#include <fmt/format.h>

#include <algorithm>

#include "generator/emit/names.hpp"
#include "generator/emit/types.hpp"

namespace eagerx::gen {
namespace {

class LimitsView {
 public:
  LimitsView(const Plan& plan, const ProgramNames& names) : graph_(*plan.graph), names_(names) {
    constants_.unique("kSafety");
  }

  View make() {
    add_actions();
    add_observations();
    add_safety();
    return std::move(view_);
  }

 private:
  View space_view(const std::string& field, const Space& space, Span span,
                  const std::string& prefix) {
    View item = object();
    item.set("field", field);
    item.set("type", message_type(space));
    item.set("place", names_.place(span));
    item.set("constant", constants_.unique("k" + prefix + camel(field)));
    item.set("literal", space_literal(space));
    return item;
  }

  void add_actions() {
    View actions = list(), actuators = list();
    std::vector<View> views;
    for (const auto& action : graph_.environment().outputs)
      views.push_back(space_view(action.name, action.space, action.span, "Action"));
    for (std::size_t i = 0; i < views.size(); ++i) {
      const AppliedAction& applied = graph_.applied[i];
      views[i].set("applied", views[i].get("constant")->string_value());
      if (!applied.narrowed_by.empty()) {
        View item = space_view(graph_.environment().outputs[i].name, applied.space, applied.span,
                               "Applied");
        item.set("what", applied.narrowed_by);
        views[i].set("applied", item.get("constant")->string_value());
        actuators.push_back(item);
      }
      actions.push_back(views[i]);
    }
    view_.set("has_actions", actions.is_non_empty_list());
    view_["actions"] = std::move(actions);
    view_["actuators"] = std::move(actuators);
  }

  void add_observations() {
    View observations = list();
    if (names_.receives(Graph::kEnvironment)) {
      for (const auto& input : graph_.environment().inputs)
        observations.push_back(space_view(input.name, input.space, input.span, "Observation"));
    }
    view_.set("has_observations", observations.is_non_empty_list());
    view_["observations"] = std::move(observations);
  }

  void add_safety() {
    constexpr std::int64_t kNsPerSecond = 1'000'000'000;
    const Safety& safety = graph_.safety;
    view_.set("safety_place", text_or_false(safety.declared ? names_.place(safety.span) : ""));
    view_.set("declared", bool_literal(safety.declared));
    view_.set("late", fmt::format("{}", safety.late));
    const auto whole_ns = [](const Rational& seconds) {
      return fmt::format("{}", (seconds * Rational(kNsPerSecond)).floor());
    };
    view_.set("max_lateness_ns", whole_ns(safety.max_lateness_s));
    view_.set("link_timeout_ns", whole_ns(safety.link_timeout_s));
    view_.set("missed", fmt::format("{}", safety.missed));
    view_.set("recover", fmt::format("{}", safety.recover));
    view_.set("clips", bool_literal(safety.clips));
    view_.set("holds", bool_literal(safety.holds));
    std::vector<std::string> values;
    for (std::size_t i = 0; i < safety.actions.size(); ++i) {
      std::vector<double> value = safety.actions[i];
      if (std::count(value.begin(), value.end(), value.front()) == std::ssize(value))
        value.resize(1);  // one for all elements
      values.push_back(message_literal(value, graph_.environment().outputs[i].space));
    }
    view_.set("safe_action", braced(values));
  }

  const Graph& graph_;
  const ProgramNames& names_;
  Names constants_;
  View view_ = object();
};

}  // namespace

View limits_view(const Plan& plan, const ProgramNames& names) {
  return LimitsView(plan, names).make();
}

}  // namespace eagerx::gen

// The view of limits.hpp: spaces, and the settings of `safety:`.
#include <fmt/format.h>

#include <algorithm>

#include "generator/backend/emit/names.hpp"
#include "generator/backend/emit/types.hpp"
#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {
namespace {

class LimitsView {
 public:
  LimitsView(const Plan& plan, const ProgramNames& names)
      : plan_(plan), graph_(*plan.graph), names_(names) {
    constants_.unique("kSafety");
  }

  View make() {
    add_actions();
    add_observations();
    add_outputs();
    add_safety();
    return std::move(view_);
  }

 private:
  void add_actions() {
    View actions = list(), actuators = list();
    std::vector<View> views;
    for (const auto& action : graph_.environment().outputs)
      views.push_back(space_view(action.name, action.space, "Action", constants_));
    for (std::size_t i = 0; i < views.size(); ++i) {
      const AppliedAction& applied = graph_.applied[i];
      views[i].set("applied", views[i].get("constant")->string_value());
      if (!applied.narrowed_by.empty()) {
        View item =
            space_view(graph_.environment().outputs[i].name, applied.space, "Applied", constants_);
        item.set("what", applied.narrowed_by);
        views[i].set("applied", item.get("constant")->string_value());
        actuators.push_back(std::move(item));
      }
      actions.push_back(views[i]);
    }
    add_names("action", graph_.environment().outputs);
    view_.set("has_actions", actions.is_non_empty_list());
    view_["actions"] = std::move(actions);
    view_["actuators"] = std::move(actuators);
  }

  void add_observations() {
    View observations = list();
    if (names_.receives(Graph::kEnvironment)) {
      for (const auto& input : graph_.environment().inputs)
        observations.push_back(space_view(input.name, input.space, "Observation", constants_));
    }
    view_.set("has_observations", observations.is_non_empty_list());
    view_["observations"] = std::move(observations);
    std::vector<Input> seen;
    if (names_.receives(Graph::kEnvironment)) seen = graph_.environment().inputs;
    add_names("observation", seen);
    std::vector<std::string> may_wait;
    may_wait.reserve(seen.size());
    for (const auto& input : seen) may_wait.push_back(bool_literal(input.skip));
    view_.set("may_wait", braced(may_wait));
  }

  /// How many there are, and their names as texts.
  template <class Ports>
  void add_names(const std::string& what, const Ports& ports) {
    std::vector<std::string> texts;
    texts.reserve(ports.size());
    for (const auto& port : ports) texts.push_back(cpp_string(port.name));
    view_.set(what + "_count", fmt::format("{}", texts.size()));
    view_.set(what + "_names", braced(texts));
  }

  /// Outputs of a graph without engine.
  void add_outputs() {
    const bool guards = guards_outputs(plan_, names_);
    view_.set("guards_outputs", guards);
    View outputs = list();
    std::vector<Input> ports;
    for (const SafeOutput& output : graph_.safety.outputs) {
      if (!guards) break;
      const Input& input = graph_.environment().inputs[output.input];
      ports.push_back(input);
      View item = space_view(input.name, output.space, "Output", constants_);
      item.set("value", message_literal(shortened(output.value), output.space));
      const Rational steps = output.hold_s * graph_.environment().rate_hz;
      item.set("hold_steps", output.holds_always
                                 ? "eagerx::SafeOutput<" + message_type(output.space) + ">::kAlways"
                                 : fmt::format("{}", steps.floor()));
      item.set("most_change", literal(output.ramp_per_s / graph_.environment().rate_hz.to_double(),
                                      output.space.dtype));
      outputs.push_back(std::move(item));
    }
    add_names("output", ports);
    view_.set("all_outputs", bool_literal(ports.size() == graph_.environment().inputs.size()));
    std::vector<std::string> frozen;
    for (const std::uint32_t steps : graph_.safety.frozen)
      frozen.push_back(fmt::format("{}", steps));
    view_.set("frozen", braced(frozen));
    view_.set("resets_nodes", bool_literal(graph_.safety.resets_nodes));
    view_["outputs"] = std::move(outputs);
  }

  /// One number for all elements where they are equal.
  static std::vector<double> shortened(std::vector<double> value) {
    if (std::count(value.begin(), value.end(), value.front()) == std::ssize(value)) value.resize(1);
    return value;
  }

  void add_safety() {
    constexpr std::int64_t kNsPerSecond = 1'000'000'000;
    const Safety& safety = graph_.safety;
    view_.set("has_safety", safety.declared);
    view_.set("declared", bool_literal(safety.declared));
    view_.set("late", fmt::format("{}", safety.late));
    const auto whole_ns = [](const Rational& seconds) {
      return fmt::format("{}", (seconds * Rational(kNsPerSecond)).floor());
    };
    view_.set("max_lateness_ns", whole_ns(safety.max_lateness_s));
    view_.set("link_timeout_ns", whole_ns(safety.link_timeout_s));
    view_.set("heartbeat_timeout_ns", whole_ns(safety.heartbeat_timeout_s));
    view_.set("missed", fmt::format("{}", safety.missed));
    view_.set("recover", fmt::format("{}", safety.recover));
    view_.set("clips", bool_literal(safety.clips));
    view_.set("holds", bool_literal(safety.holds));
    std::vector<FieldValue> values;
    for (std::size_t i = 0; i < safety.actions.size(); ++i) {
      const Output& action = graph_.environment().outputs[i];
      values.push_back({action.name, message_literal(shortened(safety.actions[i]), action.space)});
    }
    view_.set("safe_action", designated(values));
  }

  const Plan& plan_;
  const Graph& graph_;
  const ProgramNames& names_;
  Names constants_;
  View view_ = object();
};

}  // namespace

bool guards_outputs(const Plan& plan, const ProgramNames& names) {
  return !plan.graph->safety.outputs.empty() && names.runs(Graph::kEnvironment) &&
         !names.is_placed();
}

View limits_view(const Plan& plan, const ProgramNames& names) {
  return LimitsView(plan, names).make();
}

}  // namespace eagerx::gen

#include "generator/emit/reset_view.hpp"

#include <fmt/format.h>

#include "generator/emit/types.hpp"

namespace eagerx::gen {
namespace {

class ResetView {
 public:
  ResetView(const Plan& plan, const ProgramNames& names, View& view)
      : plan_(plan), graph_(*plan.graph), names_(names), view_(view) {}

  void add() {
    collect_targets();
    add_engine_states();
    add_nodes();
    add_delays();
    add_cursors();
    add_reset_nodes();
    std::vector<std::string> started = {names_.node_member[Graph::kEngine]};
    started.insert(started.end(), names_.simulator_member.begin(), names_.simulator_member.end());
    view_.set("start_arguments", joined(started));
    view_.set("uses_states", uses_states_);
    view_.set("ignores_states", !uses_states_);
    view_.set("has_engine", names_.has_engine());
    const bool keeps =
        (names_.has_engine() && !graph_.objects.empty()) || has_delays_ || graph_.has_reset_nodes();
    view_.set("has_start", keeps);
  }

 private:
  /// The expression that a state's owner is given, with `value` what the caller set.
  static std::string received(const State& state, const std::string& value,
                              const std::string& processor) {
    return state.processor ? fmt::format("{}::convert({})", processor, value) : value;
  }

  static std::string optional(const std::string& field, const std::string& processor) {
    if (processor.empty()) return field;
    return fmt::format("{0} ? std::optional({1}::convert(*{0})) : std::nullopt", field, processor);
  }

  void collect_targets() {
    for (const auto& item : graph_.objects) is_object_target_.emplace_back(item.states.size());
    for (const auto& node : graph_.nodes) is_node_target_.emplace_back(node.states.size());
    for (const auto& node : graph_.nodes) {
      for (const auto& target : node.reset_targets) {
        (target.object ? is_object_target_[*target.object]
                       : is_node_target_[target.node])[target.state] = true;
      }
    }
  }

  void add_engine_states() {
    View engine_states = list();
    for (std::size_t i = 0; names_.has_engine() && i < graph_.objects.size(); ++i) {
      for (std::size_t s = 0; s < graph_.objects[i].states.size(); ++s) {
        const std::string field = "states." + names_.object_state[i][s];
        View state = object();
        state.set("field", field + (is_object_target_[i][s] ? " && sets_targets" : ""));
        state.set("value", received(graph_.objects[i].states[s], "*" + field,
                                    names_.object_state_processor[i][s]));
        state.set("type", names_.engine_state_type[i][s]);
        state.set("simulator", names_.simulator_member[i]);
        engine_states.push_back(state);
        uses_states_ = true;
      }
    }
    view_["engine_states"] = std::move(engine_states);
  }

  void add_nodes() {
    View resets = list();
    for (const std::size_t n : nodes_in_order(plan_)) {
      if (!names_.runs(n)) continue;
      const GraphNode& node = graph_.nodes[n];
      std::vector<std::string> states, delays;
      for (std::size_t s = 0; s < node.states.size(); ++s) states.push_back(state_argument(n, s));
      for (std::size_t i = 0; i < node.inputs.size(); ++i) {
        if (node.inputs[i].entity_sets_delay) delays.push_back(names_.delay_member[n][i]);
      }
      View reset = object();
      reset.set("call", n == Graph::kEngine ? reset_engine(states) : reset_node(n, states, delays));
      resets.push_back(reset);
    }
    view_["resets"] = std::move(resets);
  }

  std::string reset_node(std::size_t n, const std::vector<std::string>& states,
                         const std::vector<std::string>& delays) const {
    return fmt::format("{}.reset({{{}}}{}{})", names_.node_member[n], joined(states),
                       delays.empty() ? "" : fmt::format(", {{{}}}", joined(delays)),
                       simulator_argument(plan_, names_, n));
  }

  /// Whether the engine's reset takes the simulators, too, is for the C++ compiler to see.
  std::string reset_engine(const std::vector<std::string>& states) const {
    std::vector<std::string> arguments = {
        names_.node_member[Graph::kEngine],
        fmt::format("{}::States{{{}}}", names_.io[Graph::kEngine], joined(states))};
    const auto& simulators = names_.simulator_member;
    arguments.insert(arguments.end(), simulators.begin(), simulators.end());
    return fmt::format("if (eagerx::runs_engine(trace)) eagerx::reset_engine({})",
                       joined(arguments));
  }

  std::string state_argument(std::size_t n, std::size_t s) {
    const State& state = graph_.nodes[n].states[s];
    if (!state.settable) return "{}";
    uses_states_ = true;
    std::string value =
        optional("states." + names_.node_state[n][s], names_.node_state_processor[n][s]);
    if (!is_node_target_[n][s]) return value;
    return fmt::format("sets_targets ? {} : std::nullopt",
                       state.processor ? "(" + value + ")" : value);
  }

  void add_delays() {
    View delays = list(), idle = list();
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n) {
      for (std::size_t i = 0; i < graph_.nodes[n].inputs.size(); ++i) {
        const Reception& reception = plan_.nodes[n].receptions[i];
        if (names_.delay_member[n][i].empty() || !names_.receives(n)) continue;
        const Input& input = graph_.nodes[n].inputs[i];
        View delay = object();
        delay.set("member", names_.delay_member[n][i]);
        delay.set("where", input.written);
        if (!reception.changing) {  // an entity sets it, and delays are not simulated
          idle.push_back(delay);
          continue;
        }
        delay.set("first", double_literal(input.delay_s.to_double()));
        delay.set("quanta", quanta_type(*reception.changing));
        delay.set("state", names_.delay_state[n][i]);
        delay.set("settable", !names_.delay_state[n][i].empty());
        uses_states_ = uses_states_ || !names_.delay_state[n][i].empty();
        delays.push_back(delay);
      }
    }
    has_delays_ = delays.is_non_empty_list();
    view_.set("has_changing_delays", has_delays_);
    view_["changing_delays"] = std::move(delays);
    view_.set("has_idle_delays", idle.is_non_empty_list());
    view_["idle_delays"] = std::move(idle);
  }

  static std::string quanta_type(const Reception::Changing& changing) {
    return fmt::format("eagerx::DelayQuanta<{}, {}, {}>", changing.num, changing.den,
                       changing.longest_ns);
  }

  void add_cursors() {
    View cursors = list();
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n) {
      if (!names_.receives(n)) continue;
      for (std::size_t i = 0; i < graph_.nodes[n].inputs.size(); ++i) {
        const Reception& reception = plan_.nodes[n].receptions[i];
        const std::string& where = graph_.nodes[n].inputs[i].written;
        const auto add = [&](const std::string& member, const std::string& type,
                             const std::string& x) {
          View cursor = object();
          cursor.set("member", member);
          cursor.set("type", type);
          cursor.set("x", x);
          cursor.set("where", where);
          cursors.push_back(cursor);
        };
        const std::string x = reception.changing
                                  ? fmt::format("{}::of({})", quanta_type(*reception.changing),
                                                names_.delay_member[n][i])
                                  : fmt::format("{}", reception.x);
        if (reception.count == Reception::Count::delayed) {
          add(names_.cursor[n][i],
              fmt::format("eagerx::DelayCursor<{}, {}>", reception.a, reception.b), x);
        } else if (reception.count == Reception::Count::skipped) {
          add(names_.cursor[n][i],
              fmt::format("eagerx::SkipCursor<{}, {}, {}>", reception.a, reception.b,
                          reception.off),
              x);
        }
        if (reception.count == Reception::Count::arrived) {
          add(names_.cursor[n][i],
              fmt::format("eagerx::ArrivalCursor<{}, {}>", plan_.rings[reception.ring].capacity,
                          reception.max_size),
              reception.changing ? x : fmt::format("{}", reception.delay_ns));
        }
        if (!names_.fresh[n][i].empty()) add(names_.fresh[n][i], "eagerx::NewMessages", "");
      }
    }
    view_.set("has_cursors", cursors.is_non_empty_list());
    view_["cursors"] = std::move(cursors);
  }

  void add_reset_nodes() {
    View reset_nodes = list();
    std::vector<std::string> asked, open;
    for (const std::size_t n : nodes_in_order(plan_)) {
      const GraphNode& node = graph_.nodes[n];
      if (!node.is_reset_node()) continue;
      std::vector<std::string> targets;
      for (std::size_t t = 0; t < node.reset_targets.size(); ++t) {
        const ResetTarget& target = node.reset_targets[t];
        const std::string field =
            "states." + (target.object ? names_.object_state[*target.object][target.state]
                                       : names_.node_state[target.node][target.state]);
        targets.push_back(optional(field, names_.target_processor[n][t]));
        asked.push_back(field);
        open.push_back(fmt::format("{0}.{2} && !{1}.{2}", names_.targets_member[n],
                                   names_.done_member[n], target.name));
      }
      View item = object();
      item.set("io", names_.io[n]);
      item.set("targets_member", names_.targets_member[n]);
      item.set("done_member", names_.done_member[n]);
      item.set("targets", "{" + joined(targets) + "}");
      item.set("node", node.name);
      reset_nodes.push_back(item);
    }
    view_.set("has_reset_nodes", graph_.has_reset_nodes());
    view_.set("no_reset_nodes", !graph_.has_reset_nodes());
    view_["reset_nodes"] = std::move(reset_nodes);
    // One condition needs no parentheses.
    const bool several = asked.size() > 1;
    const std::string any = fmt::format("{}", fmt::join(asked, " || "));
    view_.set("asked", several ? "(" + any + ")" : any);
    view_.set("open", several ? fmt::format("({})", fmt::join(open, ") || (")) : joined(open));
    view_.set("environment_counter", names_.counter[plan_.nodes[Graph::kEnvironment].rate]);
    const Rational ticks = graph_.reset_timeout_s * graph_.environment().rate_hz;
    view_.set("reset_ticks", fmt::format("{}", ticks.ceil()));
    view_.set("reset_timeout", graph_.reset_timeout_s.to_string());
  }

  const Plan& plan_;
  const Graph& graph_;
  const ProgramNames& names_;
  View& view_;
  std::vector<std::vector<bool>> is_object_target_, is_node_target_;
  bool uses_states_ = false;
  bool has_delays_ = false;
};

}  // namespace

std::string joined(const std::vector<std::string>& items) {
  return fmt::format("{}", fmt::join(items, ", "));
}

std::string braced(const std::vector<std::string>& items, std::size_t indent, std::size_t before) {
  constexpr std::size_t kColumns = 100;
  std::string line = "{" + joined(items) + "}";
  if (before + line.size() + 1 <= kColumns || items.empty()) return line;  // 1: the semicolon
  const std::string separator = ",\n" + std::string(indent + 4, ' ');
  return fmt::format("{{{}{}}}", separator.substr(1), fmt::join(items, separator));
}

std::vector<std::size_t> nodes_in_order(const Plan& plan) {
  std::vector<std::size_t> nodes = {Graph::kEngine};
  for (const auto* phase : {&plan.before, &plan.after}) {
    for (const std::size_t n : *phase) {
      if (n != Graph::kEngine) nodes.push_back(n);
    }
  }
  return nodes;
}

std::string simulator_argument(const Plan& plan, const ProgramNames& names, std::size_t node) {
  const auto& owner = plan.graph->nodes[node].object;
  return owner ? ", " + names.simulator_member[*owner] : "";
}

void add_reset(const Plan& plan, const ProgramNames& names, View& view) {
  ResetView(plan, names, view).add();
}

}  // namespace eagerx::gen

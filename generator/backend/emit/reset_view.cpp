#include "generator/backend/emit/reset_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "generator/backend/emit/schedule_view.hpp"
#include "generator/backend/emit/types.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

class ResetView {
 public:
  ResetView(const Plan& plan, const ProgramNames& names)
      : plan_(plan), graph_(*plan.graph), names_(names) {}

  View make() {
    collect_targets();
    add_nodes();
    add_tuned();
    view_["engine"] = names_.has_engine() ? engine() : View(false);
    add_delays();
    add_cursors();
    add_parts();
    view_["routine"] = graph_.has_reset_nodes() ? routine() : View(false);
    view_.set("uses_states", uses_states_);
    view_.set("resets_use_states", resets_use_states_);
    const bool keeps =
        (names_.has_engine() && !graph_.objects.empty()) || has_delays_ || graph_.has_reset_nodes();
    view_.set("has_start", keeps);
    const Rational ticks = graph_.reset_timeout_s * graph_.environment().rate_hz;
    view_.set("most_ticks", fmt::format("{}", ticks.ceil()));
    add_most_slots(static_cast<std::uint64_t>(ticks.ceil()));
    return std::move(view_);
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

  /// Code that starts and resets the engine: first the states of its objects.
  View engine() {
    View states = list();
    for (std::size_t i = 0; i < graph_.objects.size(); ++i) {
      for (std::size_t s = 0; s < graph_.objects[i].states.size(); ++s) {
        const std::string field = "states." + names_.objects[i].states[s].field;
        View state = object();
        state.set("condition", field + (is_object_target_[i][s] ? " && sets_targets" : ""));
        state.set("value", received(graph_.objects[i].states[s], "*" + field,
                                    names_.objects[i].states[s].processor));
        state.set("type", names_.objects[i].states[s].type);
        state.set("simulator", names_.objects[i].simulator_member);
        states.push_back(std::move(state));
        uses_states_ = true;
      }
    }
    std::vector<std::string> all = {names_.nodes[Graph::kEngine].member.expression()};
    for (const EmitObject& object : names_.objects) all.push_back(object.simulator_member);
    View view = object();
    view.set("all", joined(all));
    // Whether the engine's reset takes the simulators, too, is for the C++ compiler to see.
    all.insert(all.begin() + 1, names_.nodes[Graph::kEngine].io + "::States" +
                                    designated(state_arguments(Graph::kEngine)));
    view.set("reset_call", fmt::format("eagerx::reset_engine({})", joined(all)));
    view.set("has_states", states.is_non_empty_list());
    view["states"] = std::move(states);
    return view;
  }

  void add_nodes() {
    View resets = list();
    for (const std::size_t n : nodes_in_order(plan_)) {
      if (graph_.nodes[n].role == NodeRole::engine || !names_.runs(n)) continue;
      std::vector<std::string> arguments = {designated(state_arguments(n))};
      std::vector<FieldValue> delays;
      const GraphNode& node = graph_.nodes[n];
      for (std::size_t i = 0; i < node.inputs.size(); ++i) {
        if (node.inputs[i].entity_sets_delay)
          delays.push_back({node.inputs[i].name, names_.nodes[n].inputs[i].delay_member});
      }
      if (!delays.empty()) arguments.push_back(designated(delays));
      View reset = object();
      reset.set("is_drawn", node.drawn);
      reset.set("call", fmt::format("{}.reset({}{})", names_.nodes[n].member.expression(),
                                    joined(arguments), simulator_argument(plan_, names_, n)));
      resets.push_back(std::move(reset));
    }
    view_["resets"] = std::move(resets);
  }

  /// Nodes with parameters that can be set while an episode runs.
  void add_tuned() {
    View nodes = list();
    for (const std::size_t n : nodes_in_order(plan_)) {
      if (!names_.runs(n)) continue;
      std::vector<FieldValue> arguments;
      bool tunes = false;
      for (std::size_t s = 0; s < graph_.nodes[n].states.size(); ++s) {
        const State& state = graph_.nodes[n].states[s];
        arguments.push_back({state.name, state.tunes_running
                                             ? optional("states." + names_.nodes[n].states[s].field,
                                                        names_.nodes[n].states[s].processor)
                                             : "{}"});
        tunes = tunes || state.tunes_running;
      }
      if (!tunes) continue;
      View node = object();
      node.set("call", fmt::format("{}.tune({})", names_.nodes[n].member.expression(),
                                   designated(arguments)));
      nodes.push_back(std::move(node));
    }
    view_.set("has_tuned", nodes.is_non_empty_list());
    view_["tuned"] = std::move(nodes);
  }

  std::vector<FieldValue> state_arguments(std::size_t n) {
    std::vector<FieldValue> arguments;
    for (std::size_t s = 0; s < graph_.nodes[n].states.size(); ++s)
      arguments.push_back({graph_.nodes[n].states[s].name, state_argument(n, s)});
    return arguments;
  }

  std::string state_argument(std::size_t n, std::size_t s) {
    const State& state = graph_.nodes[n].states[s];
    if (!state.settable) return "{}";
    uses_states_ = resets_use_states_ = true;
    std::string value =
        optional("states." + names_.nodes[n].states[s].field, names_.nodes[n].states[s].processor);
    if (!is_node_target_[n][s]) return value;
    return fmt::format("sets_targets ? {} : std::nullopt",
                       state.processor ? "(" + value + ")" : value);
  }

  void add_delays() {
    View delays = list(), idle = list();
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n) {
      for (std::size_t i = 0; i < graph_.nodes[n].inputs.size(); ++i) {
        const Reception& reception = plan_.nodes[n].receptions[i];
        if (names_.nodes[n].inputs[i].delay_member.empty() || !names_.receives(n)) continue;
        const Input& input = graph_.nodes[n].inputs[i];
        View delay = object();
        delay.set("member", names_.nodes[n].inputs[i].delay_member);
        delay.set("where", input.written);
        if (!reception.changing) {  // an entity sets it, and delays are not simulated
          idle.push_back(std::move(delay));
          continue;
        }
        delay.set("first", double_literal(input.delay_s.to_double()));
        delay.set("quanta", quanta_type(*reception.changing));
        delay.set("state", text_or_false(names_.nodes[n].inputs[i].delay_state));
        uses_states_ = uses_states_ || !names_.nodes[n].inputs[i].delay_state.empty();
        delays.push_back(std::move(delay));
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

  /// How an input counts, if that is an object; what it starts with is a number of messages' quanta
  /// or, by the clock, of nanoseconds.
  std::string cursor_type(const Reception& reception) const {
    const char* const kind = names_.is_vectorized() ? "Lanes" : "Cursor";
    const char* const lanes = names_.is_vectorized() ? ", kLanes" : "";
    switch (reception.count) {
      case Reception::Count::delayed:
        return fmt::format("eagerx::Delay{}<{}, {}{}>", kind, reception.a, reception.b, lanes);
      case Reception::Count::skipped:
        return fmt::format("eagerx::Skip{}<{}, {}, {}{}>", kind, reception.a, reception.b,
                           reception.off, lanes);
      case Reception::Count::arrived:
        return fmt::format("eagerx::ArrivalCursor<{}, {}>", plan_.rings[reception.ring].capacity,
                           reception.max_size);
      default:
        return {};
    }
  }

  std::string first_of_cursor(const Reception& reception, const std::string& delay) const {
    if (reception.changing)
      return fmt::format("{}::of({})", quanta_type(*reception.changing), delay);
    const bool by_clock = reception.count == Reception::Count::arrived;
    return fmt::format("{}", by_clock ? reception.delay_ns : reception.x);
  }

  void add_cursors() {
    View cursors = list();
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n) {
      if (!names_.receives(n)) continue;
      for (std::size_t i = 0; i < graph_.nodes[n].inputs.size(); ++i) {
        const Reception& reception = plan_.nodes[n].receptions[i];
        View cursor = object();
        const Rational delay_s = graph_.nodes[n].inputs[i].delay_s;
        cursor.set("where", graph_.nodes[n].inputs[i].written);
        cursor["delay"] =
            (text_or_false(delay_s > Rational(0) && !reception.changing ? delay_s.to_string() + " s"
                                                                        : std::string()));
        if (const std::string type = cursor_type(reception); !type.empty()) {
          cursor.set("member", names_.nodes[n].inputs[i].cursor);
          cursor.set("type", type);
          cursor.set("first", first_of_cursor(reception, names_.nodes[n].inputs[i].delay_member));
          cursors.push_back(cursor);
        }
        if (names_.nodes[n].inputs[i].fresh.empty()) continue;
        cursor.set("member", names_.nodes[n].inputs[i].fresh);
        cursor.set("type",
                   names_.is_vectorized() ? "eagerx::NewLanes<kLanes>" : "eagerx::NewMessages");
        cursor.set("first", "");
        cursor["delay"] = View(false);
        cursors.push_back(std::move(cursor));
      }
    }
    view_.set("has_cursors", cursors.is_non_empty_list());
    view_["cursors"] = std::move(cursors);
  }

  /// The resets of nodes and of cursors, of many nodes in functions of their own.
  void add_parts() {
    const bool in_parts = graph_.nodes.size() > kMostNodesInOneFunction;
    view_.set("in_parts", in_parts);
    view_["node_parts"] = in_parts ? parts_of("reset_nodes", "resets") : list();
    view_["cursor_parts"] = in_parts ? parts_of("reset_cursors", "cursors") : list();
  }

  View parts_of(const char* function, const char* what) {
    View parts = list();
    const auto& items = view_[what].list_value();
    for (std::size_t i = 0; i < items.size(); i += kNodesInPart) {
      View part = object(), own = list();
      for (std::size_t k = i; k < std::min(i + kNodesInPart, items.size()); ++k)
        own.push_back(items[k]);
      part.set("function", fmt::format("{}_{}", function, i / kNodesInPart));
      part[what] = std::move(own);
      parts.push_back(std::move(part));
    }
    return parts;
  }

  /// The slots of a routine in this number of ticks, if 32 bits can count them: a limit that the
  /// analysis of an image finds (generator/analysis/bound).
  void add_most_slots(std::uint64_t ticks) {
    const std::uint64_t in_tick = most_slots(plan_);
    const bool fits = ticks <= std::numeric_limits<std::uint32_t>::max() / in_tick;
    view_["most_slots"] = View(false);
    if (fits) view_.set("most_slots", fmt::format("{}", ticks * in_tick));
    view_.set("counts_ticks", fits && in_tick == 1);
  }

  /// The routine of the reset nodes.
  View routine() const {
    View reset_nodes = list();
    std::vector<std::string> asked, open;
    for (const std::size_t n : nodes_in_order(plan_)) {
      const GraphNode& node = graph_.nodes[n];
      if (!node.is_reset_node()) continue;
      std::vector<FieldValue> targets;
      for (std::size_t t = 0; t < node.reset_targets.size(); ++t) {
        const ResetTarget& target = node.reset_targets[t];
        const std::string field =
            "states." + (target.object ? names_.objects[*target.object].states[target.state].field
                                       : names_.nodes[target.node].states[target.state].field);
        targets.push_back({target.name, optional(field, names_.nodes[n].target_processors[t])});
        asked.push_back(field);
        open.push_back(fmt::format("{0}.{2} && !{1}.{2}", names_.nodes[n].targets_member,
                                   names_.nodes[n].done_member, target.name));
      }
      View item = object();
      item.set("io", names_.nodes[n].io);
      item.set("targets_member", names_.nodes[n].targets_member);
      item.set("done_member", names_.nodes[n].done_member);
      item.set("targets", designated(targets));
      reset_nodes.push_back(std::move(item));
    }
    View view = object();
    view["nodes"] = std::move(reset_nodes);
    // One condition needs no parentheses.
    const bool several = asked.size() > 1;
    const std::string any = fmt::format("{}", join(asked, " || "));
    view.set("asked", several ? "(" + any + ")" : any);
    view.set("open", several ? fmt::format("({})", join(open, ") || (")) : joined(open));
    view.set("timeout", graph_.reset_timeout_s.to_string());
    return view;
  }

  const Plan& plan_;
  const Graph& graph_;
  const ProgramNames& names_;
  View view_ = object();
  std::vector<std::vector<bool>> is_object_target_, is_node_target_;
  bool uses_states_ = false;
  bool resets_use_states_ = false;  // not only those of the engine
  bool has_delays_ = false;
};

}  // namespace

std::vector<std::size_t> nodes_in_order(const Plan& plan) {
  std::vector<std::size_t> nodes;
  const bool has_engine = plan.graph->has_engine();
  if (has_engine) nodes.push_back(Graph::kEngine);
  for (const auto* phase : {&plan.before, &plan.after}) {
    for (const std::size_t n : *phase) {
      if (!has_engine || n != Graph::kEngine) nodes.push_back(n);
    }
  }
  return nodes;
}

std::string simulator_argument(const Plan& plan, const ProgramNames& names, std::size_t node) {
  const auto& owner = plan.graph->nodes[node].object;
  return owner ? ", " + names.objects[*owner].simulator_member : "";
}

View reset_view(const Plan& plan, const ProgramNames& names) {
  return ResetView(plan, names).make();
}

}  // namespace eagerx::gen

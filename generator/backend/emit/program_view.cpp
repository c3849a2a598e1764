// program.hpp: memory, schedule and the body of a slot.
#include <fmt/format.h>

#include <algorithm>

#include "generator/backend/emit/arrival_view.hpp"
#include "generator/backend/emit/block_view.hpp"
#include "generator/backend/emit/link_view.hpp"
#include "generator/backend/emit/names.hpp"
#include "generator/backend/emit/reset_view.hpp"
#include "generator/backend/emit/schedule_view.hpp"
#include "generator/backend/emit/types.hpp"
#include "generator/graph/plan/vectorized.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

class ProgramView {
 public:
  ProgramView(const Plan& plan, const ProgramNames& names)
      : plan_(plan), graph_(*plan.graph), names_(names) {}

  View make() {
    const std::size_t rate = plan_.nodes[Graph::kEnvironment].rate;
    view_.set("engine", graph_.engine_id());
    view_.set("period", (Rational(1) / graph_.environment().rate_hz).to_string());
    view_.set("environment_due", names_.rates[rate].due);
    view_.set("vectorized", names_.is_vectorized());
    view_.set("derivatives", names_.has_derivatives());
    const Rational ticks = plan_.rates.front().rate_hz / graph_.environment().rate_hz;
    view_.set("ticks", fmt::format("{}", ticks.ceil()));
    view_.set("phases", fmt::format("{}", steps_in_hyperperiod(plan_)));
    view_.set("seq_type", names_.is_vectorized() ? "eagerx::LaneClock<kLanes>" : "eagerx::Seq");
    view_.set("environment_rate", rate_type(graph_.environment().rate_hz));
    view_.set("environment_counter", names_.rates[rate].counter);
    view_["schedule"] = schedule_view(plan_, names_);
    view_["arrivals"] = arrivals_view(plan_, names_);
    view_["reset"] = reset_view(plan_, names_);
    view_["task"] = outcome_view(plan_, names_);
    add_rates();
    add_actions();
    add_phases();
    add_observation();
    add_memory();
    add_split();
    return std::move(view_);
  }

 private:
  void add_rates() {
    View rates = list();
    const std::vector<bool> needed = vectorized_rates(plan_);
    for (std::size_t r = 0; r < plan_.rates.size(); ++r) {
      if (names_.is_vectorized() && !needed[r]) continue;
      View rate = object();
      rate.set("due", names_.rates[r].due);
      rate.set("counter", names_.rates[r].counter);
      rate.set("bit", fmt::format("{}", r));
      rate.set("rate_type", rate_type(plan_.rates[r].rate_hz));
      rates.push_back(std::move(rate));
    }
    view_["rates"] = std::move(rates);
    view_.set("one_rate", plan_.rates.size() == 1);  // which is due in every slot
    view_.set("due_type", plan_.rates.size() <= 32 ? "std::uint32_t" : "std::uint64_t");
  }

  void add_split() {
    const bool decides = names_.runs(Graph::kEnvironment);
    view_.set("what", what_runs());
    view_.set("is_split", names_.is_split());
    add_parts();
    add_pipelining();
    view_.set("is_host", names_.is_hub());
    view_.set("link_parameter", names_.is_split() ? ", class Link = eagerx::link::NoLink" : "");
    const bool acts = !graph_.environment().outputs.empty();
    view_.set("step_parameter",
              decides && acts ? "const Action& action" : "const Action& /*action*/");
    // With derivatives, what moves an action into its space is left out.
    const bool guarded = decides && acts && !names_.has_derivatives();
    view_.set("guards", guarded);
    const bool has_actuators =
        !decides && names_.is_hub() &&
        ranges::any_of(plan_.rings, [&](const Ring& ring) { return is_kept_within(plan_, ring); });
    view_.set("has_actuators", has_actuators);
    view_.set("needs_limits", guarded || has_actuators);
    const bool outputs = guards_outputs(plan_, names_) && guarded;
    view_.set("guards_outputs", outputs);
    view_.set("guard_type", outputs ? "OutputGuard" : "Guard");
    view_.set("guard_header", outputs ? "output_guard" : "guard");
    // Without an engine, actions are what a main loop measures: no answer to what it is given.
    view_.set("answers", guarded && graph_.has_engine());
    add_applied(!decides && names_.is_hub() && acts);
  }

  /// Actions that the other program has decided.
  void add_applied(bool is_elsewhere) {
    constexpr std::size_t kEnvironment = Graph::kEnvironment;
    view_["asks_for_action"] = is_elsewhere ? ask_view(plan_, names_, kEnvironment) : View(false);
    view_.set("has_applied", is_elsewhere);
    if (!is_elsewhere) return;
    std::vector<FieldValue> values;
    const auto& outputs = graph_.environment().outputs;
    // The tick of the observation that followed has been counted.
    for (std::size_t a = 0; a < outputs.size(); ++a)
      values.push_back(
          {outputs[a].name, ring_place(plan_, names_, plan_.nodes[kEnvironment].rings[a],
                                       names_.seq_of(kEnvironment) + " - 1")});
    view_.set("applied", designated(values));
  }

  [[nodiscard]] std::string what_runs() const {
    if (!names_.is_split()) return "The whole graph";
    if (names_.is_hub()) return "What runs in the hub of the graph";
    return fmt::format("What runs in part `{}` of the graph",
                       graph_.placement->parts[names_.program().index()].name);
  }
  void add_parts() {
    View parts = list();
    for (std::size_t part = 0; names_.is_hub() && part < graph_.placement->parts.size(); ++part) {
      View item = object();
      item.set("index", fmt::format("{}", part));
      item.set("constant", names_.parts[part]);
      parts.push_back(std::move(item));
    }
    view_["parts"] = std::move(parts);
  }

  /// Members of a hub that asks for messages before it needs them.
  void add_pipelining() {
    const bool is_pipelined = names_.is_pipelined();
    view_.set("link_header", is_pipelined ? "pipeline" : "star");
    view_.set("tell", is_pipelined ? "pipeline_.tell(*this, " : "hooks.on_message(");
    view_["takes"] = takes_view(plan_, names_);
    view_["pipelining"] = View(false);
    if (!is_pipelined) return;
    View pipelining = object();
    pipelining.set("part_count", fmt::format("{}", graph_.placement->parts.size()));
    pipelining.set("most_in_flight", fmt::format("{}", plan_.split->most_in_flight));
    pipelining.set("trace_bytes", fmt::format("{}", plan_.split->trace_bytes));
    pipelining.set("taken_count", fmt::format("{}", names_.place_in_taken(graph_.nodes.size())));
    view_["pipelining"] = std::move(pipelining);
  }

  void add_actions() {
    constexpr std::size_t kEnvironment = Graph::kEnvironment;
    View actions = list();
    const bool here = names_.runs(kEnvironment);
    add_lag(names_, kEnvironment, view_);
    const std::string seq = names_.lag(kEnvironment) > 0 ? "sent" : names_.seq_of(kEnvironment);
    for (std::size_t a = 0; a < graph_.environment().outputs.size(); ++a) {
      const Output& output = graph_.environment().outputs[a];
      const std::size_t ring = plan_.nodes[kEnvironment].rings[a];
      if (!names_.has_ring(ring)) continue;
      const MessagePlace place = message_place(plan_, names_, ring, seq);
      const std::string value = here ? "action." + output.name : place.expression;
      View action = object();
      action.set("field", output.name);
      action["slots"] = slots_view({place});
      action.set("ring", place.expression);
      action.set("is_here", here);
      add_links(names_, names_.links(kEnvironment, a),
                "channel::" + names_.nodes[kEnvironment].outputs[a].channel, action);
      action.set("conversions", conversions_view(plan_, names_, {ring, seq, value}));
      action.set("channel", "channel::" + names_.nodes[kEnvironment].outputs[a].channel);
      action.set("seq", seq);
      actions.push_back(std::move(action));
    }
    view_["actions"] = std::move(actions);
  }

  void add_phases() {
    view_["before"] = phase_view("run_before_action", plan_.before);
    view_["after"] = phase_view("run_after_action", plan_.after);
    const bool runs_after = view_["after"].is_object();
    view_.set("slot", runs_after ? "run_slot" : "run_before_action");
    const auto& schedule = plan_.schedule;
    view_.set("has_slot", runs_after && (schedule.form == ScheduleForm::kinds ||
                                         (schedule.form == ScheduleForm::constants &&
                                          schedule.masks.size() > 1)));
  }

  /// The work of a phase, in one function or in several; false if there is none.
  View phase_view(const std::string& phase, const std::vector<std::size_t>& nodes) const {
    if (graph_.nodes.size() <= kMostNodesInOneFunction) {
      View groups = groups_view(plan_, names_, nodes);
      if (!groups.is_non_empty_list()) return View(false);
      View view = object();
      view["groups"] = std::move(groups);
      view["chunks"] = list();
      return view;
    }
    View chunks = list();
    for (std::size_t i = 0; i < nodes.size(); i += kNodesInPart) {
      const auto begin = nodes.begin() + static_cast<std::ptrdiff_t>(i);
      const std::size_t count = std::min(kNodesInPart, nodes.size() - i);
      View groups = groups_view(plan_, names_, {begin, begin + static_cast<std::ptrdiff_t>(count)});
      if (!groups.is_non_empty_list()) continue;
      View chunk = object();
      chunk.set("function", fmt::format("{}_{}", phase, i / kNodesInPart));
      chunk["groups"] = std::move(groups);
      chunks.push_back(std::move(chunk));
    }
    if (!chunks.is_non_empty_list()) return View(false);
    View view = object();
    view["groups"] = list();
    view["chunks"] = std::move(chunks);
    return view;
  }

  void add_observation() {
    std::vector<FieldValue> windows, nothing;
    bool asks = false;
    const auto& inputs = graph_.environment().inputs;
    for (std::size_t i = 0; names_.receives(Graph::kEnvironment) && i < inputs.size(); ++i) {
      windows.push_back({inputs[i].name, window_argument(plan_, names_, Graph::kEnvironment, i)});
      const std::size_t ring = plan_.nodes[Graph::kEnvironment].receptions[i].ring;
      nothing.push_back(
          {inputs[i].name, fmt::format("{{{}, 0, 0}}", names_.rings[ring].expression())});
      asks = asks || asks_what_is_due(plan_, Graph::kEnvironment, i);
    }
    view_.set("observation", designated(windows));
    view_.set("nothing", "Observation" + designated(nothing));
    view_.set("observation_asks", asks);
  }

  /// Describes the messages of a ring: "motor.u", "motor.u for filter.signal".
  [[nodiscard]] std::string label_of(const Ring& ring) const {
    const std::string& port = names_.nodes[ring.node].outputs[ring.output].port;
    const GraphNode& node = graph_.nodes[ring.node];
    const std::string sent =
        port.empty() ? fmt::format("{}.{}", node.name, node.outputs[ring.output].name) : port;
    if (!ring.reader_node) return sent;
    const Input& input = graph_.nodes[*ring.reader_node].inputs[*ring.reader_input];
    return fmt::format("{} for {}", sent, input.written);
  }

  void add_memory() {
    View rings = list(), members = list(), counters = list();
    View drawn_rings = list(), drawn_members = list(), by_lane = list(), passing = list(),
         ticks = list();
    for (std::size_t r = 0; r < plan_.rings.size(); ++r) {
      const Ring& ring = plan_.rings[r];
      if (!names_.has_ring(r)) continue;
      View item = object();
      item.set("type", names_.message(ring.space));
      const bool drawn = is_drawn(plan_, ring);
      const std::string member = names_.rings[r].declaration();
      if (member.empty()) continue;
      const bool passes = names_.rings[r].owner == EmitMember::Owner::one_step;
      item.set("member", member);
      item.set("label", label_of(ring));
      item.set("clock", names_.rates[plan_.nodes[ring.node].rate].counter);
      item.set("capacity", fmt::format("{}", ring.capacity));
      item.set(
          "comment",
          text_or_false(ring.needed > 1 ? fmt::format("{} needs {}", ring.why, ring.needed) : ""));
      if (passes && graph_.has_engine() && ring.node == Graph::kEngine && !ring.reader_node) {
        View tick = item;
        tick.set("member", names_.rings[r].expression());
        ticks.push_back(std::move(tick));
      }
      (drawn ? drawn_rings : passes ? passing : rings).push_back(std::move(item));
    }
    const auto add = [](View& to, const std::string& type, const std::string& member,
                        const std::string& label) {
      View item = object();
      item.set("label", text_or_false(label));
      item.set("type", type);
      item.set("member", member);
      to.push_back(std::move(item));
    };
    for (std::size_t i = 0; names_.has_engine() && i < graph_.objects.size(); ++i)
      add(members, names_.objects[i].simulator_type, names_.objects[i].simulator_member,
          graph_.objects[i].name);
    for (const std::size_t n : nodes_in_order(plan_)) {
      if (!names_.runs(n)) continue;
      const Entity& entity = *graph_.nodes[n].entity;
      const std::string type = fmt::format(
          "{}<{}>", from_global_namespace(names_.class_of(entity).name), names_.nodes[n].io);
      if (graph_.nodes[n].drawn) {
        add(drawn_members, type, names_.nodes[n].member.declaration(), graph_.nodes[n].name);
        continue;
      }
      // Resets are of the environment's own program.
      if (names_.is_vectorized() && !graph_.nodes[n].reset_targets.empty()) continue;
      if (names_.by_lane(n)) {
        add(by_lane, fmt::format("{}<{}>", from_global_namespace(entity.cpp.name), names_.one(n)),
            names_.nodes[n].member.expression(), graph_.nodes[n].name);
        continue;
      }
      if (const std::string member = names_.nodes[n].member.declaration(); !member.empty())
        add(members, type, member, is_task(n) ? "" : graph_.nodes[n].name);
      if (entity.counts.empty()) continue;
      View item = object();
      item.set("node", graph_.nodes[n].name);
      item.set("member", names_.nodes[n].member.expression());
      counters.push_back(std::move(item));
    }
    view_.set("has_counts", names_.has_engine() || counters.is_non_empty_list());
    view_["node_counts"] = std::move(counters);
    view_["rings"] = std::move(rings);
    view_.set("passes", passing.is_non_empty_list());
    view_.set("now", passing.is_non_empty_list() ? ", now" : "");
    view_["passing"] = std::move(passing);
    view_["last_ticks"] = std::move(ticks);
    view_["members"] = std::move(members);
    view_.set("has_by_lane", by_lane.is_non_empty_list());
    view_["by_lane"] = std::move(by_lane);
    add_loops();
    view_.set("ports", graph_.cut && graph_.cut->port != nullptr);
    view_["drawing"] = View(false);
    if (!drawn_members.is_non_empty_list()) return;
    View drawing = object();
    drawing["drawn_rings"] = std::move(drawn_rings);
    drawing["drawn_members"] = std::move(drawn_members);
    view_["drawing"] = std::move(drawing);
  }

  /// Whether it is the node of `task:`, whose memory nothing in the graph reads.
  [[nodiscard]] bool is_task(std::size_t node) const {
    return graph_.task && graph_.task->node == node;
  }

  /// Differences between the chains of a loop, besides members.
  void add_loops() {
    View tables = list();
    const auto add = [&](const char* type, const std::string& table,
                         const std::vector<std::string>& values) {
      View item = object();
      item.set("type", type);
      item.set("table", table);
      item.set("count", fmt::format("{}", values.size()));
      item.set("values", braced(values));
      tables.push_back(std::move(item));
    };
    for (const auto& loop : names_.loops) {
      const std::size_t length = loop.repeat.length();
      for (std::size_t m = 0; m < length; ++m) {
        std::vector<std::string> labels;
        for (std::size_t j = 0; j < loop.repeat.count; ++j)
          labels.push_back(names_.nodes[loop.repeat.nodes[j * length + m]].label);
        add("const char* const", loop.labels[m], labels);
      }
      for (const auto& [table, values] : loop.tables) add("std::uint32_t", table, values);
    }
    view_.set("has_loops", tables.is_non_empty_list());
    view_["loop_tables"] = std::move(tables);
  }

  const Plan& plan_;
  const Graph& graph_;
  const ProgramNames& names_;
  View view_ = object();
};

}  // namespace

View program_view(const Plan& plan, const ProgramNames& names) {
  return ProgramView(plan, names).make();
}

}  // namespace eagerx::gen

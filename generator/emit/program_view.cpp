// program.hpp: memory, schedule and the body of a slot.
#include <fmt/format.h>

#include <algorithm>

#include "generator/emit/arrival_view.hpp"
#include "generator/emit/names.hpp"
#include "generator/emit/reset_view.hpp"
#include "generator/emit/schedule_view.hpp"
#include "generator/emit/types.hpp"

namespace eagerx::gen {
namespace {

// Functions of more nodes take the optimiser more than linear time: chunks of 32 halve the compile
// time of 1,000 nodes (templates/README.md, "Why it is so"). Below 100 nodes one function is easier
// to read.
constexpr std::size_t kMostNodesInOneFunction = 100;
constexpr std::size_t kChunk = 32;

class ProgramView {
 public:
  ProgramView(const Plan& plan, const ProgramNames& names)
      : plan_(plan), graph_(*plan.graph), names_(names) {}

  View make() {
    View view = object();
    view.set("engine", graph_.engine().entity->id.value);
    view.set("period", (Rational(1) / graph_.environment().rate_hz).to_string());
    view.set("environment_due", names_.due[environment_rate()]);
    view.set("environment_rate", rate_type(graph_.environment().rate_hz));
    view.set("environment_tick", names_.counter[environment_rate()] + " - 1");
    add_rates(view);
    add_schedule(plan_, names_, view);
    add_actions(view);
    add_phase(view, "before", plan_.before);
    add_phase(view, "after", plan_.after);
    const bool runs_after = view.get("after_calls")->is_non_empty_list() ||
                            view.get("after_groups")->is_non_empty_list();
    view.set("after_unused", !runs_after);
    view.set("after_used", runs_after);
    view.set("what", names_.is_board()   ? "What runs on the board of the graph"
                     : names_.is_split() ? "What runs on Linux of the graph"
                                         : "The whole graph");
    add_observation(view);
    add_arrivals(plan_, names_, view);
    add_memory(view);
    add_split(view);
    return view;
  }

 private:
  std::size_t environment_rate() const { return plan_.nodes[Graph::kEnvironment].rate; }
  std::string seq_of(std::size_t n) const { return names_.seq_of(n); }
  std::string tick_of(std::size_t n) const { return names_.counter[plan_.nodes[n].rate] + " - 1"; }

  void add_rates(View& view) const {
    View rates = list(), counters = list();
    for (std::size_t r = 0; r < plan_.rates.size(); ++r) {
      View rate = object();
      rate.set("due", names_.due[r]);
      rate.set("counter", names_.counter[r]);
      rate.set("bit", fmt::format("{}", r));
      rate.set("rate_type", rate_type(plan_.rates[r].rate_hz));
      View counter = object();
      counter.set("counter", names_.counter[r]);
      rates.push_back(rate);
      counters.push_back(counter);
    }
    view["rates"] = std::move(rates);
    view["counters"] = std::move(counters);
    view.set("rate_count", fmt::format("{}", plan_.rates.size()));
    view.set("due_type", plan_.rates.size() <= 32 ? "std::uint32_t" : "std::uint64_t");
  }

  void add_split(View& view) const {
    const bool decides = names_.runs(Graph::kEnvironment);
    view.set("is_split", names_.is_split());
    view.set("commands", names_.is_split() && !names_.is_board());
    view.set("link_parameter", names_.is_split() ? ", class Link = eagerx::link::NoLink" : "");
    // What the other program decides is given back.
    view.set("step_parameter", decides             ? "const Action& action"
                               : names_.is_board() ? "const Action& /*action*/"
                                                   : "Action& action");
    view.set("gives_action_back", !decides && !names_.is_board());
  }

  /// Rings that hold a channel as the processor of one of its readers converts it.
  View conversions(std::size_t n, std::size_t output, const std::string& source) const {
    View views = list();
    for (std::size_t r = plan_.channels.size(); r < plan_.rings.size();
         ++r) {  // behind the channels' own
      const Ring& ring = plan_.rings[r];
      if (ring.node != n || ring.output != output || !names_.has_ring(r)) continue;
      View view = object();
      view.set("target", ring_place(plan_, names_, r, seq_of(n)));
      view.set("processor", names_.input_processor[*ring.reader_node][*ring.reader_input]);
      view.set("source", source);
      views.push_back(view);
    }
    return views;
  }

  std::string channel(std::size_t n, std::size_t output) const {
    return "channel::" + names_.channel[n][output];
  }

  void add_actions(View& view) const {
    View actions = list();
    const bool here = names_.runs(Graph::kEnvironment);
    for (std::size_t a = 0; a < graph_.environment().outputs.size(); ++a) {
      const Output& output = graph_.environment().outputs[a];
      if (!names_.has_ring(plan_.nodes[Graph::kEnvironment].rings[a])) continue;
      View action = object();
      action.set("field", output.name);
      action.set("place", names_.place(output.span));
      const std::string ring = ring_place(plan_, names_, plan_.nodes[Graph::kEnvironment].rings[a],
                                          seq_of(Graph::kEnvironment));
      action.set("ring", ring);
      action.set("is_here", here);
      action.set("is_there", !here);
      action.set("sends", here && names_.crosses(Graph::kEnvironment, a));
      const std::string value = here ? "action." + output.name : ring;
      action.set("value", value);
      action.set("conversions", conversions(Graph::kEnvironment, a, value));
      action.set("channel", channel(Graph::kEnvironment, a));
      action.set("seq", seq_of(Graph::kEnvironment));
      actions.push_back(action);
    }
    view["actions"] = std::move(actions);
  }

  void add_phase(View& view, const std::string& phase,
                 const std::vector<std::size_t>& nodes) const {
    View calls = list(), chunks = list();
    const bool cut = graph_.nodes.size() > kMostNodesInOneFunction;
    for (std::size_t i = 0; cut && i < nodes.size(); i += kChunk) {
      const std::string function = fmt::format("{}_{}", phase, i / kChunk);
      View call = object();
      call.set("call", function);
      calls.push_back(call);
      View chunk = object();
      chunk.set("function", function);
      chunk.set("groups", groups({nodes.begin() + static_cast<std::ptrdiff_t>(i),
                                  nodes.begin() + static_cast<std::ptrdiff_t>(
                                                      std::min(i + kChunk, nodes.size()))}));
      chunks.push_back(chunk);
    }
    view[phase + "_calls"] = std::move(calls);
    view[phase + "_chunks"] = std::move(chunks);
    view.set(phase + "_groups", cut ? list() : groups(nodes));
  }

  /// Neighbours of one rate under one condition.
  View groups(const std::vector<std::size_t>& nodes) const {
    View views = list();
    for (std::size_t i = 0; i < nodes.size();) {
      const std::size_t rate = plan_.nodes[nodes[i]].rate;
      View group = object();
      group.set("due", names_.due[rate]);
      View blocks = list();
      for (; i < nodes.size() && plan_.nodes[nodes[i]].rate == rate; ++i)
        if (is_there(nodes[i])) blocks.push_back(block(nodes[i]));
      if (!blocks.is_non_empty_list()) continue;
      group["blocks"] = std::move(blocks);
      views.push_back(group);
    }
    return views;
  }

  /// Whether a node has something to do in this program: its callback, or to be received.
  bool is_there(std::size_t n) const {
    if (names_.runs(n) || graph_.nodes[n].is_reset_node()) return true;
    for (std::size_t o = 0; o < graph_.nodes[n].outputs.size(); ++o)
      if (names_.crosses(n, o)) return true;
    return false;
  }

  View block(std::size_t n) const {
    const GraphNode& node = graph_.nodes[n];
    View view = object();
    const bool engine = node.role == NodeRole::engine;
    view.set("is_engine", engine);
    view.set("is_node", !engine && names_.runs(n));
    view.set("is_remote", !names_.runs(n));
    view.set("begin_mark", begin_mark(node.name));
    view.set("end_mark", end_mark());
    view.set("node", node.name);
    view.set("label", string_literal(node.name));
    view.set("entity", node.entity->id.value);
    view.set("place", names_.place(node.span));
    view.set("member", names_.node_member[n]);
    view.set("seq", seq_of(n));
    view.set("now", tick_of(n));
    view.set("is_asynchronous", graph_.asynchronous);
    view.set("sent", names_.sent[n]);
    view.set("clock", names_.node_member[Graph::kEngine] + ".now_ns()");
    view.set("counter", names_.counter[plan_.nodes[n].rate]);
    view.set("io", names_.io[n]);
    view.set("only_in_episodes", graph_.has_reset_nodes() && node.waits_during_reset);
    view.set("always", !graph_.has_reset_nodes() || !node.waits_during_reset);
    add_done(view, n);
    if (engine) {
      add_engine(view, n);
    } else if (names_.runs(n)) {
      add_node(view, n);
    } else {
      add_remote(view, n);
    }
    return view;
  }

  /// Both programs know which targets a reset node has reached.
  void add_done(View& view, std::size_t n) const {
    View reached = list();
    for (const auto& target : graph_.nodes[n].reset_targets) {
      View item = object();
      item.set("flag", names_.done_member[n] + "." + target.name);
      reached.push_back(item);
    }
    view.set("sends_done", names_.is_split() ? reached : list());
    view["reached"] = std::move(reached);
  }

  /// What the other program sends of a node that runs there.
  void add_remote(View& view, std::size_t n) const {
    View received = list();
    for (std::size_t o = 0; o < graph_.nodes[n].outputs.size(); ++o) {
      if (!names_.crosses(n, o)) continue;
      const std::string ring = ring_place(plan_, names_, plan_.nodes[n].rings[o], seq_of(n));
      View message = object();
      message.set("ring", ring);
      message.set("channel", channel(n, o));
      message.set("seq", seq_of(n));
      message.set("conversions", conversions(n, o, ring));
      received.push_back(message);
    }
    view["received"] = std::move(received);
  }

  void add_engine(View& view, std::size_t n) const {
    std::vector<std::string> simulators = {fmt::format("eagerx::Tick{{{}}}", tick_of(n))};
    simulators.insert(simulators.end(), names_.simulator_member.begin(),
                      names_.simulator_member.end());
    view.set("simulators", joined(simulators));
    View simulated = list();
    for (std::size_t i = 0; i < graph_.objects.size(); ++i) {
      View item = object();
      item.set("object", string_literal(graph_.objects[i].name));
      item.set("simulator", names_.simulator_member[i]);
      simulated.push_back(item);
    }
    view["simulated"] = std::move(simulated);
    view.set("ring", ring_place(plan_, names_, plan_.nodes[n].rings.front(), seq_of(n)));
    view.set("channel", channel(n, 0));
  }

  void add_node(View& view, std::size_t n) const {
    const GraphNode& node = graph_.nodes[n];
    std::vector<std::string> inputs, outputs;
    for (std::size_t i = 0; i < node.inputs.size(); ++i) {
      if (!node.inputs[i].feedthrough) inputs.push_back(window_argument(plan_, names_, n, i));
    }
    View raw = list(), published = list(), slots = list();
    for (std::size_t o = 0; o < node.outputs.size(); ++o) {
      const Output& output = node.outputs[o];
      const std::size_t ring_index = plan_.nodes[n].rings[o];
      std::string ring = ring_place(plan_, names_, ring_index, seq_of(n));
      if (plan_.rings[ring_index].capacity > 1) {
        View slot = object();
        slot.set("slot", "new_" + output.name);
        slot.set("ring", ring);
        slots.push_back(slot);
        ring = "new_" + output.name;
      }
      const std::string local = "raw_" + output.name;
      View message = object();
      message.set("ring", ring);
      message.set("channel", channel(n, o));
      message.set("seq", seq_of(n));
      message.set("conversions", conversions(n, o, ring));
      message.set("sends", names_.crosses(n, o));
      message.set("converted", output.processor.has_value());
      message.set("processor", names_.output_processor[n][o]);
      message.set("local", local);
      published.push_back(message);
      outputs.push_back(output.processor ? local : ring);
      if (!output.processor) continue;
      View variable = object();
      variable.set("type", message_type(output.raw));
      variable.set("local", local);
      raw.push_back(variable);
    }
    view.set("inputs", braced(inputs, 8, 25 + names_.io[n].size()));  // const …::Inputs in
    view.set("outputs", "{" + joined(outputs) + "}");
    view["slots"] = std::move(slots);
    view["raw"] = std::move(raw);
    view["published"] = std::move(published);
    view.set("tick", fmt::format("eagerx::Tick{{{}}}", tick_of(n)));
    const std::string lacks = graph_.asynchronous ? lacks_messages(plan_, names_, n) : "";
    view.set("lacks", lacks);
    view.set("can_drop", !lacks.empty());
    view.set("simulator_argument", simulator_argument(plan_, names_, n));
    add_feedthroughs(view, n);
  }

  /// What a reset node passes on while there is no reset.
  void add_feedthroughs(View& view, std::size_t n) const {
    const GraphNode& node = graph_.nodes[n];
    std::vector<std::string> windows;
    View passed = list();
    for (std::size_t i = 0; i < node.inputs.size(); ++i) {
      if (!node.inputs[i].feedthrough) continue;
      windows.push_back(window_argument(plan_, names_, n, i));
      View item = object();
      item.set("field", node.inputs[i].name);
      passed.push_back(item);
    }
    view.set("is_reset_node", node.is_reset_node());
    view.set("is_plain_node", !node.is_reset_node());
    view.set("feedthroughs",
             braced(windows, 10, 40 + names_.io[n].size()));  // const …::Feedthroughs through
    view["passed"] = std::move(passed);
    view.set("targets", names_.targets_member[n]);
    view.set("done", names_.done_member[n]);
  }

  void add_observation(View& view) const {
    std::vector<std::string> windows;
    const bool observes = names_.receives(Graph::kEnvironment);
    for (std::size_t i = 0; observes && i < graph_.environment().inputs.size(); ++i)
      windows.push_back(window_argument(plan_, names_, Graph::kEnvironment, i));
    view.set("observation", braced(windows, 4, 33));  // const Observation observation
  }

  void add_memory(View& view) const {
    View rings = list(), members = list(), counters = list();
    for (std::size_t r = 0; r < plan_.rings.size(); ++r) {
      const Ring& ring = plan_.rings[r];
      if (!names_.has_ring(r)) continue;
      View item = object();
      item.set("type", message_type(ring.space));
      item.set("member", names_.ring_member[r]);
      item.set("capacity", fmt::format("{}", ring.capacity));
      item.set("comment",
               ring.needed > 1 ? fmt::format("  // {} needs {}", ring.why, ring.needed) : "");
      rings.push_back(item);
    }
    const auto add = [&](const std::string& type, const std::string& member) {
      View item = object();
      item.set("type", type);
      item.set("member", member);
      members.push_back(item);
    };
    for (std::size_t i = 0; names_.has_engine() && i < graph_.objects.size(); ++i)
      add(names_.simulator_type[i], names_.simulator_member[i]);
    for (const std::size_t n : nodes_in_order(plan_)) {
      if (!names_.runs(n)) continue;
      const Entity& entity = *graph_.nodes[n].entity;
      add(fmt::format("{}<{}>", entity.cpp.name, names_.io[n]), names_.node_member[n]);
      if (entity.counts.empty()) continue;
      View item = object();
      item.set("node", graph_.nodes[n].name);
      item.set("member", names_.node_member[n]);
      counters.push_back(item);
    }
    view.set("has_counts", names_.has_engine() || counters.is_non_empty_list());
    view["node_counts"] = std::move(counters);
    view["rings"] = std::move(rings);
    view["members"] = std::move(members);
  }

  const Plan& plan_;
  const Graph& graph_;
  const ProgramNames& names_;
};

}  // namespace

View program_view(const Plan& plan, const ProgramNames& names) {
  View view = ProgramView(plan, names).make();
  add_reset(plan, names, view);
  return view;
}

}  // namespace eagerx::gen

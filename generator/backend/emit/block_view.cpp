#include "generator/backend/emit/block_view.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/backend/emit/arrival_view.hpp"
#include "generator/backend/emit/link_view.hpp"
#include "generator/backend/emit/reset_view.hpp"
#include "generator/backend/emit/types.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {
namespace {

/// The actions of one node in a slot.
class BlockView {
 public:
  BlockView(const Plan& plan, const ProgramNames& names, std::size_t n)
      : plan_(plan),
        graph_(*plan.graph),
        node_(graph_.nodes[n]),
        names_(names),
        n_(n),
        seq_(!names.nodes[n].sent.empty() ? names.nodes[n].sent + ".count()"
             : names.lag(n) > 0           ? "sent"
                                          : "n") {}

  View make() {
    const bool is_engine = node_.role == NodeRole::engine;
    view_.set("begin_mark", begin_mark(node_.name));
    view_.set("end_mark", end_mark());
    view_.set("is_engine", is_engine);
    view_.set("tick", tick());
    view_.set("is_remote", !names_.runs(n_));
    view_.set("is_drawn", node_.drawn);
    view_.set("hooks_argument", is_render(n_) ? ", hooks" : "");
    view_.set("node", node_.name);
    view_.set("alike", "");
    view_.set("label", names_.nodes[n_].label);
    view_.set("entity", node_.entity->id.value);
    view_.set("member", names_.nodes[n_].member.expression());
    view_.set("seq", seq_);
    view_.set("sent", names_.nodes[n_].sent);
    view_.set("io", names_.nodes[n_].io);
    view_.set("only_in_episodes", node_.waits_during_reset && graph_.has_reset_nodes());
    add_reached();
    if (is_engine) {
      add_engine();
    } else if (names_.runs(n_)) {
      add_node();
    } else {
      add_remote();
    }
    add_waiting();
    return std::move(view_);
  }
  /// The same of what it sends elsewhere, where that is taken.
  View make_take() {
    view_.set("node", node_.name);
    add_remote();
    add_waiting();
    return std::move(view_);
  }

 private:
  std::string tick() const {
    return names_.is_vectorized() ? "eagerx::LaneTick<kLanes>(n)" : "eagerx::Tick{n}";
  }
  std::string channel(std::size_t output) const {
    const std::string& name = names_.nodes[n_].outputs[output].channel;
    return name.ends_with("[i]") ? name : "channel::" + name;
  }
  MessagePlace place(std::size_t output) const {
    return message_place(plan_, names_, plan_.nodes[n_].rings[output], seq_);
  }

  /// All programs know which targets a reset node has reached.
  void add_reached() {
    View reached = list();
    const LinkUse use = link_use_of_flags(graph_, names_.program(), n_);
    for (const auto& target : node_.reset_targets) {
      View item = object();
      item.set("flag", names_.nodes[n_].done_member + "." + target.name);
      add_links(names_, use, "", item);
      reached.push_back(std::move(item));
    }
    view_["reached"] = std::move(reached);
  }

  /// Where messages are asked for before they are needed.
  void add_waiting() {
    view_.set("is_pipelined", names_.is_pipelined(n_));
    const bool reads = names_.runs(n_) && node_.role != NodeRole::engine;
    view_.set("waits", reads && ranges::any_of(node_.inputs, [&](const Input& input) {
                         return names_.is_pipelined(input.source_node);
                       }));
    if (!names_.is_pipelined(n_)) return;
    const std::string& member = names_.nodes[n_].member.expression();
    view_.set("take", "take_" + member.substr(0, member.size() - 1));
    view_.set("taken", fmt::format("taken_[{}]", names_.place_in_taken(n_)));
    view_.set("part", names_.link_argument(graph_.placement->part_of[n_]));
    View awaited = list();
    for (std::size_t o = 0; o < node_.outputs.size(); ++o) {
      if (!names_.crosses(n_, o)) continue;
      View item = object();
      item.set("type", names_.message(node_.outputs[o].space));
      item.set("channel", channel(o));
      awaited.push_back(std::move(item));
    }
    view_["awaited"] = std::move(awaited);
    add_handing_on();
  }
  /// Messages that another part reads.
  void add_handing_on() {
    View hands_on = list();
    for (std::size_t o = 0; o < node_.outputs.size(); ++o) {
      for (const std::size_t part : names_.links(n_, o).to) {
        View item = object();
        item.set("to", names_.link_argument(part));
        item.set("lag", fmt::format("{}", plan_.split->links[part].lags[n_]));
        item.set("sent", names_.rings[plan_.nodes[n_].rings[o]].expression());
        hands_on.push_back(std::move(item));
      }
    }
    view_["hands_on"] = std::move(hands_on);
  }

  bool is_render(std::size_t n) const { return graph_.render && graph_.render->node == n; }

  View message(std::size_t output, const MessagePlace& place) const {
    View view = object();
    view.set("ring", place.expression);
    view.set("channel", channel(output));
    view["conversions"] = conversions_view(
        plan_, names_, {plan_.nodes[n_].rings[output], seq_, place.expression, raw_name(output)});
    return view;
  }

  /// The variable into which the callback writes an output that has a processor.
  std::string raw_name(std::size_t output) const { return "raw_" + node_.outputs[output].name; }

  /// Messages that come over a link from a node that runs elsewhere.
  void add_remote() {
    View received = list();
    std::vector<MessagePlace> places;
    for (std::size_t o = 0; o < node_.outputs.size(); ++o) {
      if (!names_.crosses(n_, o)) continue;
      places.push_back(place(o));
      View item = message(o, places.back());
      add_links(names_, names_.links(n_, o), channel(o), item);
      received.push_back(std::move(item));
    }
    view_["slots"] = slots_view(places);
    view_["received"] = std::move(received);
    add_lag(names_, n_, view_);
  }

  void add_engine() {
    std::vector<std::string> simulators = {tick()};
    for (const EmitObject& object : names_.objects) simulators.push_back(object.simulator_member);
    view_.set("simulators", joined(simulators));
    View simulated = list();
    for (std::size_t i = 0; i < graph_.objects.size(); ++i) {
      View item = object();
      item.set("object", cpp_string(graph_.objects[i].name));
      item.set("simulator", names_.objects[i].simulator_member);
      simulated.push_back(std::move(item));
    }
    view_.set("has_simulated", simulated.is_non_empty_list());
    view_["simulated"] = std::move(simulated);
    view_.set("tick_message", names_.is_vectorized()
                                  ? fmt::format("eagerx::lane_ticks({})", seq_)
                                  : fmt::format("static_cast<std::int64_t>({})", seq_));
    view_["slots"] = slots_view({place(0)});
    view_.set("ring", place(0).expression);
    view_.set("channel", channel(0));
  }

  void add_node() {
    View raw = list(), published = list();
    std::vector<MessagePlace> places;
    std::vector<FieldValue> outputs;
    for (std::size_t o = 0; o < node_.outputs.size(); ++o) {
      const Output& output = node_.outputs[o];
      const std::string local = raw_name(o);
      places.push_back(place(o));
      View item = message(o, places.back());
      add_links(names_, names_.links(n_, o), channel(o), item);
      item.set("processor", text_or_false(names_.nodes[n_].outputs[o].processor));
      item.set("local", local);
      published.push_back(std::move(item));
      outputs.push_back({output.name, output.processor ? local : places.back().expression});
      if (!output.processor) continue;
      View variable = object();
      variable.set("type", names_.message(output.raw));
      variable.set("local", local);
      raw.push_back(std::move(variable));
    }
    view_.set("outputs", designated(outputs));
    view_["slots"] = slots_view(places);
    view_["raw"] = std::move(raw);
    view_["published"] = std::move(published);
    view_.set("lacks", text_or_false(graph_.asynchronous ? lacks_messages(plan_, names_, n_) : ""));
    view_.set("simulator_argument", simulator_argument(plan_, names_, n_));
    add_inputs();
    view_.set("by_lane", names_.by_lane(n_));
    if (names_.by_lane(n_)) add_lanes();
  }

  /// Inputs and outputs in one lane of a node for plain numbers.
  void add_lanes() {
    View reads = list(), writes = list();
    std::vector<FieldValue> read, written;
    for (const auto& input : node_.inputs) {
      View item = object();
      item.set("field", input.name);
      reads.push_back(std::move(item));
      read.push_back({input.name, "in_" + input.name});
    }
    for (const auto& output : node_.outputs) {
      View item = object();
      item.set("field", output.name);
      item.set("type", message_type(output.raw, Numbers::plain));
      item.set("lanes_type", names_.message(output.raw));
      writes.push_back(std::move(item));
      written.push_back({output.name, fmt::format("out_{}.one", output.name)});
    }
    view_.set("one", names_.one(n_));
    view_["reads"] = std::move(reads);
    view_["writes"] = std::move(writes);
    view_.set("read", designated(read));
    view_.set("written", designated(written));
  }

  /// Inputs of its callback, and those that a reset node passes on while there is no reset.
  void add_inputs() {
    std::vector<FieldValue> inputs, feedthroughs;
    View passed = list();
    for (std::size_t i = 0; i < node_.inputs.size(); ++i) {
      const bool passes = node_.inputs[i].feedthrough;
      (passes ? feedthroughs : inputs)
          .push_back({node_.inputs[i].name, window_argument(plan_, names_, n_, i)});
      View item = object();
      item.set("field", node_.inputs[i].name);
      if (passes) passed.push_back(std::move(item));
    }
    view_.set("inputs", designated(inputs));
    view_.set("is_reset_node", !node_.reset_targets.empty());
    view_.set("feedthroughs", designated(feedthroughs));
    view_["passed"] = std::move(passed);
    view_.set("targets", names_.nodes[n_].targets_member);
    view_.set("done", names_.nodes[n_].done_member);
  }

  const Plan& plan_;
  const Graph& graph_;
  const GraphNode& node_;
  const ProgramNames& names_;
  std::size_t n_;
  std::string seq_;  // of what the node sends next, in a group
  View view_ = object();
};

bool receives_messages(const ProgramNames& names, const GraphNode& node, std::size_t n) {
  for (std::size_t o = 0; o < node.outputs.size(); ++o) {
    if (names.crosses(n, o)) return true;
  }
  return false;
}

/// The loop whose nodes begin here, all of them.
const ProgramNames::Loop* loop_at(const ProgramNames& names, const std::vector<std::size_t>& nodes,
                                  std::size_t at) {
  for (const auto& loop : names.loops) {
    const auto& own = loop.repeat.nodes;
    if (own.front() == nodes[at] && own.size() <= nodes.size() - at &&
        std::equal(own.begin(), own.end(), nodes.begin() + static_cast<std::ptrdiff_t>(at)))
      return &loop;
  }
  return nullptr;
}

View loop_view(const Plan& plan, const ProgramNames& names, const ProgramNames::Loop& loop) {
  const ProgramNames inside = names.inside(loop);
  View body = list();
  for (std::size_t m = 0; m < loop.repeat.length(); ++m) {
    View node = BlockView(plan, inside, loop.repeat.nodes[m]).make();
    node.set("alike", fmt::format(" and {} more", loop.repeat.count - 1));
    body.push_back(std::move(node));
  }
  View view = object();
  view.set("count", fmt::format("{}", loop.repeat.count));
  view["nodes"] = std::move(body);
  View block = object();
  block["loop"] = std::move(view);
  block["nodes"] = list();
  return block;
}

}  // namespace

View groups_view(const Plan& plan, const ProgramNames& names,
                 const std::vector<std::size_t>& nodes) {
  View groups = list();
  for (std::size_t i = 0; i < nodes.size();) {
    const std::size_t rate = plan.nodes[nodes[i]].rate;
    View blocks = list();
    bool knows_tick = false;
    for (; i < nodes.size() && plan.nodes[nodes[i]].rate == rate; ++i) {
      if (const ProgramNames::Loop* loop = loop_at(names, nodes, i)) {
        blocks.push_back(loop_view(plan, names, *loop));
        knows_tick = true;
        i += loop->repeat.nodes.size() - 1;
        continue;
      }
      const GraphNode& node = plan.graph->nodes[nodes[i]];
      const bool acts = names.runs(nodes[i]) || receives_messages(names, node, nodes[i]);
      // Of a reset node that runs in the other program, both know when it has done its work.
      if (!acts && node.reset_targets.empty()) continue;
      knows_tick = knows_tick || acts;
      View block = object();
      block.set("loop", false);
      View one = list();
      one.push_back(BlockView(plan, names, nodes[i]).make());
      block["nodes"] = std::move(one);
      blocks.push_back(std::move(block));
    }
    if (!blocks.is_non_empty_list()) continue;
    View group = object();
    group.set("due", names.rates[rate].due);
    group.set("counter", names.rates[rate].counter);
    group.set("knows_tick", knows_tick);
    group["blocks"] = std::move(blocks);
    groups.push_back(std::move(group));
  }
  return groups;
}

View takes_view(const Plan& plan, const ProgramNames& names) {
  View takes = list();
  for (std::size_t n = 0; n < plan.graph->nodes.size(); ++n)
    if (names.is_pipelined(n)) takes.push_back(BlockView(plan, names, n).make_take());
  return takes;
}

void add_lag(const ProgramNames& names, std::size_t node, View& view) {
  const std::uint64_t lag = names.lag(node);
  view.set("lag", text_or_false(lag > 0 ? fmt::format("{}", lag) : ""));
}

View ask_view(const Plan& plan, const ProgramNames& names, std::size_t node) {
  return names.is_pipelined(node) ? BlockView(plan, names, node).make_take() : View(false);
}

MessagePlace message_place(const Plan& plan, const ProgramNames& names, std::size_t ring,
                           const std::string& seq) {
  const std::string place = ring_place(plan, names, ring, seq);
  if (plan.rings[ring].capacity == 1) return {place, {}, {}};
  const Ring& what = plan.rings[ring];
  const std::string local = "new_" + plan.graph->nodes[what.node].outputs[what.output].name;
  return {local, local, place};
}

View slots_view(const std::vector<MessagePlace>& places) {
  View slots = list();
  for (const auto& place : places) {
    if (place.local.empty()) continue;
    View slot = object();
    slot.set("slot", place.local);
    slot.set("ring", place.ring);
    slots.push_back(std::move(slot));
  }
  return slots;
}

bool is_kept_within(const Plan& plan, const Ring& ring) {
  if (ring.node != Graph::kEnvironment || !ring.reader_node) return false;
  const Input& input = plan.graph->nodes[*ring.reader_node].inputs[*ring.reader_input];
  return input.actuator && (!input.space.low.empty() || !input.space.high.empty());
}

View conversions_view(const Plan& plan, const ProgramNames& names, const WrittenMessage& message) {
  View views = list();
  const Ring& written = plan.rings[message.ring];
  for (const std::size_t r : names.nodes[written.node].reader_rings) {
    const Ring& ring = plan.rings[r];
    if (ring.output != written.output || !names.has_ring(r)) continue;
    View view = object();
    view.set("target", ring_place(plan, names, r, message.seq));
    view.set("channel_index", fmt::format("{}", ring.output));
    const Input& input = plan.graph->nodes[*ring.reader_node].inputs[*ring.reader_input];
    const std::string& source = input.original ? message.raw : message.value;
    view.set("converted",
             input.processor
                 ? fmt::format("{}::convert({})",
                               names.nodes[*ring.reader_node].inputs[*ring.reader_input].processor,
                               source)
                 : source);
    view.set("bounds", names.runs(Graph::kEnvironment) ? "guard" : "actuators");
    view.set("space", text_or_false(is_kept_within(plan, ring) && !names.has_derivatives()
                                        ? "eagerx::Space<" + names.message(input.space) + ">" +
                                              space_literal(input.space)
                                        : ""));
    views.push_back(std::move(view));
  }
  return views;
}

}  // namespace eagerx::gen

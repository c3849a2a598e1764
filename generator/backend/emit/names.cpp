#include "generator/backend/emit/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "generator/support/diagnostics/join.hpp"
#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {
namespace {

/// What only pictures need is in a member of its own.
std::string within_drawing(const std::string& member) {
  return "drawing_." + member;
}

/// What names have in common, in words: "servo" of "left_servo" and "right_servo". The first name
/// if that is nothing.
std::string in_common(const std::vector<std::string>& names) {
  const auto words_of = [](const std::string& name) {
    std::vector<std::string> words(1);
    for (const char c : name) {
      if (c == '_' || c == '/') {
        words.emplace_back();
      } else {
        words.back() += c;
      }
    }
    std::erase(words, "");
    return words;
  };
  std::vector<std::string> head = words_of(names.front()), tail = head;
  for (const auto& name : names) {
    const std::vector<std::string> words = words_of(name);
    std::size_t same = 0;
    while (same < std::min(head.size(), words.size()) && head[same] == words[same]) ++same;
    head.resize(same);
    same = 0;
    while (same < std::min(tail.size(), words.size()) &&
           tail[tail.size() - 1 - same] == words[words.size() - 1 - same])
      ++same;
    tail.erase(tail.begin(), tail.end() - static_cast<std::ptrdiff_t>(same));
  }
  head.insert(head.end(), tail.begin(), tail.end());
  const std::string common = fmt::format("{}", join(head, "_"));
  // A name begins with a letter.
  const bool is_name = !common.empty() && (common.front() < '0' || common.front() > '9');
  return is_name ? common : fmt::format("{}", join(words_of(names.front()), "_"));
}

/// The name of a machine or a target as one of C++: "camera_pc_local".
std::string plain(std::string name) {
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

}  // namespace

bool is_drawn(const Plan& plan, const Ring& ring) {
  return plan.graph->nodes[ring.node].drawn;
}

ProgramNames::ProgramNames(const Plan& plan, Part part, Numbers of, bool with_loops)
    : numbers(of), io_owner(io_owners(plan, part)), plan_(plan), part_(part) {
  const Graph& graph = *plan.graph;
  Names members, types, fields;
  // Each of these has a struct of its own that says what it is compiled for.
  const auto type = [&](const std::string& wanted) { return types.unique_with(wanted, "Io"); };
  const auto processor_type = [&](const std::optional<Processor>& processor,
                                  const std::string& wanted) -> std::string {
    if (!processor) return "";
    std::string whole = type(wanted);
    for (std::size_t i = 0; !processor->before.empty() && i <= processor->before.size(); ++i)
      processor_stages[whole].push_back(type(fmt::format("{}{}", wanted, i + 1)));
    return whole;
  };
  for (const auto& rate : plan.rates) {
    due.push_back("k" + rate_suffix(rate.rate_hz));
    counter.push_back(members.unique("n" + rate_suffix(rate.rate_hz) + "_"));
  }
  if (graph.placement) {
    Names parts;
    for (const PlacedPart& placed : graph.placement->parts)
      part_constant.push_back(parts.unique("k" + camel(plain(placed.name))));
  }
  for (const char* taken : {"link_", "slot_", "due_", "countdown_", "warm_", "started_",
                            "resetting_", "reset_timeouts_", "refused_delays_", "memory_faults_",
                            "arrivals_", "drawing_", "ahead_", "taken_"})
    members.unique(taken);
  for (const auto& node : graph.nodes) {
    io.push_back(types.unique(camel(node.name) + "Io"));
    node_member.push_back(members.unique(snake(node.name) + "_"));
    if (node.drawn) node_member.back() = within_drawing(node_member.back());
    const std::string owner = node.role == NodeRole::environment ? "action" : snake(node.name);
    sent.push_back(graph.asynchronous ? members.unique(owner + "_sent_") : "");
  }
  for (std::size_t n = 0; n < io.size(); ++n) io[n] = io[io_owner[n]];
  for (const auto& ring : plan.rings) {
    const GraphNode& node = graph.nodes[ring.node];
    const bool action = node.role == NodeRole::environment;
    std::string name =
        (action ? "action" : snake(node.name)) + "_" + node.outputs[ring.output].name;
    if (ring.reader_node) {
      const GraphNode& reader = graph.nodes[*ring.reader_node];
      const bool observation = reader.role == NodeRole::environment;
      name = (observation ? "observation" : snake(reader.name)) + "_" +
             reader.inputs[*ring.reader_input].name +
             (reader.inputs[*ring.reader_input].feedthrough ? "_feedthrough" : "");
    }
    ring_member.push_back(members.unique(name + "_"));
    if (node.drawn) ring_member.back() = within_drawing(ring_member.back());
  }
  if (has_packs()) {
    const std::vector<bool> passing = passing_rings(plan);
    for (std::size_t r = 0; r < passing.size(); ++r) {
      if (passing[r]) ring_member[r] = kPassing + ring_member[r];
    }
  }
  for (const auto& object : graph.objects) {
    simulator_type.push_back(type(camel(object.name) + "Simulator"));
    simulator_member.push_back(members.unique(snake(object.name) + "_simulator_"));
    engine_state_type.emplace_back();
    object_state.emplace_back();
    object_state_processor.emplace_back();
    for (const auto& state : object.states) {
      // A sensor may have the state's name: then its engine node has this Io.
      const std::string name = camel(object.name) + camel(state.name);
      engine_state_type.back().push_back(type(types.has(name + "Io") ? name + "State" : name));
      object_state.back().push_back(fields.unique(snake(object.name) + "_" + state.name));
      object_state_processor.back().push_back(
          processor_type(state.processor, camel(object.name) + camel(state.name) + "Processor"));
    }
  }
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    const GraphNode& node = graph.nodes[n];
    const std::string owner = node.role == NodeRole::environment ? "observation" : snake(node.name);
    for (auto* list : {&output_processor, &input_processor, &cursor, &fresh, &node_state,
                       &node_state_processor, &target_processor, &delay_member, &delay_state})
      list->emplace_back();
    channel.emplace_back(node.outputs.size());
    for (const auto& output : node.outputs) {
      output_processor[n].push_back(
          processor_type(output.processor, camel(node.name) + camel(output.name) + "Processor"));
    }
    for (std::size_t i = 0; i < node.inputs.size(); ++i) {
      const Input& input = node.inputs[i];
      const std::string port = owner + "_" + input.name + (input.feedthrough ? "_feedthrough" : "");
      input_processor[n].push_back(processor_type(input.processor, camel(port) + "Processor"));
      const auto count = plan.nodes[n].receptions[i].count;
      const bool counted = count == Reception::Count::delayed ||
                           count == Reception::Count::skipped || count == Reception::Count::arrived;
      cursor[n].push_back(counted ? members.unique(port + "_cursor_") : "");
      fresh[n].push_back(input.window == 0 && !graph.asynchronous ? members.unique(port + "_new_")
                                                                  : "");
      delay_member[n].push_back(
          input.max_delay_s || input.entity_sets_delay ? members.unique(port + "_delay_s_") : "");
      const bool settable = input.max_delay_s && (input.random_delay || !input.entity_sets_delay);
      delay_state[n].push_back(settable ? fields.unique(port + "_delay_s") : "");
    }
    for (const auto& target : node.reset_targets) {
      target_processor[n].push_back(
          processor_type(target.processor, camel(owner) + camel(target.name) + "TargetProcessor"));
    }
    const bool resets = node.is_reset_node();
    targets_member.push_back(resets ? members.unique(owner + "_targets_") : "");
    done_member.push_back(resets ? members.unique(owner + "_done_") : "");
    for (const auto& state : node.states) {
      node_state[n].push_back(fields.unique(snake(node.name) + "_" + state.name));
      node_state_processor[n].push_back(
          processor_type(state.processor, camel(node.name) + camel(state.name) + "Processor"));
    }
  }
  Names channels;
  for (const auto& item : plan.channels)
    channel[item.node][item.output] = channels.unique(snake(item.name));
  for (const auto& node : graph.nodes) label.push_back(cpp_string(node.name));
  if (!with_loops || of != Numbers::plain) return;
  const auto common = [](const std::vector<std::string>& names) { return in_common(names) + "_"; };
  const auto make_array = [&](std::vector<std::string*> names) {
    std::vector<std::string> texts;
    texts.reserve(names.size());
    for (const auto* name : names) texts.push_back(*name);
    const std::string array = members.unique(common(texts));
    size_of_array[array] = names.size();
    for (std::size_t i = 0; i < names.size(); ++i) *names[i] = fmt::format("{}[{}]", array, i);
  };
  const Repeats repeats = find_repeats(plan, part, io_owner);
  for (const auto& array : repeats.arrays) {
    std::vector<std::string*> names;
    names.reserve(array.size());
    for (const std::size_t ring : array) names.push_back(&ring_member[ring]);
    make_array(names);
  }
  Names tables;
  for (const Repeat& repeat : repeats.all) {
    Loop& loop = loops.emplace_back();
    loop.repeat = repeat;
    const std::size_t length = repeat.length();
    for (std::size_t m = 0; m < length; ++m) {
      std::vector<std::string*> names;
      std::vector<std::string> nodes;
      for (std::size_t j = 0; j < repeat.count; ++j) {
        names.push_back(&node_member[repeat.nodes[j * length + m]]);
        nodes.push_back(graph.nodes[repeat.nodes[j * length + m]].name);
      }
      make_array(names);
      const std::string chain = camel(in_common(nodes));
      loop.labels.push_back(tables.unique("kNamesOf" + chain));
      auto& of_outputs = loop.channels.emplace_back();
      const std::size_t outputs = graph.nodes[repeat.nodes[m]].outputs.size();
      for (std::size_t o = 0; o < outputs; ++o) {
        std::vector<std::string> constants;
        for (std::size_t j = 0; j < repeat.count; ++j)
          constants.push_back("channel::" + channel[repeat.nodes[j * length + m]][o]);
        const std::string& output = graph.nodes[repeat.nodes[m]].outputs[o].name;
        const std::string table = tables.unique("kChannelOf" + chain + camel(output));
        of_outputs.push_back(table + "[i]");
        loop.tables.emplace_back(table, std::move(constants));
      }
    }
  }
}

ProgramNames ProgramNames::inside(const Loop& loop) const {
  ProgramNames names = *this;
  const auto element = [](std::string& member) {
    if (member.ends_with("[0]")) member.replace(member.size() - 3, 3, "[i]");
  };
  const std::size_t length = loop.repeat.length();
  for (std::size_t m = 0; m < length; ++m) {
    const std::size_t n = loop.repeat.nodes[m];
    element(names.node_member[n]);
    names.label[n] = loop.labels[m] + "[i]";
    for (std::size_t o = 0; o < names.channel[n].size(); ++o)
      names.channel[n][o] = loop.channels[m][o];
    // What all chains read is one ring, which may be the first of another loop's array.
    for (const std::size_t ring : plan_.nodes[n].rings) element(names.ring_member[ring]);
    for (std::size_t i = 0; i < plan_.nodes[n].receptions.size(); ++i) {
      const std::size_t ring = plan_.nodes[n].receptions[i].ring;
      const std::size_t other = loop.repeat.nodes[length + m];
      if (plan_.nodes[other].receptions[i].ring != ring) element(names.ring_member[ring]);
    }
  }
  return names;
}

std::string ProgramNames::declared(const std::string& member) const {
  const std::string array = array_of(member);
  if (array == member) return member;
  return member.ends_with("[0]") ? fmt::format("{}[{}]", array, size_of_array.at(array)) : "";
}

LinkUse ProgramNames::links(std::size_t node, std::size_t output) const {
  return link_use(plan_, part_, node, output);
}
bool ProgramNames::crosses(std::size_t node, std::size_t output) const {
  return links(node, output).any();
}
std::string ProgramNames::link_argument(std::size_t part) const {
  return is_hub() ? "part::" + part_constant[part] + ", " : "";
}

bool ProgramNames::posts(std::size_t node) const {
  return gen::posts(plan_, part_, node);
}
bool ProgramNames::posts() const {
  return place_in_taken(plan_.graph->nodes.size()) > 0;
}
std::size_t ProgramNames::place_in_taken(std::size_t node) const {
  std::size_t place = 0;
  for (std::size_t n = 0; n < node; ++n) place += posts(n) ? 1 : 0;
  return place;
}
std::string ProgramNames::awaited(std::size_t node, const std::string& count) const {
  if (!posts(node)) return count;
  return fmt::format("ahead_.need(*this, {}taken_[{}], {})",
                     link_argument(plan_.graph->placement->part_of[node]), place_in_taken(node),
                     count);
}

bool ProgramNames::has_ring(std::size_t ring) const {
  const Ring& item = plan_.rings[ring];
  if (item.reader_node) return receives(*item.reader_node);
  if (left_out(item.node)) return false;
  return !part_.is_placed() || runs(item.node) || crosses(item.node, item.output);
}

bool ProgramNames::has_io(std::size_t node) const {
  if (!gen::has_io(*plan_.graph, part_, node)) return false;
  for (std::size_t n = 0; n < io_owner.size(); ++n) {
    if (io_owner[n] == node && !left_out(n)) return true;
  }
  return false;
}

View space_view(const std::string& field, const Space& space, const std::string& prefix,
                Names& constants) {
  View item = object();
  item.set("field", field);
  item.set("type", message_type(space));
  item.set("constant", constants.unique("k" + prefix + camel(field)));
  item.set("literal", space_literal(space));
  return item;
}

}  // namespace eagerx::gen

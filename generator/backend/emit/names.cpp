#include "generator/backend/emit/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "generator/support/diagnostics/join.hpp"
#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {
namespace {

/// The words that names have in common: "servo" of "left_servo" and "right_servo". The first name
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

/// The prefix of names that belong to a node's ports.
std::string port_owner(const GraphNode& node, const char* of_environment) {
  return node.role == NodeRole::environment ? of_environment : snake(node.name);
}

std::string port_name(const std::string& owner, const Input& input) {
  return owner + "_" + input.name + (input.feedthrough ? "_feedthrough" : "");
}

/// The parameters of each of these types are in a struct whose name ends in Io.
std::string type_name(Names& types, const std::string& wanted) {
  return types.unique_with(wanted, "Io");
}

/// Makes members of equal chains the elements of one array.
void make_array(Names& members, const std::vector<EmitMember*>& elements) {
  std::vector<std::string> names;
  names.reserve(elements.size());
  for (const EmitMember* element : elements) names.push_back(element->name);
  const std::string array = members.unique(in_common(names) + "_");
  for (std::size_t i = 0; i < elements.size(); ++i) {
    elements[i]->name = array;
    elements[i]->element = {i, elements.size()};
  }
}

/// Inside a loop the first element stands for all.
void use_loop_index(EmitMember& member) {
  if (member.element && member.element->index == 0) member.element->is_loops = true;
}

}  // namespace

std::string EmitMember::expression() const {
  const char* const prefix = owner == Owner::drawing    ? "drawing_."
                             : owner == Owner::one_step ? "now."
                                                        : "";
  if (!element) return prefix + name;
  return fmt::format("{}{}[{}]", prefix, name,
                     element->is_loops ? "i" : fmt::format("{}", element->index));
}

std::string EmitMember::declaration() const {
  if (!element) return name;
  return element->index == 0 ? fmt::format("{}[{}]", name, element->count) : "";
}

bool is_drawn(const Plan& plan, const Ring& ring) {
  return plan.graph->nodes[ring.node].drawn;
}

ProgramNames::ProgramNames(const Plan& plan, Part part, Numbers of, bool with_loops)
    : numbers(of), plan_(plan), part_(part) {
  Names members, types, fields;
  name_rates(members);
  name_parts();
  for (const char* taken : {"link_", "slot_", "due_", "countdown_", "warm_", "started_",
                            "resetting_", "reset_timeouts_", "refused_delays_", "memory_faults_",
                            "arrivals_", "drawing_", "pipeline_", "taken_"})
    members.unique(taken);
  name_nodes(members, types);
  name_rings(members);
  name_objects(members, types, fields);
  name_ports(members, types, fields);
  name_channels();
  if (with_loops && of == Numbers::plain) name_loops(members);
}

void ProgramNames::name_rates(Names& members) {
  for (const auto& rate : plan_.rates)
    rates.push_back(
        {"k" + rate_suffix(rate.rate_hz), members.unique("n" + rate_suffix(rate.rate_hz) + "_")});
}

void ProgramNames::name_parts() {
  if (!plan_.graph->placement) return;
  Names constants;
  for (const PlacedPart& placed : plan_.graph->placement->parts)
    parts.push_back(constants.unique("k" + camel(plain(placed.name))));
}

void ProgramNames::name_nodes(Names& members, Names& types) {
  const std::vector<std::size_t> owners = io_owners(plan_, part_);
  for (const auto& node : plan_.graph->nodes) {
    EmitNode& item = nodes.emplace_back();
    item.io = types.unique(camel(node.name) + "Io");
    item.io_owner = owners[nodes.size() - 1];
    item.member.name = members.unique(snake(node.name) + "_");
    if (node.drawn) item.member.owner = EmitMember::Owner::drawing;
    item.label = cpp_string(node.name);
    if (plan_.graph->asynchronous)
      item.sent = members.unique(port_owner(node, "action") + "_sent_");
  }
  for (EmitNode& node : nodes) node.io = nodes[node.io_owner].io;
}

void ProgramNames::name_rings(Names& members) {
  const Graph& graph = *plan_.graph;
  const std::vector<bool> passing =
      is_vectorized() ? passing_rings(plan_) : std::vector<bool>(plan_.rings.size());
  for (std::size_t r = 0; r < plan_.rings.size(); ++r) {
    const Ring& ring = plan_.rings[r];
    const GraphNode& node = graph.nodes[ring.node];
    std::string name = port_owner(node, "action") + "_" + node.outputs[ring.output].name;
    if (ring.reader_node) {
      const GraphNode& reader = graph.nodes[*ring.reader_node];
      name = port_name(port_owner(reader, "observation"), reader.inputs[*ring.reader_input]);
      nodes[ring.node].reader_rings.push_back(r);
    }
    EmitMember& member = rings.emplace_back();
    member.name = members.unique(name + "_");
    if (node.drawn) member.owner = EmitMember::Owner::drawing;
    if (passing[r]) member.owner = EmitMember::Owner::one_step;
  }
}

void ProgramNames::name_objects(Names& members, Names& types, Names& fields) {
  for (const auto& object : plan_.graph->objects) {
    EmitObject& item = objects.emplace_back();
    item.simulator_type = type_name(types, camel(object.name) + "Simulator");
    item.simulator_member = members.unique(snake(object.name) + "_simulator_");
    for (const auto& state : object.states) {
      // A sensor may have the state's name: then its engine node has this Io.
      const std::string name = camel(object.name) + camel(state.name);
      EmitState& of = item.states.emplace_back();
      of.type = type_name(types, types.has(name + "Io") ? name + "State" : name);
      of.field = fields.unique(snake(object.name) + "_" + state.name);
      of.processor = processor_type(state.processor, name + "Processor", types);
    }
  }
}

void ProgramNames::name_ports(Names& members, Names& types, Names& fields) {
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const GraphNode& node = plan_.graph->nodes[n];
    EmitNode& item = nodes[n];
    const std::string owner = port_owner(node, "observation");
    for (const auto& output : node.outputs) {
      const std::string wanted = camel(node.name) + camel(output.name) + "Processor";
      item.outputs.push_back({processor_type(output.processor, wanted, types), "", ""});
    }
    for (const Input& input : node.inputs) {
      const std::string wanted = camel(port_name(owner, input)) + "Processor";
      item.inputs.emplace_back().processor = processor_type(input.processor, wanted, types);
    }
    for (std::size_t i = 0; i < node.inputs.size(); ++i) name_input(n, i, owner, members, fields);
    for (const auto& target : node.reset_targets) {
      const std::string wanted = camel(owner) + camel(target.name) + "TargetProcessor";
      item.target_processors.push_back(processor_type(target.processor, wanted, types));
    }
    if (node.is_reset_node()) {
      item.targets_member = members.unique(owner + "_targets_");
      item.done_member = members.unique(owner + "_done_");
    }
    for (const auto& state : node.states) {
      const std::string wanted = camel(node.name) + camel(state.name) + "Processor";
      EmitState& of = item.states.emplace_back();
      of.field = fields.unique(snake(node.name) + "_" + state.name);
      of.processor = processor_type(state.processor, wanted, types);
    }
  }
}

void ProgramNames::name_input(std::size_t node, std::size_t input, const std::string& owner,
                              Names& members, Names& fields) {
  const Input& port = plan_.graph->nodes[node].inputs[input];
  EmitInput& item = nodes[node].inputs[input];
  const std::string name = port_name(owner, port);
  const auto count = plan_.nodes[node].receptions[input].count;
  const bool counted = count == Reception::Count::delayed || count == Reception::Count::skipped ||
                       count == Reception::Count::arrived;
  if (counted) item.cursor = members.unique(name + "_cursor_");
  if (port.window == 0 && !plan_.graph->asynchronous) item.fresh = members.unique(name + "_new_");
  if (port.max_delay_s || port.entity_sets_delay)
    item.delay_member = members.unique(name + "_delay_s_");
  const bool settable = port.max_delay_s && (port.random_delay || !port.entity_sets_delay);
  if (settable) item.delay_state = fields.unique(name + "_delay_s");
}

std::string ProgramNames::processor_type(const std::optional<Processor>& processor,
                                         const std::string& wanted, Names& types) {
  if (!processor) return "";
  std::string whole = type_name(types, wanted);
  for (std::size_t i = 0; !processor->before.empty() && i <= processor->before.size(); ++i)
    processor_stages[whole].push_back(type_name(types, fmt::format("{}{}", wanted, i + 1)));
  return whole;
}

void ProgramNames::name_channels() {
  Names channels;
  for (const auto& item : plan_.channels) {
    EmitOutput& output = nodes[item.node].outputs[item.output];
    output.channel = channels.unique(snake(item.name));
    output.port = item.port;
  }
}

void ProgramNames::name_loops(Names& members) {
  std::vector<std::size_t> io_owner;
  for (const EmitNode& node : nodes) io_owner.push_back(node.io_owner);
  const Repeats repeats = find_repeats(plan_, part_, io_owner);
  for (const auto& array : repeats.arrays) {
    std::vector<EmitMember*> elements;
    for (const std::size_t ring : array) elements.push_back(&rings[ring]);
    make_array(members, elements);
  }
  Names tables;
  for (const Repeat& repeat : repeats.all) name_loop(repeat, members, tables);
}

void ProgramNames::name_loop(const Repeat& repeat, Names& members, Names& tables) {
  const Graph& graph = *plan_.graph;
  Loop& loop = loops.emplace_back();
  loop.repeat = repeat;
  const std::size_t length = repeat.length();
  for (std::size_t m = 0; m < length; ++m) {
    std::vector<EmitMember*> elements;
    std::vector<std::string> names;
    for (std::size_t j = 0; j < repeat.count; ++j) {
      elements.push_back(&nodes[repeat.nodes[j * length + m]].member);
      names.push_back(graph.nodes[repeat.nodes[j * length + m]].name);
    }
    make_array(members, elements);
    const std::string chain = camel(in_common(names));
    loop.labels.push_back(tables.unique("kNamesOf" + chain));
    auto& of_outputs = loop.channels.emplace_back();
    const auto& outputs = graph.nodes[repeat.nodes[m]].outputs;
    for (std::size_t o = 0; o < outputs.size(); ++o) {
      std::vector<std::string> constants;
      for (std::size_t j = 0; j < repeat.count; ++j)
        constants.push_back("channel::" + nodes[repeat.nodes[j * length + m]].outputs[o].channel);
      const std::string table = tables.unique("kChannelOf" + chain + camel(outputs[o].name));
      of_outputs.push_back(table + "[i]");
      loop.tables.emplace_back(table, std::move(constants));
    }
  }
}

ProgramNames ProgramNames::inside(const Loop& loop) const {
  ProgramNames names = *this;
  const std::size_t length = loop.repeat.length();
  for (std::size_t m = 0; m < length; ++m) {
    const std::size_t n = loop.repeat.nodes[m];
    EmitNode& node = names.nodes[n];
    use_loop_index(node.member);
    node.label = loop.labels[m] + "[i]";
    for (std::size_t o = 0; o < node.outputs.size(); ++o)
      node.outputs[o].channel = loop.channels[m][o];
    // A ring that all chains read may be the first of another loop's array.
    for (const std::size_t ring : plan_.nodes[n].rings) use_loop_index(names.rings[ring]);
    for (std::size_t i = 0; i < plan_.nodes[n].receptions.size(); ++i) {
      const std::size_t ring = plan_.nodes[n].receptions[i].ring;
      const std::size_t other = loop.repeat.nodes[length + m];
      if (plan_.nodes[other].receptions[i].ring != ring) use_loop_index(names.rings[ring]);
    }
  }
  return names;
}

LinkUse ProgramNames::links(std::size_t node, std::size_t output) const {
  return link_use(plan_, part_, node, output);
}
bool ProgramNames::crosses(std::size_t node, std::size_t output) const {
  return links(node, output).any();
}
std::string ProgramNames::link_argument(std::size_t part) const {
  return is_hub() ? "part::" + parts[part] + ", " : "";
}

bool ProgramNames::is_pipelined(std::size_t node) const {
  return gen::is_pipelined(plan_, part_, node);
}
bool ProgramNames::is_pipelined() const {
  return place_in_taken(plan_.graph->nodes.size()) > 0;
}
std::size_t ProgramNames::place_in_taken(std::size_t node) const {
  std::size_t place = 0;
  for (std::size_t n = 0; n < node; ++n) place += is_pipelined(n) ? 1 : 0;
  return place;
}
std::string ProgramNames::awaited(std::size_t node, const std::string& count) const {
  if (!is_pipelined(node)) return count;
  return fmt::format("pipeline_.need(*this, {}taken_[{}], {})",
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
  for (std::size_t n = node; n < nodes.size(); ++n) {  // an Io belongs to the first that has it
    if (nodes[n].io_owner == node && !left_out(n)) return true;
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

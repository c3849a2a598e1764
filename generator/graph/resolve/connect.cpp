#include "generator/graph/resolve/connect.hpp"

#include <fmt/format.h>

#include <map>
#include <set>
#include <utility>

#include "generator/graph/resolve/resets.hpp"
#include "generator/graph/resolve/unknown_owners.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

enum class Side : std::uint8_t { from, to };

/// Without feedthroughs, which share their names with outputs.
std::vector<std::string> names_of_inputs(const UnresolvedNode& node) {
  std::vector<std::string> names;
  for (const auto& input : node.inputs) {
    if (!input.feedthrough) names.push_back(input.name);
  }
  return names;
}

/// The environment or a node of the graph by the name that connections give it.
std::optional<std::size_t> find_node(const UnresolvedGraph& draft, const std::string& name,
                                     Side side) {
  if (name == (side == Side::from ? "actions" : "observations")) return Graph::kEnvironment;
  const auto found = draft.node_of_name.find(name);
  return found == draft.node_of_name.end() ? std::nullopt : std::optional(found->second);
}

/// The ports that a name stands for; several inputs when an actuator feeds several engine nodes.
/// Says nothing when there are none.
std::vector<PortIndex> find_ports(const UnresolvedGraph& draft, const PortName& port, Side side) {
  if (const UnresolvedObject* object = draft.find_object(port.owner)) {
    const char* section = side == Side::from ? "sensors" : "actuators";
    if (!port.section.empty() && port.section != section) return {};
    if (side == Side::from) {
      const auto sensor = object->sensors.find(port.name);
      return sensor == object->sensors.end() ? std::vector<PortIndex>{}
                                             : std::vector<PortIndex>{sensor->second.output};
    }
    const auto actuator = object->actuators.find(port.name);
    return actuator == object->actuators.end() ? std::vector<PortIndex>{} : actuator->second;
  }
  const auto index = find_node(draft, port.owner, side);
  if (!index) return {};
  const UnresolvedNode& node = draft.nodes[*index];
  if (side == Side::from) {
    if (!port.section.empty() && port.section != "outputs") return {};
    const auto found = ranges::find(node.outputs, port.name, &UnresolvedOutput::name);
    if (found == node.outputs.end()) return {};
    return {{*index, static_cast<std::size_t>(found - node.outputs.begin())}};
  }
  const bool feedthrough = port.section == "feedthroughs";
  if (!feedthrough && !port.section.empty() && port.section != "inputs") return {};
  const auto found = ranges::find_if(node.inputs, [&](const UnresolvedInput& i) {
    return i.name == port.name && i.feedthrough == feedthrough;
  });
  if (found == node.inputs.end()) return {};
  return {{*index, static_cast<std::size_t>(found - node.inputs.begin())}};
}

class Connector {
 public:
  explicit Connector(UnresolvedGraph& draft) : draft_(draft), unknown_(draft) {
    // A scan for each broken connection would take a time that grows with the square of the graph.
    for (std::size_t n = 0; n < draft.nodes.size(); ++n) {
      if (const auto object = draft.nodes[n].node.object)
        engine_nodes_of_[draft.objects[*object].name].push_back(n);
    }
    for (const ConnectionSpec& connection : draft.spec.connections)
      sender_of_.try_emplace(connection.to.value, connection.from.value);
  }

  void run() {
    for (const auto& connection : draft_.spec.connections) {
      if (is_reset_target(connection)) continue;
      const auto sources = find(connection.from, Side::from);
      const auto sinks = find(connection.to, Side::to);
      // A connection with one wrong end says that the other end is not left open.
      if (sinks.empty()) excused_.insert(sources.begin(), sources.end());
      if (sources.empty()) excused_.insert(sinks.begin(), sinks.end());
      for (const auto& sink : sinks) {
        if (!sources.empty()) connect(connection, index_of(sources.front()), index_of(sink));
      }
    }
    unknown_.report();
    report_open_inputs();
    report_open_actions();
  }

 private:
  struct End {
    Side side;
    std::size_t node, port;
    auto operator<=>(const End&) const = default;
  };

  Diagnostics& diagnostics() { return draft_.diagnostics; }
  static PortIndex index_of(const End& end) { return {end.node, end.port}; }

  std::vector<End> find(const Spanned<std::string>& text, Side side) {
    const PortName port = parse_port(text.value);
    std::vector<End> ends;
    for (const auto& index : find_ports(draft_, port, side))
      ends.push_back({side, index.node, index.port});
    if (ends.empty()) excuse(report(port, text, side), side);
    return ends;
  }

  /// Reports a port that does not exist; returns the owner that was meant.
  std::string report(const PortName& port, const Spanned<std::string>& text, Side side) {
    if (draft_.erroneous.contains(port.owner)) return port.owner;
    if (const UnresolvedObject* object = draft_.find_object(port.owner)) {
      report_port_of_object(*object, port, text, side);
      return port.owner;
    }
    if (const auto node = find_node(draft_, port.owner, side)) {
      report_port_of_node(draft_.nodes[*node], port, text, side);
      return port.owner;
    }
    return report_unknown_owner(port, text, side);
  }

  void report_port_of_object(const UnresolvedObject& object, const PortName& port,
                             const Spanned<std::string>& text, Side side) {
    const Entity& entity = *object.entity;
    const Entity* engine = draft_.engine();
    const bool sensor = side == Side::from;
    const bool declared =
        (sensor ? entity.sensor(port.name) : entity.actuator(port.name)) != nullptr;
    if (declared && (port.section.empty() || port.section == (sensor ? "sensors" : "actuators"))) {
      diagnostics()
          .error("E0308", text.span,
                 fmt::format("`{}` has no {} `{}` on `{}`", entity.id.value,
                             sensor ? "sensor" : "actuator", port.name, engine->id.value))
          .help = "choose another engine, or add it to the object's manifest";
      return;
    }
    const auto sensors = names_of(entity.sensors), actuators = names_of(entity.actuators);
    sensor ? report_unknown_port(port, text, side, sensors, "sensor", actuators, "actuator")
           : report_unknown_port(port, text, side, actuators, "actuator", sensors, "sensor");
  }

  void report_port_of_node(const UnresolvedNode& node, const PortName& port,
                           const Spanned<std::string>& text, Side side) {
    if (port.section == "feedthroughs") {
      report_feedthrough(node, port, text);
      return;
    }
    const bool environment = node.node.role == NodeRole::environment;
    auto inputs = names_of_inputs(node);
    const auto outputs = names_of(node.outputs);
    const Entity* entity = node.node.entity;
    const bool sends = side == Side::from;
    // Also one that was left out, as nothing is connected to it.
    if (sends && entity != nullptr && entity->input(port.name) != nullptr)
      inputs.push_back(port.name);
    const bool left_out = entity != nullptr &&
                          (sends ? entity->output(port.name) : entity->input(port.name)) != nullptr;
    if (left_out) {
      const char* section = sends ? "outputs" : "inputs";
      diagnostics()
          .error("E0307", text.span, fmt::format("`{}` is not selected", text.value))
          .help = {
          fmt::format("add it to `{}:` of `{}`, or leave that key out", section, port.owner),
          add_to_list(port.name, section, port.owner)};
      return;
    }
    if (environment) {
      report_unknown_port(port, text, side, sends ? outputs : inputs,
                          sends ? "action" : "observation", {}, "");
      return;
    }
    sends ? report_unknown_port(port, text, side, outputs, "output", inputs, "input")
          : report_unknown_port(port, text, side, inputs, "input", outputs, "output");
  }

  void report_feedthrough(const UnresolvedNode& node, const PortName& port,
                          const Spanned<std::string>& text) {
    std::vector<std::string> known;
    for (const auto& input : node.inputs) {
      if (input.feedthrough) known.push_back(input.name);
    }
    diagnostics()
        .error("E0307", text.span,
               fmt::format("`{}` has no feedthrough `{}`", port.owner, port.name))
        .help =
        suggestion(port.name, known, "only reset nodes have feedthroughs: one for each output");
  }

  /// The probable intent, instead of a receiver of messages: "; what it gets is `smooth.filtered`".
  [[nodiscard]] std::string sender_to(std::string_view port) const {
    const auto found = sender_of_.find(port);
    return found == sender_of_.end() ? "" : fmt::format("; what it gets is `{}`", found->second);
  }

  void report_unknown_port(const PortName& port, const Spanned<std::string>& text, Side side,
                           const std::vector<std::string>& known, std::string_view kind,
                           const std::vector<std::string>& other_side,
                           std::string_view other_kind) {
    const char* verb = side == Side::from ? "sends" : "takes";
    if (contains(other_side, port.name)) {
      const bool sends = side == Side::to;
      diagnostics()
          .error("E0307", text.span,
                 fmt::format("`{}` is {} {}: it {} messages", text.value,
                             other_kind == "sensor" ? "a" : "an", other_kind,
                             sends ? "sends" : "takes"))
          .help = fmt::format("it belongs in `{}:` of a connection{}", sends ? "from" : "to",
                              sends ? "" : sender_to(text.value));
      return;
    }
    const bool environment = other_kind.empty();
    auto& problem =
        environment
            ? diagnostics().error("E0307", text.span,
                                  fmt::format("there is no {} `{}`", kind, port.name))
            : diagnostics().error("E0307", text.span,
                                  fmt::format("`{}` has no {} `{}`", port.owner, kind, port.name));
    const std::string near = nearest(port.name, known);
    problem.help = near.empty()
                       ? suggestion(port.name, known, fmt::format("it {} no messages", verb))
                       : meaning(fmt::format("{}.{}", port.owner, near));
  }

  /// Also what stands at the wrong end. Returns the owner that was meant.
  std::string report_unknown_owner(const PortName& port, const Spanned<std::string>& text,
                                   Side side) {
    if (port.owner == "actions" || port.owner == "observations") {
      diagnostics()
          .error("E0309", text.span, fmt::format("`{}` is not allowed here", text.value))
          .help =
          "actions are sent (`from: actions.…`), observations are received (`to: observations.…`)";
      return side == Side::from ? "actions" : "observations";
    }
    std::vector<std::string> known = {side == Side::from ? "actions" : "observations"};
    // Only for those: a list for each of many would take a time that grows with their square.
    for (std::size_t i = 0; unknown_.helps() && i < draft_.objects.size(); ++i)
      known.push_back(draft_.objects[i].name);
    for (std::size_t i = 0; unknown_.helps() && i < draft_.nodes.size(); ++i) {
      const GraphNode& node = draft_.nodes[i].node;
      if (node.role == NodeRole::node) known.push_back(node.name);
    }
    return unknown_.add(port, text.span, std::move(known));
  }

  /// A connection to `owner` is wrong, so its open ports on that side are not a second mistake.
  void excuse(const std::string& owner, Side side) {
    if (owner.empty()) return;
    if (const auto node = find_node(draft_, owner, side)) excuse_node(*node, side);
    const auto found = engine_nodes_of_.find(owner);
    if (found == engine_nodes_of_.end()) return;
    for (const std::size_t node : found->second) excuse_node(node, side);
  }

  void excuse_node(std::size_t n, Side side) {
    const UnresolvedNode& node = draft_.nodes[n];
    const std::size_t count = side == Side::from ? node.outputs.size() : node.inputs.size();
    for (std::size_t i = 0; i < count; ++i) excused_.insert({side, n, i});
  }

  void connect(const ConnectionSpec& connection, const PortIndex& source, const PortIndex& sink) {
    UnresolvedInput& input = draft_.nodes[sink.node].inputs[sink.port];
    if (input.edge) {
      auto& problem = diagnostics().error(
          "E0311", connection.to.span, fmt::format("`{}` is connected twice", connection.to.value));
      problem.label = "an input takes one connection";
      problem.notes.push_back({"the first connection", input.edge->span, ""});
      excused_.insert({Side::from, source.node, source.port});
      return;
    }
    // A sensor's delay is that of who decides: a reward, or a picture, is about what is.
    if (!draft_.is_added(sink.node))
      input.settings = overlay(input.settings, delay_of_sensor(connection));
    input.settings = overlay(input.settings, input.said);
    if (input.settings.processor && connection.settings.processor) {
      diagnostics()
          .error("E0313", connection.settings.processor->type.span,
                 fmt::format("`{}` already has a processor", connection.to.value))
          .notes.push_back({"the first processor", input.settings.processor->type.span, ""});
    }
    input.settings = overlay(input.settings, connection.settings);
    input.sensor = sensor_of(connection);
    input.edge = UnresolvedEdge{source.node, source.port, connection.from.span};
    input.span = connection.to.span;
    excused_.insert({Side::from, source.node, source.port});
  }

  /// The sensor at the beginning of the connection, if it is one, without a section.
  std::string sensor_of(const ConnectionSpec& connection) const {
    const PortName port = parse_port(connection.from.value);
    const UnresolvedObject* object = draft_.find_object(port.owner);
    return object == nullptr ? std::string() : object->sensors.at(port.name).written;
  }

  /// The delay that the sensor at the beginning of the connection offers, if it is one.
  ConnectionSettings delay_of_sensor(const ConnectionSpec& connection) {
    const PortName port = parse_port(connection.from.value);
    const UnresolvedObject* object = draft_.find_object(port.owner);
    if (object == nullptr) return {};
    const auto found = object->delays.find(port.name);
    return found == object->delays.end() ? ConnectionSettings() : found->second;
  }

  void report_open_inputs() {
    std::set<std::string> reported;  // an actuator may feed several engine nodes
    for (std::size_t n = 0; n < draft_.nodes.size(); ++n) {
      const UnresolvedNode& node = draft_.nodes[n];
      if (draft_.is_doubtful(node)) continue;
      for (std::size_t i = 0; i < node.inputs.size(); ++i) {
        const UnresolvedInput& input = node.inputs[i];
        if (input.edge || excused_.contains({Side::to, n, i}) ||
            !reported.insert(input.written).second)
          continue;
        auto& problem = diagnostics().error("E0310", input.span,
                                            fmt::format("`{}` is not connected", input.written));
        problem.help = missing_connection(fmt::format("{{from: …, to: {}}}", input.written));
        if (node.node.role == NodeRole::engine_node) {
          problem.help += ": a sensor in use depends on it, or it is listed in `actuators:`";
        } else {
          problem.help += n == Graph::kEnvironment ? ", or leave it out of `observations:`"
                          : input.feedthrough      ? ": outside of a reset the node passes this on"
                          : input.optional         ? ", or leave it out with `inputs:`"
                                                   : "";
        }
      }
    }
  }

  void report_open_actions() {
    const auto& actions = draft_.nodes[Graph::kEnvironment].outputs;
    for (std::size_t i = 0; i < actions.size(); ++i) {
      if (excused_.contains({Side::from, Graph::kEnvironment, i})) continue;
      diagnostics()
          .error("E0310", actions[i].span,
                 fmt::format("`actions.{}` is not connected", actions[i].name))
          .help = missing_connection(fmt::format("{{from: actions.{}, to: …}}", actions[i].name));
    }
  }

  UnresolvedGraph& draft_;
  std::set<End> excused_;  // not open: in use, or the subject of another message
  UnknownOwners unknown_;
  std::map<std::string, std::vector<std::size_t>, std::less<>> engine_nodes_of_;  // by object
  std::map<std::string_view, std::string_view> sender_of_;  // by what takes its messages
};

}  // namespace

void connect(UnresolvedGraph& draft) {
  const std::size_t first = draft.spec.has_engine() ? Graph::kEngine + 1 : Graph::kEngine;
  for (std::size_t n = first; n < draft.nodes.size(); ++n)
    draft.node_of_name.try_emplace(draft.nodes[n].node.name, n);
  Connector(draft).run();
}

std::optional<PartialSpace> declared_space(const UnresolvedGraph& draft, const std::string& text) {
  const PortName port = parse_port(text);
  const auto found = find_ports(draft, port, Side::to);
  if (!found.empty()) {
    const UnresolvedInput& input = draft.nodes[found.front().node].inputs[found.front().port];
    return input.outside ? *input.outside : input.declared;
  }
  // An actuator that nothing is connected to.
  const EntitySpec* spec = find_named(draft.spec.objects, port.owner);
  const UnresolvedObject* object = draft.find_object(port.owner);
  const PortManifest* actuator = object != nullptr && object->entity != nullptr
                                     ? object->entity->actuator(port.name)
                                     : nullptr;
  if (actuator == nullptr || spec == nullptr) return std::nullopt;
  return partial_space(actuator->space, references_of(*object->entity, spec->config),
                       draft.diagnostics);
}

std::vector<std::string> input_names(const UnresolvedGraph& draft) {
  std::vector<std::string> result;
  for (const auto& object : draft.objects) {
    if (object.entity == nullptr) continue;
    for (const auto& actuator : object.entity->actuators)
      result.push_back(object.name + "." + actuator.name.value);
  }
  for (const auto& node : draft.nodes) {
    if (node.node.role != NodeRole::node) continue;
    for (const auto& input : node.inputs) result.push_back(input.written);
  }
  return result;
}

}  // namespace eagerx::gen

// The user's connections: names to ports, each input once, nothing left open.
#include <fmt/format.h>

#include <algorithm>

#include "generator/resolve/draft.hpp"

namespace eagerx::gen {
namespace {

struct Port {
  std::string owner, section, name;  // section: "", "sensors", "inputs", …
};

Port split(const std::string& text) {
  const std::size_t first = text.find('.');
  const std::size_t second = text.find('.', first + 1);
  if (second == std::string::npos) return {text.substr(0, first), "", text.substr(first + 1)};
  return {text.substr(0, first), text.substr(first + 1, second - first - 1), text.substr(second + 1)};
}

class Connector {
 public:
  explicit Connector(Draft& draft) : draft_(draft) {}

  void run() {
    for (const auto& connection : draft_.spec.connections) {
      const auto source = find_source(connection.from);
      const std::vector<PortIndex> targets = find_targets(connection.to);
      if (!source) continue;
      for (const auto& target : targets) connect(connection, *source, target);
    }
    report_open_ports();
  }

  /// The inputs that `port` stands for; several when an actuator feeds several engine nodes.
  std::vector<PortIndex> find_targets(const Spanned<std::string>& text) {
    const Port port = split(text.value);
    if (port.owner == "observations") return as_list(port_of_node(Graph::kEnvironment, port, text, Side::to));
    if (const DraftObject* object = find_object(port.owner)) return actuator(*object, port, text);
    if (const auto node = find_node(port.owner)) return as_list(port_of_node(*node, port, text, Side::to));
    report_unknown_owner(port, text, Side::to);
    return {};
  }

 private:
  enum class Side : std::uint8_t { from, to };

  Diagnostics& diagnostics() { return draft_.diagnostics; }

  static std::vector<PortIndex> as_list(const std::optional<PortIndex>& port) {
    return port ? std::vector<PortIndex>{*port} : std::vector<PortIndex>{};
  }

  const DraftObject* find_object(const std::string& name) const {
    const auto found = std::find_if(draft_.objects.begin(), draft_.objects.end(), [&](const DraftObject& o) { return o.name == name; });
    return found == draft_.objects.end() ? nullptr : &*found;
  }

  std::optional<std::size_t> find_node(const std::string& name) const {
    for (std::size_t i = Graph::kEngine + 1; i < draft_.nodes.size(); ++i) {
      if (draft_.nodes[i].node.name == name) return i;
    }
    return std::nullopt;
  }

  std::optional<PortIndex> find_source(const Spanned<std::string>& text) {
    const Port port = split(text.value);
    if (port.owner == "actions") return port_of_node(Graph::kEnvironment, port, text, Side::from);
    if (const DraftObject* object = find_object(port.owner)) return sensor(*object, port, text);
    if (const auto node = find_node(port.owner)) return port_of_node(*node, port, text, Side::from);
    report_unknown_owner(port, text, Side::from);
    return std::nullopt;
  }

  std::optional<PortIndex> sensor(const DraftObject& object, const Port& port, const Spanned<std::string>& text) {
    const auto found = object.sensors.find(port.name);
    const bool section = port.section.empty() || port.section == "sensors";
    if (section && found != object.sensors.end()) return found->second;
    if (object.entity == nullptr || draft_.nodes[Graph::kEngine].node.entity == nullptr) return std::nullopt;
    if (section && object.entity->sensor(port.name) != nullptr) {
      report_not_implemented(*object.entity, "sensor", text);
    } else {
      report_unknown_port(port, text, names(object.entity->sensors), Side::from, names(object.entity->actuators));
    }
    return std::nullopt;
  }

  std::vector<PortIndex> actuator(const DraftObject& object, const Port& port, const Spanned<std::string>& text) {
    const auto found = object.actuators.find(port.name);
    const bool section = port.section.empty() || port.section == "actuators";
    if (section && found != object.actuators.end()) return found->second;
    if (object.entity == nullptr || draft_.nodes[Graph::kEngine].node.entity == nullptr) return {};
    if (section && object.entity->actuator(port.name) != nullptr) {
      report_not_implemented(*object.entity, "actuator", text);
    } else {
      report_unknown_port(port, text, names(object.entity->actuators), Side::to, names(object.entity->sensors));
    }
    return {};
  }

  std::optional<PortIndex> port_of_node(std::size_t index, const Port& port, const Spanned<std::string>& text, Side side) {
    const DraftNode& node = draft_.nodes[index];
    const std::string own_section = side == Side::from ? "outputs" : "inputs";
    if (port.section.empty() || port.section == own_section) {
      const std::size_t count = side == Side::from ? node.outputs.size() : node.inputs.size();
      for (std::size_t i = 0; i < count; ++i) {
        if ((side == Side::from ? node.outputs[i].name : node.inputs[i].name) == port.name) return PortIndex{index, i};
      }
    }
    if (index != Graph::kEnvironment && node.node.entity == nullptr) return std::nullopt;  // already reported
    std::vector<std::string> inputs, outputs;
    for (const auto& input : node.inputs) inputs.push_back(input.name);
    for (const auto& output : node.outputs) outputs.push_back(output.name);
    report_unknown_port(port, text, side == Side::from ? outputs : inputs, side, side == Side::from ? inputs : outputs);
    return std::nullopt;
  }

  static std::vector<std::string> names(const std::vector<PortManifest>& ports) {
    std::vector<std::string> result;
    for (const auto& port : ports) result.push_back(port.name.value);
    return result;
  }

  void report_not_implemented(const Entity& entity, std::string_view what, const Spanned<std::string>& text) {
    diagnostics().error("E0308", text.span,
                        fmt::format("`{}` has no {} `{}` on `{}`", entity.id.value, what, split(text.value).name,
                                    draft_.nodes[Graph::kEngine].node.entity->id.value))
        .help = "choose another engine, or add it to the object's manifest";
  }

  void report_unknown_port(const Port& port, const Spanned<std::string>& text, const std::vector<std::string>& known, Side side,
                           const std::vector<std::string>& other_side) {
    const char* sends = side == Side::from ? "sends" : "takes";
    auto& problem = diagnostics().error("E0307", text.span, fmt::format("`{}` has nothing called `{}` that {} messages", port.owner, port.name, sends));
    const std::string near = nearest(port.name, known);
    if (!near.empty()) {
      problem.help = fmt::format("did you mean `{}.{}`?", port.owner, near);
    } else if (std::find(other_side.begin(), other_side.end(), port.name) != other_side.end()) {
      problem.help = fmt::format("`{}` is at the other end of connections: write it as `{}`", text.value, side == Side::from ? "to" : "from");
    } else if (!known.empty()) {
      problem.help = fmt::format("it has {}", fmt::join(known, ", "));
    } else {
      problem.help = fmt::format("nothing of it {} messages", sends);
    }
  }

  void report_unknown_owner(const Port& port, const Spanned<std::string>& text, Side side) {
    std::vector<std::string> known = {side == Side::from ? "actions" : "observations"};
    for (const auto& object : draft_.objects) known.push_back(object.name);
    for (const auto& node : draft_.nodes) {
      if (node.node.role == NodeRole::node) known.push_back(node.node.name);
    }
    auto& problem = diagnostics().error("E0309", text.span, fmt::format("there is nothing called `{}` in this graph", port.owner));
    const std::string near = nearest(port.owner, known);
    const bool wrong_side = port.owner == "actions" || port.owner == "observations";
    if (wrong_side) {
      problem.message = fmt::format("`{}` cannot stand here", text.value);
      problem.help = "actions are sent (`from: actions.…`), observations are received (`to: observations.…`)";
    } else {
      problem.help = near.empty() ? fmt::format("there is {}", fmt::join(known, ", ")) : fmt::format("did you mean `{}.{}`?", near, port.name);
    }
  }

  void connect(const ConnectionSpec& connection, const PortIndex& source, const PortIndex& target) {
    DraftInput& input = draft_.nodes[target.node].inputs[target.port];
    if (input.edge) {
      auto& problem = diagnostics().error("E0311", connection.to.span, fmt::format("`{}` is connected twice", connection.to.value));
      problem.label = "an input takes one connection";
      problem.notes.push_back({"the first connection", input.edge->span, ""});
      return;
    }
    if (input.settings.processor && connection.processor) {
      diagnostics().error("E0313", connection.processor->type.span, fmt::format("`{}` already has a processor", connection.to.value))
          .notes.push_back({"the first processor", input.settings.processor->type.span, ""});
    }
    input.settings = overlay(input.settings, settings_of(connection));
    input.edge = DraftEdge{source.node, source.port, connection.from.span};
    input.span = connection.to.span;
    used_.push_back(source);
  }

  void report_open_ports() {
    for (std::size_t n = 0; n < draft_.nodes.size(); ++n) {
      const DraftNode& node = draft_.nodes[n];
      for (const auto& input : node.inputs) {
        if (input.edge) continue;
        const bool observation = n == Graph::kEnvironment;
        const std::string name = (observation ? "observations" : node.node.name) + "." + input.name;
        auto& problem = diagnostics().error("E0310", input.span, fmt::format("`{}` is not connected", name));
        if (node.node.role == NodeRole::engine_node) {
          problem.help = "an engine node behind the object's actuator needs it: connect the actuator";
        } else {
          problem.help = fmt::format("add a connection `{{from: …, to: {}}}`, or leave it out of the selection", name);
        }
      }
    }
    const auto& actions = draft_.nodes[Graph::kEnvironment].outputs;
    for (std::size_t i = 0; i < actions.size(); ++i) {
      const bool used = std::any_of(used_.begin(), used_.end(), [&](const PortIndex& p) { return p.node == Graph::kEnvironment && p.port == i; });
      if (used) continue;
      diagnostics().error("E0310", actions[i].span, fmt::format("`actions.{}` is not connected", actions[i].name)).help =
          fmt::format("add a connection `{{from: actions.{}, to: …}}`", actions[i].name);
    }
  }

  Draft& draft_;
  std::vector<PortIndex> used_;
};

}  // namespace

void connect(Draft& draft) { Connector(draft).run(); }

}  // namespace eagerx::gen

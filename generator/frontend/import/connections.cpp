// Connections, actions and observations.
#include <fmt/format.h>

#include <algorithm>

#include "generator/frontend/import/translate.hpp"
#include "generator/frontend/read/scalar.hpp"
#include "generator/frontend/spec/port_name.hpp"

namespace eagerx::gen {
namespace {

class ConnectionTranslator {
 public:
  explicit ConnectionTranslator(Translation& t) : t_(t) {}

  void run() {
    for (const auto& link : t_.saved.links) {
      const auto from = source(link.from);
      const auto to = sink(link.to);
      if (!from || !to) continue;
      ConnectionSpec connection;
      connection.span = link.from.span;
      connection.from = {*from, link.from.span};
      connection.to = {*to, link.to.span};
      take_settings(link, connection.settings);
      t_.result.spec.connections.push_back(std::move(connection));
    }
  }

 private:
  std::optional<std::string> fail(const SavedEnd& end, const std::string& why) {
    t_.diagnostics.error(
        "E0802", end.span,
        fmt::format("`{}.{}.{}` cannot be connected: {}", end.entity, end.section, end.port, why));
    return std::nullopt;
  }

  /// The name of an object or node with a port of it.
  std::optional<std::string> port_of(const SavedEnd& end, const char* section) {
    if (t_.saved.unplaced.contains(end.entity) || end.entity == "engine") return std::nullopt;
    const auto name = t_.names.find(end.entity);
    if (name == t_.names.end()) return fail(end, "there is no such node in this file");
    if (is_identifier(end.port)) return fmt::format("{}.{}{}", name->second, section, end.port);
    const Entity* entity = t_.entity(end.entity);
    if (entity == nullptr) return std::nullopt;  // reported
    return fail(end, fmt::format("`{}` has no such port", entity->id.value));
  }

  std::optional<std::string> source(const SavedEnd& end) {
    if (end.entity == "environment") {
      const auto action = t_.actions.find(end.port);
      if (end.section != "outputs" || action == t_.actions.end())
        return fail(end, "there is no such action in this file");
      return "actions." + action->second;
    }
    if (end.section == "states") return port_of(end, "states.");
    if (end.section == "outputs" || end.section == "sensors") return port_of(end, "");
    return fail(end, "a source is an output, a sensor or a state");
  }

  std::optional<std::string> sink(const SavedEnd& end) {
    if (end.entity == "environment") {
      const auto observation = t_.observations.find(end.port);
      if (end.section != "inputs" || observation == t_.observations.end())
        return fail(end, "there is no such observation in this file");
      return "observations." + observation->second;
    }
    if (end.section == "feedthroughs") return port_of(end, "feedthroughs.");
    if (end.section == "targets") return port_of(end, "targets.");
    if (end.section == "inputs" || end.section == "actuators") return port_of(end, "");
    return fail(end, "a target is an input, an actuator, a feedthrough or a reset target");
  }

  /// Defaults of the connection: the sender's delay over what the receiver says.
  ConnectionSettings defaults_of(const SavedLink& link) {
    const Entity* entity = t_.entity(link.from.entity);
    const PortManifest* sensor = entity != nullptr && link.from.section == "sensors"
                                     ? manifest_port(*entity, link.from.section, link.from.port)
                                     : nullptr;
    ConnectionSettings defaults = defaults_of(link.to);
    return sensor != nullptr ? overlay(std::move(defaults), sensor->settings) : defaults;
  }

  ConnectionSettings defaults_of(const SavedEnd& end) {
    const Entity* entity = t_.entity(end.entity);
    if (entity == nullptr) return {};
    const PortManifest* port = manifest_port(*entity, end.section, end.port);
    ConnectionSettings own = port != nullptr ? port->settings : ConnectionSettings();
    if (end.section != "actuators") return own;
    // Of the engine node, then the actuator's, then of the connection between them.
    const ObjectEngine* implementation = t_.implementation(*entity);
    const ConnectionSpec* inside = implementation != nullptr
                                       ? connection_of(*implementation, "actuators." + end.port)
                                       : nullptr;
    if (inside == nullptr) return own;
    return overlay(overlay(settings_of_input(*implementation, inside->to.value), own),
                   inside->settings);
  }

  static const ConnectionSpec* connection_of(const ObjectEngine& implementation,
                                             const std::string& from) {
    for (const auto& connection : implementation.connections) {
      if (connection.from.value == from) return &connection;
    }
    return nullptr;
  }

  /// Of "node.input" of an engine node.
  ConnectionSettings settings_of_input(const ObjectEngine& implementation, const std::string& to) {
    const PortName port = parse_port(to);
    for (const auto& node : implementation.nodes) {
      const Entity* type = t_.mapping.library().find(node.type.value);
      if (node.name.value != port.owner || type == nullptr) continue;
      if (const PortManifest* input = type->input(port.name)) return input->settings;
    }
    return {};
  }

  /// Takes saved settings of the connection that differ from its defaults.
  void take_settings(const SavedLink& link, ConnectionSettings& settings) {
    const SavedEnd& end = link.to;
    const SavedEntity& entity = *t_.saved.find(end.entity);
    const SavedPort* port = entity.port(end.section, end.port);
    if (port == nullptr) return;
    settings.processor = t_.mapping.processor(*port, fmt::format("`{}.{}`", end.entity, end.port));
    if (settings.processor) warn_of_lost_processor(link, *port);
    take_processor_of_action(link.from, settings);
    if (end.section == "targets") return;
    const ConnectionSettings defaults = defaults_of(link);
    if (const YamlValue* window = port->find("window")) take_window(*window, defaults, settings);
    if (const YamlValue* delay = port->find("delay")) {
      const auto value = saved_delay(*delay, t_.diagnostics);
      if (value && value != delay_of(defaults)) settings.delay = QuantitySpec{*value, delay->span};
    }
    if (const YamlValue* skip = port->find("skip")) {
      const auto value = parse_bool(skip->text);
      if (!value || !skip->is_scalar()) {
        t_.diagnostics.error("E0802", skip->span,
                             fmt::format("expected true or false, found {}", describe(*skip)));
      } else if (*value != skips(defaults)) {
        settings.skip = Spanned<bool>{*value, skip->span};
      }
    }
  }

  /// EAGERx takes the processor of an input that a sensor is connected to from what the node had
  /// when it was added.
  void warn_of_lost_processor(const SavedLink& link, const SavedPort& port) {
    if (link.from.section != "sensors" || t_.saved.flattened() || link.to.section != "inputs")
      return;
    const std::string input = fmt::format("{}.{}", link.to.entity, link.to.port);
    if (t_.saved.processors_when_added.contains(input)) return;
    t_.diagnostics
        .warning("E0806", port.find("processor")->span,
                 fmt::format("EAGERx loses the processor of `{}` when it runs this graph", input))
        .help =
        "it was set after the node was added, and a sensor is connected; here the processor acts";
  }

  /// EAGERx processes an action before it sends it; here each connection has its own processor.
  void take_processor_of_action(const SavedEnd& from, ConnectionSettings& settings) {
    if (from.entity != "environment") return;
    const SavedPort* action = t_.saved.find(from.entity)->port(from.section, from.port);
    const YamlValue* saved = action != nullptr ? action->find("processor") : nullptr;
    if (saved == nullptr) return;
    auto first = t_.mapping.processor(*action, fmt::format("the action `{}`", from.port));
    if (!first) return;
    if (settings.processor) {
      settings.processor->before.insert(settings.processor->before.begin(), std::move(*first));
    } else {
      settings.processor = std::move(first);
    }
  }

  void take_window(const YamlValue& window, const ConnectionSettings& defaults,
                   ConnectionSettings& settings) {
    constexpr std::int64_t kLargest = 1'000'000;
    const auto value = window.is_scalar() ? parse_int(window.text) : std::nullopt;
    if (!value || *value < 0 || *value > kLargest) {
      t_.diagnostics.error("E0802", window.span,
                           fmt::format("expected a window of 0 to {} messages, found {}", kLargest,
                                       describe(window)));
    } else if (value != window_of(defaults)) {
      settings.window = QuantitySpec{Rational(*value), window.span};
    }
  }

  Translation& t_;
};

/// The manifest's space of what an action or observation is connected to; nullptr if it does not
/// follow from a manifest alone.
const SpaceSpec* manifest_space(const Translation& t, const SavedEnd& end) {
  const Entity* entity = t.entity(end.entity);
  const PortManifest* port =
      entity != nullptr ? manifest_port(*entity, end.section, end.port) : nullptr;
  return port != nullptr && !port->space.like ? &port->space : nullptr;
}

bool has_processor(const Translation& t, const SavedEnd& end) {
  const SavedEntity* entity = t.saved.find(end.entity);
  const SavedPort* port = entity != nullptr ? entity->port(end.section, end.port) : nullptr;
  return port != nullptr && port->find("processor") != nullptr;
}

/// An action takes the space of what it is connected to, if all of that agrees with what is saved.
bool follows(const Translation& t, const std::string& action, const SpaceSpec& saved) {
  bool any = false;
  for (const auto& link : t.saved.links) {
    if (link.from.entity != "environment" || link.from.port != action) continue;
    const SpaceSpec* other = manifest_space(t, link.to);
    if (other == nullptr || has_processor(t, link.to) || !same_space(saved, *other)) return false;
    any = true;
  }
  return any;
}

void add_action(Translation& t, const SavedEntity& environment, const Spanned<std::string>& name) {
  ComponentSpec action;
  action.name = {t.actions.at(name.value), name.span};
  if (const SavedPort* port = environment.port("outputs", name.value)) {
    const auto space = saved_space(*port);
    if (space && !follows(t, name.value, *space)) action.space = space;
  }
  if (action.space) check_space(*action.space, t.diagnostics);
  t.result.spec.actions.push_back(std::move(action));
}

void add_observation(Translation& t, const SavedEntity& environment,
                     const Spanned<std::string>& name) {
  ComponentSpec observation;
  observation.name = {t.observations.at(name.value), name.span};
  const SavedPort* port = environment.port("inputs", name.value);
  auto space = port != nullptr ? saved_space(*port) : std::nullopt;
  for (const auto& link : t.saved.links) {
    if (!space || link.to.entity != "environment" || link.to.port != name.value) continue;
    const SpaceSpec* source = manifest_space(t, link.from);
    const bool same = source != nullptr && same_space(*space, *source);
    // Behind a processor the saved space may be that in front of it.
    if (same || has_processor(t, link.to) || has_processor(t, link.from)) {
      space.reset();
    } else {
      space->dtype.reset();  // known from the source
      space->shape.reset();
      if (!space->low && !space->high) space.reset();
    }
  }
  observation.space = std::move(space);
  if (observation.space) check_space(*observation.space, t.diagnostics);
  t.result.spec.observations.push_back(std::move(observation));
}

}  // namespace

void translate_connections(Translation& t) {
  ConnectionTranslator(t).run();
}

namespace {

/// A graph without observations or actions is a recording or a controller, which EAGERx has no use
/// for.
void warn_of_nothing(Translation& t, const SavedEntity& environment, const char* section,
                     const char* what, const char* why) {
  if (!environment.selected.at(section).empty()) return;
  t.diagnostics
      .warning("E0806", environment.name.span, fmt::format("the environment has no {}", what))
      .help = fmt::format("EAGERx refuses this graph; here it runs, as {}", why);
}

}  // namespace

void translate_environment(Translation& t) {
  const SavedEntity& environment = *t.saved.find("environment");
  warn_of_nothing(t, environment, "inputs", "observations", "no agent has to look at it");
  warn_of_nothing(t, environment, "outputs", "actions", "its nodes may act alone");
  for (const auto& name : environment.selected.at("outputs")) add_action(t, environment, name);
  for (const auto& name : environment.selected.at("inputs")) add_observation(t, environment, name);
}

}  // namespace eagerx::gen

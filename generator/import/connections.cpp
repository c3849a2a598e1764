// Connections, actions and observations.
#include <fmt/format.h>

#include <algorithm>

#include "generator/import/translate.hpp"
#include "generator/read/scalar.hpp"

namespace eagerx::gen {
namespace {

/// Settings that a connection has if nothing is said.
struct Defaults {
  std::optional<std::int64_t> window = 1;  // nullopt: depends on a parameter
  Rational delay_s;
  bool skip = false;
};

template <class Spec>
void take(Defaults& defaults, const Spec& spec) {
  if constexpr (std::is_same_v<Spec, PortManifest>) {
    if (spec.window) defaults.window = parse_int(spec.window->text);
    defaults.delay_s = spec.delay_s.value_or(defaults.delay_s);
    defaults.skip = spec.skip.value_or(defaults.skip);
  } else {
    if (spec.window) defaults.window = spec.window->value;
    if (spec.delay_s) defaults.delay_s = spec.delay_s->value;
    if (spec.skip) defaults.skip = spec.skip->value;
  }
}

class ConnectionTranslator {
 public:
  explicit ConnectionTranslator(Translation& t) : t_(t) {}

  void run() {
    for (const auto& link : t_.saved.links) {
      const auto from = source(link.from);
      const auto to = target(link.to);
      if (!from || !to) continue;
      ConnectionSpec connection;
      connection.span = link.from.span;
      connection.from = {*from, link.from.span};
      connection.to = {*to, link.to.span};
      take_settings(link.to, connection);
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

  std::optional<std::string> target(const SavedEnd& end) {
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

  Defaults defaults_of(const SavedEnd& end) {
    Defaults result;
    const Entity* entity = t_.entity(end.entity);
    if (entity == nullptr) return result;
    const PortManifest* port = manifest_port(*entity, end.section, end.port);
    if (end.section != "actuators") {
      if (port != nullptr) take(result, *port);
      return result;
    }
    // Of the engine node, then the actuator's, then of the connection between them.
    const ObjectEngine* implementation = t_.implementation(*entity);
    const ConnectionSpec* inside = nullptr;
    if (implementation != nullptr) {
      for (const auto& connection : implementation->connections) {
        if (inside == nullptr && connection.from.value == "actuators." + end.port)
          inside = &connection;
      }
    }
    if (inside != nullptr) {
      const std::size_t dot = inside->to.value.find('.');
      for (const auto& node : implementation->nodes) {
        const Entity* type = t_.counterparts.library().find(node.type.value);
        if (node.name.value != inside->to.value.substr(0, dot) || type == nullptr) continue;
        if (const PortManifest* input = type->input(inside->to.value.substr(dot + 1)))
          take(result, *input);
      }
    }
    if (port != nullptr) take(result, *port);
    if (inside != nullptr) take(result, *inside);
    return result;
  }

  void take_settings(const SavedEnd& end, ConnectionSpec& connection) {
    const SavedEntity& entity = *t_.saved.find(end.entity);
    const SavedPort* port = entity.port(end.section, end.port);
    if (port == nullptr) return;
    connection.processor =
        t_.counterparts.processor(*port, fmt::format("`{}.{}`", end.entity, end.port));
    if (end.section == "targets") return;
    const Defaults defaults = defaults_of(end);
    if (const YamlValue* window = port->find("window")) take_window(*window, defaults, connection);
    if (const YamlValue* delay = port->find("delay")) {
      const auto value = saved_delay(*delay, t_.diagnostics);
      if (value && *value != defaults.delay_s)
        connection.delay_s = Spanned<Rational>{*value, delay->span};
    }
    if (const YamlValue* skip = port->find("skip")) {
      const auto value = parse_bool(skip->text);
      if (!value || !skip->is_scalar()) {
        t_.diagnostics.error("E0802", skip->span,
                             fmt::format("expected true or false, found {}", describe(*skip)));
      } else if (*value != defaults.skip) {
        connection.skip = Spanned<bool>{*value, skip->span};
      }
    }
  }

  void take_window(const YamlValue& window, const Defaults& defaults, ConnectionSpec& connection) {
    constexpr std::int64_t kLargest = 1'000'000;
    const auto value = window.is_scalar() ? parse_int(window.text) : std::nullopt;
    if (!value || *value < 0 || *value > kLargest) {
      t_.diagnostics.error("E0802", window.span,
                           fmt::format("expected a window of 0 to {} messages, found {}", kLargest,
                                       describe(window)));
    } else if (value != defaults.window) {
      connection.window = Spanned<std::uint32_t>{static_cast<std::uint32_t>(*value), window.span};
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
    if (const YamlValue* processor = port->find("processor")) {
      t.diagnostics
          .error("E0807", processor->span,
                 fmt::format("the action `{}` has a processor", name.value))
          .help = "put it on what the action is connected to";
    }
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

void translate_environment(Translation& t) {
  const SavedEntity& environment = *t.saved.find("environment");
  for (const auto& name : environment.selected.at("outputs")) add_action(t, environment, name);
  for (const auto& name : environment.selected.at("inputs")) add_observation(t, environment, name);
}

}  // namespace eagerx::gen

// Names, objects, nodes and the engine's own parameters.
#include <fmt/format.h>

#include <array>
#include <cctype>
#include <filesystem>

#include "generator/frontend/import/translate.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/frontend/spec/port_name.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// The nearest text that may be a name and is not taken.
std::string made_name(const std::string& text, const std::string& otherwise,
                      const std::set<std::string>& taken) {
  std::string name;
  for (const char c : text) {
    const bool letter = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (letter) name += c;
    if (!letter && !name.empty() && name.back() != '_') name += '_';
  }
  while (!name.empty() && name.back() == '_' && (text.empty() || text.back() != '_'))
    name.pop_back();
  constexpr std::size_t kLongest = 80;
  name = name.substr(0, kLongest);
  if (name.empty() || std::isdigit(static_cast<unsigned char>(name[0])) != 0)
    name = otherwise + (name.empty() ? "" : "_" + name);
  if (!is_identifier(name)) name += "_1";
  if (!is_identifier(name)) name = otherwise;
  std::string result = name;
  for (int i = 2; taken.contains(result); ++i) result = fmt::format("{}_{}", name, i);
  return result;
}

/// Names as they are where they can be, then the others.
std::map<std::string, std::string> made_names(const std::vector<Spanned<std::string>>& saved,
                                              const std::string& otherwise,
                                              std::set<std::string> taken,
                                              Diagnostics& diagnostics) {
  std::map<std::string, std::string> result;
  std::vector<Spanned<std::string>> others;
  for (const auto& name : saved) {
    const bool good = is_identifier(name.value) && !taken.contains(name.value);
    if (!good) {
      others.push_back(name);
      continue;
    }
    result[name.value] = name.value;
    taken.insert(name.value);
  }
  for (const auto& name : others) {
    if (result.contains(name.value)) continue;
    const std::string made = made_name(name.value, otherwise, taken);
    result[name.value] = made;
    taken.insert(made);
    diagnostics.note(
        name.span, fmt::format("`{}` cannot be a name here and is called `{}`", name.value, made));
  }
  return result;
}

class EntityTranslator {
 public:
  explicit EntityTranslator(Translation& t) : t_(t) {}

  void run() {
    for (const auto& entity : t_.saved.entities) {
      if (entity.kind == SavedEntity::Kind::object) add(entity, Use::object, "object");
      if (entity.kind == SavedEntity::Kind::node) add(entity, Use::node, "node");
      if (entity.kind == SavedEntity::Kind::engine) add_engine(entity);
    }
  }

 private:
  GraphSpec& spec() { return t_.result.spec; }

  void add(const SavedEntity& saved, Use use, const char* what) {
    const std::string user = fmt::format("the {} `{}`", what, saved.name.value);
    const Entity* entity = t_.mapping.find(saved.id, saved.config, use, user);
    if (entity != nullptr && !t_.mapping.may_stand_in(*entity, saved, user)) entity = nullptr;
    t_.entities[saved.name.value] = entity;
    if (entity == nullptr) return;
    EntitySpec made;
    made.name = {t_.names.at(saved.name.value), saved.name.span};
    made.type = {entity->id.value, saved.id.span};
    made.config = t_.mapping.settings(*entity, saved.config, user);
    add_states(saved, made);
    if (use == Use::object) {
      made.sensors = rated_ports(saved, *entity, made, "sensors");
      made.actuators = rated_ports(saved, *entity, made, "actuators");
      spec().objects.push_back(std::move(made));
      return;
    }
    const YamlValue* rate = saved.parameter("rate");
    if (rate == nullptr) {
      t_.diagnostics.error("E0802", saved.name.span, fmt::format("{} has no rate", user));
    } else if (const auto value = saved_rate(*rate, t_.diagnostics)) {
      made.rate = QuantitySpec{*value, rate->span};
    }
    made.inputs = node_ports(saved, *entity, "inputs", entity->inputs);
    made.outputs = node_ports(saved, *entity, "outputs", entity->outputs);
    spec().nodes.push_back(std::move(made));
  }

  void add_engine(const SavedEntity& saved) {
    const Entity* entity = t_.mapping.find(saved.id, saved.config, Use::engine, "the engine");
    t_.entities[saved.name.value] = entity;
    if (entity == nullptr) return;
    EntitySpec& engine = spec().engine;
    engine.name = {"engine", saved.name.span};
    engine.type = {entity->id.value, saved.id.span};
    engine.config = t_.mapping.settings(*entity, saved.config, "the engine");
    add_states(saved, engine);
    const YamlValue* rate = saved.parameter("rate");
    if (rate == nullptr && !t_.options.engine_rate_hz) {
      t_.diagnostics.error("E0804", saved.name.span, "the engine has no rate").help =
          "give it with `--engine-rate`";
    } else if (rate != nullptr) {
      if (const auto value = saved_rate(*rate, t_.diagnostics))
        engine.rate = QuantitySpec{*value, rate->span};
    }
    const YamlValue* delays = saved.parameter("simulate_delays");
    if (delays != nullptr && delays->text == "false") {
      t_.diagnostics
          .note(delays->span,
                "delays are simulated: `simulate_delays: false` does nothing in EAGERx")
          .help =
          "in a graph of your own, `simulate_delays: false` under `engine:` counts them as 0";
    }
    const YamlValue* sync = saved.parameter("sync");
    if (sync != nullptr && sync->text == "false") {
      t_.diagnostics
          .warning("E0806", sync->span, "EAGERx ran this graph asynchronously (`sync: false`)")
          .help =
          "the program counts messages; on an engine of real hardware write `sync: false` yourself";
    }
  }

  void add_states(const SavedEntity& saved, EntitySpec& made) {
    for (const auto& name : saved.selected.at("states")) {
      StateSpec state;
      state.name = name;
      if (const SavedPort* port = saved.port("states", name.value))
        state.processor = t_.mapping.processor(*port, written(saved, name.value));
      made.states.push_back(std::move(state));
    }
  }

  bool is_linked(const std::string& entity, std::string_view section, const std::string& port) {
    return ranges::any_of(t_.saved.links, [&](const SavedLink& link) {
      const SavedEnd& end = section == "sensors" ? link.from : link.to;
      return end.entity == entity && end.section == section && end.port == port;
    });
  }

  /// Sensors and actuators of which something has to be said: another rate, a processor, or that
  /// they are in use although nothing is connected to them.
  Selection rated_ports(const SavedEntity& saved, const Entity& entity, const EntitySpec& made,
                        const char* section) {
    std::vector<ComponentSpec> result, all;
    const auto ports = saved.ports.find(section);
    if (ports == saved.ports.end()) return std::nullopt;
    for (const auto& port : ports->second) {
      const PortManifest* manifest = manifest_port(entity, section, port.name.value);
      const bool linked = is_linked(saved.name.value, section, port.name.value);
      const bool selected = saved.is_selected(section, port.name.value);
      if (manifest == nullptr) {
        if (selected && !linked) note_left_out(saved, entity, port.name);
        continue;  // a connection to it is a problem that resolve reports
      }
      ComponentSpec component;
      component.name = port.name;
      const auto rate = rate_of(port, entity, *manifest, made);
      const bool borrowed = rate && (lends_rate(entity, section, port.name.value) ||
                                     hangs_on_actuator(saved, entity, section, port.name.value));
      if (!linked && !selected && !borrowed) continue;
      component.rate = rate;
      if (std::string_view(section) == "sensors")
        component.settings.processor = t_.mapping.processor(port, written(saved, port.name.value));
      if (const auto space = saved_space(port))
        component.space = missing_of(*space, manifest->space);
      if (component.space) check_space(*component.space, t_.diagnostics);
      all.push_back(component);
      if (!linked || component.rate || component.settings.processor || component.space)
        result.push_back(std::move(component));
    }
    if (result.empty()) return std::nullopt;
    return has_only_names(result) ? all : result;
  }

  void note_left_out(const SavedEntity& saved, const Entity& entity,
                     const Spanned<std::string>& port) {
    t_.diagnostics.note(port.span, fmt::format("`{}.{}` is left out: `{}` does not have it",
                                               saved.name.value, port.value, entity.id.value));
  }

  static std::string written(const SavedEntity& saved, const std::string& port) {
    return fmt::format("`{}.{}`", saved.name.value, port);
  }

  /// The rate, if it is not the manifest's.
  std::optional<Spanned<Rational>> rate_of(const SavedPort& port, const Entity& entity,
                                           const PortManifest& manifest, const EntitySpec& made) {
    const YamlValue* rate = port.find("rate");
    if (rate == nullptr) return std::nullopt;
    const auto value = saved_rate(*rate, t_.diagnostics);
    if (!value || manifest_rate(entity, manifest, made.config) == value) return std::nullopt;
    return Spanned<Rational>{*value, rate->span};
  }

  /// Whether engine nodes of other sensors and actuators tick at the rate of this one.
  static bool lends_rate(const Entity& entity, const char* section, const std::string& name) {
    const Reference reference = rate_reference(section, name);
    for (const auto& implementation : entity.object_engines) {
      for (const auto& node : implementation.nodes) {
        if (reference_in(*node.rate) != reference) continue;
        const bool own = ranges::any_of(implementation.connections, [&](const ConnectionSpec& c) {
          return (c.to.value == fmt::format("{}.{}", section, name) &&
                  c.from.value.starts_with(node.name.value + ".")) ||
                 (c.from.value == fmt::format("{}.{}", section, name) &&
                  c.to.value.starts_with(node.name.value + "."));
        });
        if (!own) return true;
      }
    }
    return false;
  }

  /// Whether the engine node of a sensor runs although the sensor is not selected, because it
  /// follows an actuator that is in use.
  bool hangs_on_actuator(const SavedEntity& saved, const Entity& entity, std::string_view section,
                         const std::string& name) {
    if (section != "sensors") return false;
    const auto owner = [](const std::string& port) { return parse_port(port).owner; };
    for (const auto& implementation : entity.object_engines) {
      std::set<std::string> driven;  // engine nodes
      for (std::size_t before = 0;; before = driven.size()) {
        for (const auto& connection : implementation.connections) {
          const PortName from = parse_port(connection.from.value);
          const bool drives = from.owner == "actuators"
                                  ? saved.is_selected("actuators", from.name) ||
                                        is_linked(saved.name.value, "actuators", from.name)
                                  : driven.contains(from.owner);
          if (drives) driven.insert(owner(connection.to.value));
        }
        if (driven.size() == before) break;
      }
      for (const auto& connection : implementation.connections) {
        if (connection.to.value == "sensors." + name &&
            driven.contains(owner(connection.from.value)))
          return true;
      }
    }
    return false;
  }

  /// The space of an output where it differs from the manifest's. One that is like an input has a
  /// space of its own if the input's was saved with another shape or type.
  static std::optional<SpaceSpec> own_space(const SavedEntity& saved, const SpaceSpec& space,
                                            const SpaceSpec& manifest) {
    if (!manifest.like) return missing_of(space, manifest);
    const SavedPort* input = saved.port("inputs", manifest.like->value);
    const auto other = input != nullptr ? saved_space(*input) : std::nullopt;
    if (!other || !missing_of(space, *other)) return std::nullopt;
    return space;
  }

  /// The selection, if it is not everything or something has to be said of one of them.
  Selection node_ports(const SavedEntity& saved, const Entity& entity, const char* section,
                       const std::vector<PortManifest>& known) {
    std::vector<ComponentSpec> result;
    bool needed = false;
    for (const auto& name : saved.selected.at(section)) {
      ComponentSpec component;
      component.name = name;
      const SavedPort* port = saved.port(section, name.value);
      const PortManifest* manifest = manifest_port(entity, section, name.value);
      if (port != nullptr && manifest != nullptr) {
        if (std::string_view(section) == "outputs") {
          component.settings.processor = t_.mapping.processor(*port, written(saved, name.value));
          const auto space = saved_space(*port);
          if (space) component.space = own_space(saved, *space, manifest->space);
          if (component.space) check_space(*component.space, t_.diagnostics);
        }
        needed = needed || component.settings.processor || component.space;
      }
      result.push_back(std::move(component));
    }
    const bool all = ranges::all_of(known, [&](const PortManifest& port) {
      return saved.is_selected(section, port.name.value);
    });
    if (all && !needed && result.size() == known.size()) return std::nullopt;
    return result;
  }

  Translation& t_;
};

}  // namespace

const ObjectEngine* Translation::implementation(const Entity& object) const {
  const Entity* engine = mapping.library().find(result.spec.engine.type.value);
  return engine == nullptr ? nullptr : object.implementation(*engine);
}

bool has_only_names(const std::vector<ComponentSpec>& components) {
  return ranges::none_of(components, [](const ComponentSpec& component) {
    return component.rate || component.space || component.settings.processor;
  });
}

void translate_names(Translation& t) {
  GraphSpec& spec = t.result.spec;
  const std::string file = std::filesystem::path(spec.path).filename().string();
  const std::string wanted = t.saved.env_name.value_or(file.substr(0, file.find('.')));
  spec.name = {is_identifier(wanted) ? wanted : made_name(wanted, "graph", {}), {}};
  spec.name.span.file = spec.file;
  std::vector<Spanned<std::string>> entities;
  for (const auto& entity : t.saved.entities) {
    if (entity.kind == SavedEntity::Kind::object || entity.kind == SavedEntity::Kind::node)
      entities.push_back(entity.name);
  }
  t.names =
      made_names(entities, "node", {"actions", "observations", "environment", "engine", "agent"},
                 t.diagnostics);
  const SavedEntity& environment = *t.saved.find("environment");
  t.actions = made_names(environment.selected.at("outputs"), "action", {}, t.diagnostics);
  t.observations = made_names(environment.selected.at("inputs"), "observation", {}, t.diagnostics);
}

void translate_entities(Translation& t) {
  EntityTranslator(t).run();
}

void add_states_of_engine_nodes(Translation& t) {
  for (const auto& saved : t.saved.entities) {
    const Entity* entity = t.entity(saved.name.value);
    const ObjectEngine* implementation =
        saved.kind == SavedEntity::Kind::object && entity != nullptr ? t.implementation(*entity)
                                                                     : nullptr;
    if (implementation == nullptr) continue;
    EntitySpec& object = *find_named(t.result.spec.objects, t.names.at(saved.name.value));
    const auto in_use = [&](const std::string& node) {
      return ranges::any_of(implementation->connections, [&](const ConnectionSpec& c) {
        const PortName from = parse_port(c.from.value), to = parse_port(c.to.value);
        return (to.owner == node && from.owner == "actuators" &&
                saved.is_selected("actuators", from.name)) ||
               (from.owner == node && to.owner == "sensors" &&
                saved.is_selected("sensors", to.name));
      });
    };
    for (const auto& state : implementation->node_states) {
      if (find_named(object.states, state.name.value) != nullptr ||
          !in_use(parse_port(state.node.value).owner))
        continue;
      StateSpec made;
      made.name = {state.name.value, saved.name.span};
      object.states.push_back(std::move(made));
    }
  }
}

}  // namespace eagerx::gen

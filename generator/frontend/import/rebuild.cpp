// BaseEnv.save writes engine nodes instead of objects. This file restores the objects: an object's
// manifest assigns engine nodes to sensors and actuators.
#include <fmt/format.h>

#include <set>

#include "generator/frontend/import/entity_mapping.hpp"
#include "generator/frontend/import/rebuilt.hpp"
#include "generator/frontend/read/rational.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

void set_entry(YamlValue& map, const char* key, const YamlValue& value) {
  map.kind = YamlKind::map;
  for (auto& entry : map.entries) {
    if (entry.key != key) continue;
    entry.value = value;
    return;
  }
  map.entries.push_back({key, value.span, value});
}

class Rebuilder {
 public:
  Rebuilder(SavedGraph& saved, EntityMapping& mapping, Diagnostics& diagnostics)
      : saved_(saved), mapping_(mapping), diagnostics_(diagnostics) {}

  bool run() {
    const SavedEntity& engine = *saved_.find("engine");
    engine_ = mapping_.find(engine.id, engine.config, Use::engine, "the engine");
    add_links_of_addresses();
    for (const auto& object : saved_.objects) rebuild(object);
    if (!failed_) rewrite_links();
    if (failed_) {
      remove_engine_nodes();
    } else {
      replace_entities();
    }
    return !failed_;
  }

 private:
  void fail(Span span, std::string message, std::string help) {
    diagnostics_.error("E0805", span, std::move(message)).help = std::move(help);
    failed_ = true;
  }

  /// The states that reset nodes bring about are only named by their address.
  void add_links_of_addresses() {
    std::set<std::tuple<std::string, std::string, std::string>> linked;
    for (const auto& link : saved_.links)
      linked.insert({link.to.entity, link.to.section, link.to.port});
    for (const auto& entity : saved_.entities) {
      for (const auto& [section, ports] : entity.ports) {
        for (const auto& port : ports) {
          const YamlValue* address = port.find("address");
          if (address == nullptr || !entity.is_selected(section, port.name.value) ||
              linked.contains({entity.name.value, section, port.name.value}))
            continue;
          if (auto source = source_of(*address))
            saved_.links.push_back(
                {*source, {entity.name.value, section, port.name.value, port.name.span}});
        }
      }
    }
  }

  /// "obj/states/st0", "obj/x/outputs/o0", where the names of ports have no slash.
  static std::optional<SavedEnd> source_of(const YamlValue& address) {
    const std::string& text = address.text;
    const std::size_t last = text.rfind('/');
    if (last == std::string::npos || last == 0) return std::nullopt;
    const std::size_t middle = text.rfind('/', last - 1);
    if (middle == std::string::npos) return std::nullopt;
    return SavedEnd{text.substr(0, middle), text.substr(middle + 1, last - middle - 1),
                    text.substr(last + 1), address.span};
  }

  void rebuild(const SavedObject& object) {
    const std::string& name = object.name.value;
    const SavedEntity* backup = find_named(saved_.backup, name);
    if (backup == nullptr && object.nodes.empty()) {
      leave_out(object);
      return;
    }
    if (backup == nullptr) {
      fail(object.name.span, fmt::format("the file does not say what the object `{}` is", name),
           "it is not under `backup:`; import the file that Graph.save wrote");
      return;
    }
    Rebuilt rebuilt;
    rebuilt.object = *backup;
    for (const auto& entry : object.parameters.entries) {
      if (backup->config.find(entry.key) != nullptr)
        set_entry(rebuilt.object.config, entry.key.c_str(), entry.value);
    }
    rebuilt.entity = mapping_.find(backup->id, rebuilt.object.config, Use::object,
                                   fmt::format("the object `{}`", name));
    if (rebuilt.entity == nullptr || engine_ == nullptr) {
      failed_ = true;
      return;
    }
    for (const auto& implementation : rebuilt.entity->object_engines) {
      if (implementation.engine.value == engine_->id.value)
        rebuilt.implementation = &implementation;
    }
    if (rebuilt.implementation == nullptr) {
      fail(object.name.span,
           fmt::format("the object `{}` cannot be put back: `{}` is not implemented for `{}`", name,
                       rebuilt.entity->id.value, engine_->id.value),
           fmt::format("add `{}` to `engines:` in its manifest, or import the file that Graph.save "
                       "wrote and choose another `--engine`",
                       engine_->id.value));
      return;
    }
    rebuilt.object.selected["states"] = object.states;
    match_nodes(object, rebuilt);
    take_states_of_nodes(rebuilt);
    take_ports(rebuilt);
    rebuilt_.push_back(std::move(rebuilt));
  }

  /// Leaves out what EngineSpec.add_object adds: a graph here has only objects with sensors or
  /// actuators.
  void leave_out(const SavedObject& object) {
    const std::string& name = object.name.value;
    if (object.states.empty()) {
      diagnostics_.note(object.name.span,
                        fmt::format("`{}`, an object that only the engine knows, is left out: it "
                                    "has neither engine nodes nor states",
                                    name));
      return;
    }
    diagnostics_
        .warning("E0806", object.name.span,
                 fmt::format("`{}`, an object that only the engine knows, is left out", name))
        .help = "what its states do at a reset has to be done by the engine or by another object";
  }

  /// By name, else by what they are if there is only one of that kind.
  void match_nodes(const SavedObject& object, Rebuilt& rebuilt) {
    const auto& ours = rebuilt.implementation->nodes;
    std::set<std::string> taken;
    std::vector<const SavedEntity*> open;
    const std::string prefix = object.name.value + "/";
    for (const auto& entity : saved_.entities) {
      if (!entity.name.value.starts_with(prefix)) continue;
      owners_[entity.name.value] = rebuilt_.size();
      const std::string local = entity.name.value.substr(prefix.size());
      const EntitySpec* same = find_named(ours, local);
      if (same == nullptr) {
        open.push_back(&entity);
        continue;
      }
      rebuilt.matches[entity.name.value] = local;
      taken.insert(local);
      check_type(entity, *same);
    }
    for (const SavedEntity* entity : open) match_by_type(*entity, rebuilt, taken);
  }

  void match_by_type(const SavedEntity& entity, Rebuilt& rebuilt, std::set<std::string>& taken) {
    const EntitySpec* only = nullptr;
    for (const auto& node : rebuilt.implementation->nodes) {
      const Entity* type = mapping_.library().find(node.type.value);
      if (type == nullptr || taken.contains(node.name.value) ||
          !EntityMapping::stands_for(*type, entity.id.value))
        continue;
      if (only != nullptr) return;
      only = &node;
    }
    if (only == nullptr) return;
    rebuilt.matches[entity.name.value] = only->name.value;
    taken.insert(only->name.value);
  }

  void check_type(const SavedEntity& entity, const EntitySpec& ours) {
    const Entity* type = mapping_.library().find(ours.type.value);
    if (type == nullptr || type->eagerx_ids.empty() ||
        EntityMapping::stands_for(*type, entity.id.value))
      return;
    diagnostics_.warning("E0806", entity.id.span,
                         fmt::format("`{}` is a `{}` in this file, but a `{}` here",
                                     entity.name.value, entity.id.value, type->id.value));
  }

  /// States of the object that an engine node has: the engine does not list them.
  void take_states_of_nodes(Rebuilt& rebuilt) {
    auto& states = rebuilt.object.selected["states"];
    for (const auto& state : rebuilt.implementation->node_states) {
      const PortName wanted = parse_port(state.node.value);
      for (const auto& [node, local] : rebuilt.matches) {
        const SavedEntity& saved = *saved_.find(node);
        if (local != wanted.owner || !saved.is_selected("states", wanted.name)) continue;
        if (!ranges::contains(states, state.name.value, &Spanned<std::string>::value))
          states.push_back({state.name.value, saved.port("states", wanted.name) != nullptr
                                                  ? saved.port("states", wanted.name)->name.span
                                                  : saved.name.span});
      }
    }
  }

  /// Rates and settings of sensors and actuators, from the engine nodes that they became.
  void take_ports(Rebuilt& rebuilt) {
    for (const auto& [node, local] : rebuilt.matches) {
      const SavedEntity& saved = *saved_.find(node);
      const YamlValue* rate = saved.parameter("rate");
      for (const auto& connection : rebuilt.implementation->connections) {
        const PortName from = parse_port(connection.from.value);
        const PortName to = parse_port(connection.to.value);
        if (to.owner == "sensors" && from.owner == local)
          take_port(rebuilt.object, "sensors", to.name, saved.port("outputs", from.name), rate,
                    connection);
        // Of an actuator that feeds several, the first one's: its defaults are those, too.
        if (from.owner == "actuators" && to.owner == local &&
            &connection == first_from(*rebuilt.implementation, connection.from.value))
          take_port(rebuilt.object, "actuators", from.name, saved.port("inputs", to.name), rate,
                    connection);
      }
    }
    take_borrowed_rates(rebuilt);
  }

  static const ConnectionSpec* first_from(const ObjectEngine& implementation,
                                          const std::string& from) {
    return &*ranges::find_if(implementation.connections, [&](const ConnectionSpec& connection) {
      return connection.from.value == from;
    });
  }

  static void take_port(SavedEntity& object, const char* section, const std::string& name,
                        const SavedPort* from, const YamlValue* rate,
                        const ConnectionSpec& inside) {
    if (from == nullptr) return;
    SavedPort port{{name, from->name.span}, from->settings};
    if (rate != nullptr) set_entry(port.settings, "rate", *rate);
    if (inside.settings.processor)
      set_entry(port.settings, "processor", YamlValue{});  // the manifest's own
    auto& ports = object.ports[section];
    std::erase_if(ports, [&](const SavedPort& p) { return p.name.value == name; });
    ports.push_back(std::move(port));
  }

  /// An engine node may tick at the rate of a sensor that was pruned itself.
  void take_borrowed_rates(Rebuilt& rebuilt) {
    for (const auto& match : rebuilt.matches) {
      const std::string& node = match.first;
      const YamlValue* rate = saved_.find(node)->parameter("rate");
      const EntitySpec* spec = find_named(rebuilt.implementation->nodes, match.second);
      const auto lender = reference_in(*spec->rate);  // `$(sensors theta rate)`
      if (rate == nullptr || !lender || lender->part != "rate") continue;
      SavedPort* port = find_named(rebuilt.object.ports[lender->what], lender->name);
      if (port == nullptr || rebuilt.has_node_of(lender->what, lender->name)) continue;
      set_entry(port->settings, "rate", *rate);
    }
  }

  [[nodiscard]] const Rebuilt* owner(const std::string& node) const {
    const auto found = owners_.find(node);
    return found == owners_.end() ? nullptr : &rebuilt_[found->second];
  }

  void rewrite_links() {
    std::vector<SavedLink> links;
    std::set<std::tuple<std::string, std::string, std::string>> fed;
    for (auto link : saved_.links) {
      if (link.from.entity == "engine" || link.to.entity == "engine") continue;
      const Rebuilt* from = owner(link.from.entity);
      const Rebuilt* to = owner(link.to.entity);
      if (from != nullptr && from == to && is_inside(*from, link)) continue;
      if (from != nullptr && !rewrite_source(*from, link)) continue;
      if (to != nullptr && !rewrite_sink(*to, link)) continue;
      // An actuator that feeds several engine nodes is one connection.
      if (to != nullptr && !fed.insert({link.to.entity, link.to.section, link.to.port}).second)
        continue;
      links.push_back(std::move(link));
    }
    saved_.links = std::move(links);
  }

  /// Connections between engine nodes of one object are the manifest's business, unless they are
  /// its sensor connected to its actuator.
  bool is_inside(const Rebuilt& object, const SavedLink& link) {
    const std::string from = object.match(link.from.entity), to = object.match(link.to.entity);
    if (from.empty() || to.empty()) return true;
    const ConnectionSpec* inside =
        object.inside(from + "." + link.from.port, to + "." + link.to.port);
    if (inside != nullptr) {
      compare_settings(object, link, *inside, to);
      return true;
    }
    return object.sensors(from, link.from.port).empty() ||
           object.actuator(to, link.to.port) == nullptr;
  }

  void compare_settings(const Rebuilt& object, const SavedLink& link, const ConnectionSpec& inside,
                        const std::string& node) {
    const SavedPort* port = saved_.find(link.to.entity)->port("inputs", link.to.port);
    const EntitySpec* spec = find_named(object.implementation->nodes, node);
    const Entity* type = mapping_.library().find(spec->type.value);
    const PortManifest* manifest = type != nullptr ? type->input(link.to.port) : nullptr;
    if (port == nullptr || manifest == nullptr) return;
    const ConnectionSettings ours = overlay(manifest->settings, inside.settings);
    const std::string window = std::to_string(window_of(ours).value_or(1));
    const auto delay = delay_of(ours);
    const bool skip = skips(ours);
    const auto check = [&](const char* key, const std::string& here, bool same) {
      if (same) return;
      diagnostics_.warning(
          "E0806", port->find(key)->span,
          fmt::format("`{}.{}` has {} {} in this file, but {} here", link.to.entity, link.to.port,
                      key, port->find(key)->text, here));
    };
    if (const YamlValue* value = port->find("window"))
      check("window", window, value->text == window || !window_of(ours));
    if (const YamlValue* value = port->find("delay"))
      check("delay", delay.value_or(Rational()).to_string(),
            !delay || meant_number(*value) == delay);
    if (const YamlValue* value = port->find("skip"))
      check("skip", skip ? "true" : "false", value->text == (skip ? "true" : "false"));
  }

  void cannot_place(const SavedEnd& end, const Rebuilt& object, const char* what) {
    fail(end.span,
         fmt::format("`{}.{}` is not a {} of `{}` on `{}`", end.entity, end.port, what,
                     object.entity->id.value, engine_->id.value),
         fmt::format("add it to the manifest of `{}`, or leave it out in EAGERx",
                     object.entity->id.value));
  }

  bool rewrite_source(const Rebuilt& object, SavedLink& link) {
    const auto sensors = object.sensors(object.match(link.from.entity), link.from.port);
    if (sensors.empty()) {
      cannot_place(link.from, object, "sensor");
      return false;
    }
    link.from.entity = object.object.name.value;
    link.from.section = "sensors";
    link.from.port = sensors.front();
    used_.insert(link.from.entity + ".sensors." + sensors.front());
    return true;
  }

  bool rewrite_sink(const Rebuilt& object, SavedLink& link) {
    const ConnectionSpec* actuator = object.actuator(object.match(link.to.entity), link.to.port);
    if (actuator == nullptr) {
      cannot_place(link.to, object, "actuator");
      return false;
    }
    link.to.entity = object.object.name.value;
    link.to.section = "actuators";
    link.to.port = parse_port(actuator->from.value).name;
    used_.insert(link.to.entity + ".actuators." + link.to.port);
    return true;
  }

  /// A sensor that nothing is connected to was in use if it was selected and has its engine node.
  void select(Rebuilt& rebuilt) {
    for (const char* section : {"sensors", "actuators"}) {
      std::vector<Spanned<std::string>> selected;
      for (const auto& port : rebuilt.object.ports[section]) {
        const std::string& name = port.name.value;
        const bool used =
            used_.contains(fmt::format("{}.{}.{}", rebuilt.object.name.value, section, name));
        const bool listed = rebuilt.object.is_selected(section, name);
        if (used || (listed && std::string_view(section) == "sensors" &&
                     rebuilt.has_node_of(section, name)))
          selected.push_back(port.name);
      }
      rebuilt.object.selected[section] = std::move(selected);
    }
  }

  void remove_engine_nodes() {
    for (const auto& object : saved_.objects) {
      if (failed_) saved_.unplaced.insert(object.name.value);
      std::erase_if(saved_.entities, [&](const SavedEntity& e) {
        const bool inside = e.name.value.starts_with(object.name.value + "/");
        if (inside && failed_) saved_.unplaced.insert(e.name.value);
        return inside;
      });
    }
  }

  void replace_entities() {
    for (const auto& [name, index] : owners_) {
      if (rebuilt_[index].match(name).empty()) {
        diagnostics_.note(
            saved_.find(name)->name.span,
            fmt::format("the engine node `{}` is left out: `{}` has no such engine node on `{}`",
                        name, rebuilt_[index].entity->id.value, engine_->id.value));
      }
    }
    remove_engine_nodes();
    for (auto& rebuilt : rebuilt_) {
      select(rebuilt);
      saved_.entities.push_back(std::move(rebuilt.object));
    }
  }

  SavedGraph& saved_;
  EntityMapping& mapping_;
  Diagnostics& diagnostics_;
  const Entity* engine_ = nullptr;
  std::vector<Rebuilt> rebuilt_;
  std::map<std::string, std::size_t> owners_;  // engine node of the file → index in rebuilt_
  std::set<std::string> used_;                 // object.section.port
  bool failed_ = false;
};

}  // namespace

bool rebuild_objects(SavedGraph& saved, EntityMapping& mapping, Diagnostics& diagnostics) {
  return Rebuilder(saved, mapping, diagnostics).run();
}

}  // namespace eagerx::gen

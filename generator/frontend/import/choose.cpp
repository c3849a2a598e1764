// Settings that Graph.save does not write: the engine, its rate and the environment's rate.
#include <fmt/format.h>

#include "generator/frontend/import/translate.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// Whether the implementation has every sensor, actuator and state of the object that is in use.
bool has_all(const Translation& t, const SavedEntity& object, const ObjectEngine& implementation) {
  const auto& inside = implementation.connections;
  const auto has = [&](std::string_view section, const std::string& port) {
    const std::string name = fmt::format("{}.{}", section, port);
    if (section == "states") {
      return find_named(implementation.states, port) != nullptr ||
             find_named(implementation.node_states, port) != nullptr;
    }
    return ranges::any_of(inside, [&](const ConnectionSpec& c) {
      return c.from.value == name || c.to.value == name;
    });
  };
  const auto used = [&](const SavedEnd& end) {
    return end.entity != object.name.value || has(end.section, end.port);
  };
  const auto& states = object.selected.at("states");
  return ranges::all_of(t.saved.links,
                        [&](const SavedLink& link) { return used(link.from) && used(link.to); }) &&
         ranges::all_of(states, [&](const auto& state) { return has("states", state.value); });
}

/// Engines that every object is implemented for, with all that the graph uses of it. They are in
/// the order of the first object's manifest, which begins with the one it was made for.
std::vector<std::string> common_engines(const Translation& t) {
  std::vector<std::string> result;
  if (t.result.spec.objects.empty()) return t.mapping.library().ids(EntityKind::engine);
  const Entity* first = t.mapping.library().find(t.result.spec.objects.front().type.value);
  for (const auto& implementation : first->object_engines)
    result.push_back(implementation.engine.value);
  for (const auto& object : t.saved.entities) {
    if (object.kind != SavedEntity::Kind::object) continue;
    const Entity* entity = t.entity(object.name.value);
    std::erase_if(result, [&](const std::string& engine) {
      return ranges::none_of(entity->object_engines, [&](const ObjectEngine& o) {
        return o.engine.value == engine && has_all(t, object, o);
      });
    });
  }
  return result;
}

void choose_type(Translation& t) {
  GraphSpec& spec = t.result.spec;
  const Span whole{spec.file, 0, 0, 0};
  EntitySpec& engine = spec.engine;
  engine.name = {"engine", whole};
  if (t.saved.engine_id) {
    YamlValue none;
    none.kind = YamlKind::map;
    const Entity* entity = t.mapping.find(*t.saved.engine_id, none, Use::engine, "the engine");
    if (entity != nullptr) engine.type = {entity->id.value, t.saved.engine_id->span};
    return;
  }
  const std::vector<std::string> known = common_engines(t);
  if (!known.empty()) {
    engine.type = {known.front(), whole};
    t.result.remarks["engine"] = known.size() == 1 ? "the only engine that has all of its objects"
                                                   : "the first engine that has all of its objects";
    auto& note = t.diagnostics.note(whole, fmt::format("the file has no engine: `{}` is taken, {}",
                                                       known.front(), t.result.remarks["engine"]));
    if (known.size() > 1) {
      note.help =
          fmt::format("to choose another: `--engine`: {}", join(std::span(known).subspan(1), ", "));
    }
    return;
  }
  auto& problem = t.diagnostics.error(
      "E0804", whole, "the file has no engine, and no engine has all of its objects");
  for (const auto& object : spec.objects) {
    const Entity* entity = t.mapping.library().find(object.type.value);
    std::vector<std::string> engines;
    for (const auto& implementation : entity->object_engines)
      engines.push_back(implementation.engine.value);
    problem.notes.push_back(
        {fmt::format("`{}` is made for {}", object.name.value,
                     engines.empty() ? "none" : fmt::format("{}", join(engines, ", "))),
         object.type.span, ""});
  }
  problem.help = "implement them for a common engine in their manifests";
}

/// `--engine`: another engine has other parameters and states, so it takes its defaults.
void take_option(Translation& t) {
  EntitySpec& engine = t.result.spec.engine;
  const std::vector<std::string> known = t.mapping.library().ids(EntityKind::engine);
  if (!contains(known, t.options.engine)) {
    t.diagnostics.error("E0303", {}, fmt::format("unknown engine `{}`", t.options.engine)).help =
        suggestion(t.options.engine, known);
    return;
  }
  if (engine.type.value == t.options.engine) return;
  if (engine.name.value.empty()) engine.name = {"engine", {t.result.spec.file, 0, 0, 0}};
  engine.type = {t.options.engine, {}};
  engine.config.clear();
  engine.states.clear();
  t.result.remarks["engine"] = "from --engine";
}

/// The rate of a sensor or actuator in the file.
std::optional<Rational> port_rate(const Translation& t, const SavedEnd& end) {
  const SavedEntity* entity = t.saved.find(end.entity);
  const SavedPort* port = entity != nullptr ? entity->port(end.section, end.port) : nullptr;
  const YamlValue* rate = port != nullptr ? port->find("rate") : nullptr;
  // The reader of entities has reported what is no rate.
  return rate != nullptr && rate->is_scalar() ? meant_number(*rate) : std::nullopt;
}

/// The fastest engine node; each ticks at the rate of a sensor or actuator.
std::optional<Rational> fastest_engine_node(const Translation& t) {
  std::optional<Rational> fastest;
  for (const auto& entity : t.saved.entities) {
    for (const char* section : {"sensors", "actuators"}) {
      const auto ports = entity.ports.find(section);
      if (entity.kind != SavedEntity::Kind::object || ports == entity.ports.end()) continue;
      for (const auto& port : ports->second) {
        if (!entity.is_selected(section, port.name.value)) continue;
        const auto rate = port_rate(t, {entity.name.value, section, port.name.value, {}});
        if (rate && (!fastest || *rate > *fastest)) fastest = rate;
      }
    }
  }
  return fastest;
}

void choose_engine_rate(Translation& t) {
  EntitySpec& engine = t.result.spec.engine;
  const Span whole{t.result.spec.file, 0, 0, 0};
  if (t.options.engine_rate_hz) {
    engine.rate = QuantitySpec{*t.options.engine_rate_hz, {}};
    t.result.remarks["engine.rate"] = "from --engine-rate";
    return;
  }
  if (engine.rate) return;
  const auto fastest = fastest_engine_node(t);
  if (!fastest) {
    t.diagnostics.error("E0804", whole, "the file has no rate for the engine").help =
        "give it with `--engine-rate`";
    return;
  }
  engine.rate = QuantitySpec{*fastest, whole};
  t.result.remarks["engine.rate"] = "that of the fastest sensor or actuator";
  t.diagnostics
      .note(whole, fmt::format("the file has no rate for the engine: {} Hz is taken, {}",
                               fastest->to_string(), t.result.remarks["engine.rate"]))
      .help = "choose another with `--engine-rate`";
}

/// The rate at which an end of a connection sends or takes.
std::optional<Rational> rate_of(const Translation& t, const SavedEnd& end) {
  const SavedEntity* entity = t.saved.find(end.entity);
  if (entity == nullptr) return std::nullopt;
  if (entity->kind == SavedEntity::Kind::object) return port_rate(t, end);
  const YamlValue* rate = entity->parameter("rate");
  return rate != nullptr && rate->is_scalar() ? meant_number(*rate) : std::nullopt;
}

}  // namespace

void choose_engine(Translation& t) {
  if (!t.options.engine.empty()) {
    take_option(t);
  } else if (t.result.spec.engine.type.value.empty()) {
    choose_type(t);
  }
  if (!t.result.spec.engine.type.value.empty()) choose_engine_rate(t);
}

void choose_rate(Translation& t) {
  Spanned<Rational>& rate = t.result.spec.rate;
  const SavedEntity& environment = *t.saved.find("environment");
  const Span whole{t.result.spec.file, 0, 0, 0};
  if (t.options.rate_hz) {
    rate = {*t.options.rate_hz, whole};
    t.result.remarks["rate"] = "from --rate";
    return;
  }
  if (const YamlValue* saved = environment.parameter("rate")) {
    if (const auto value = saved_rate(*saved, t.diagnostics)) rate = {*value, saved->span};
    return;
  }
  std::optional<Rational> fastest;
  const char* reason = "the fastest rate of what it observes and acts on";
  for (const auto& link : t.saved.links) {
    const bool acts = link.from.entity == "environment";
    if (!acts && link.to.entity != "environment") continue;
    const auto other = rate_of(t, acts ? link.to : link.from);
    if (other && link.to.section == "feedthroughs") {
      fastest = other;  // give the reset node the rate of what it passes on
      reason = "that of the reset node that passes its actions on";
      break;
    }
    if (other && (!fastest || *other > *fastest)) fastest = other;
  }
  if (!fastest) {
    t.diagnostics.error("E0804", whole, "the file has no rate for the environment").help =
        "give it with `--rate`";
    return;
  }
  rate = {*fastest, whole};
  t.result.remarks["rate"] = reason;
  if (t.diagnostics.has_errors() || t.mapping.any_missing()) return;
  t.diagnostics
      .note(whole, fmt::format("the file has no rate for the environment: {} Hz is taken, {}",
                               fastest->to_string(), t.result.remarks["rate"]))
      .help = "choose another with `--rate`";
}

}  // namespace eagerx::gen

#include "generator/frontend/import/entity_mapping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "generator/frontend/import/translate.hpp"
#include "generator/frontend/import/written.hpp"
#include "generator/frontend/read/scalar.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// Keys that EAGERx writes for every entity, and those for its Python processes.
constexpr std::array kAlways = {"name",
                                "rate",
                                "process",
                                "color",
                                "log_level",
                                "entity_id",
                                "inputs",
                                "outputs",
                                "states",
                                "log_level_memory",
                                "sensors",
                                "actuators",
                                "targets",
                                "feedthroughs",
                                "executable",
                                "sync",
                                "node_names",
                                "simulate_delays",
                                "real_time_factor",
                                "target_addresses",
                                "processor_type",
                                "state_type"};

/// The names of the second list that the first has not, and the other way round.
template <class A, class B>
std::string differing(const A& saved, const B& ours, const char* what) {
  std::vector<std::string> names;
  for (const auto& name : saved) {
    if (!contains(ours, name)) names.push_back(name);
  }
  for (const auto& name : ours) {
    if (!contains(saved, name)) names.push_back(name);
  }
  return names.empty() ? std::string() : fmt::format("{} (`{}`)", what, join(names, "`, `"));
}

bool is_condition(const Entity& entity, std::string_view name) {
  return ranges::any_of(entity.eagerx_ids, [&](const EagerxId& eagerx) {
    return ranges::any_of(eagerx.when, [&](const Setting& s) { return s.name == name; });
  });
}

/// Differences between the interface of a class in a file and that of our entity; empty: none.
std::string difference(const Entity& entity, const SavedEntity& saved) {
  for (const auto& entry : saved.config.entries) {
    const bool known = ranges::contains(entity.config, entry.key, &Parameter::eagerx) ||
                       ranges::contains(kAlways, entry.key) || is_condition(entity, entry.key);
    if (!known) return fmt::format("parameters (`{}`)", entry.key);
  }
  // Parameters that the class lacks keep our default.
  for (const auto& parameter : entity.config) {
    if (!parameter.fallback && saved.config.find(parameter.eagerx) == nullptr)
      return fmt::format("parameters (`{}`)", parameter.name.value);
  }
  if (entity.kind == EntityKind::processor) return {};  // it has no ports of its own
  for (const auto& [section, ports] : {std::pair{"inputs", &entity.inputs},
                                       {"outputs", &entity.outputs},
                                       {"states", &entity.states},
                                       {"targets", &entity.reset_targets},
                                       {"sensors", &entity.sensors},
                                       {"actuators", &entity.actuators}}) {
    const auto found = saved.ports.find(section);
    const auto names =
        found == saved.ports.end() ? std::vector<std::string>() : names_of(found->second);
    if (auto text = differing(names, names_of(*ports), section); !text.empty()) return text;
    for (const PortManifest& port : *ports) {
      const auto space = saved_space(*saved.port(section, port.name.value));
      if (!space || port.space.like || !port.space.dtype || !port.space.shape) continue;
      const bool bounded = port.space.low || port.space.high;
      if (missing_of(*space, port.space) || (bounded && !same_space(*space, port.space)))
        return fmt::format("spaces (`{}`)", port.name.value);
    }
  }
  return {};
}

bool is_kind(const Entity& entity, Use use) {
  switch (use) {
    case Use::engine:
      return entity.kind == EntityKind::engine;
    case Use::object:
      return entity.kind == EntityKind::object;
    case Use::processor:
      return entity.kind == EntityKind::processor;
    case Use::engine_node:
      return entity.kind == EntityKind::engine_node;
    case Use::engine_state:
      return entity.kind == EntityKind::engine_state;
    case Use::node:
      break;
  }
  // Whatever else may stand under `nodes:`.
  static constexpr std::array kOthers = {EntityKind::engine, EntityKind::object,
                                         EntityKind::processor, EntityKind::engine_node,
                                         EntityKind::engine_state};
  return !ranges::contains(kOthers, entity.kind);
}

/// Scripts share the name of their module, so the name identifies none of them.
bool is_of_script(const std::string& id) {
  return id.starts_with("__main__/");
}

bool holds(const std::vector<Setting>& when, const YamlValue& config) {
  return ranges::all_of(when, [&](const Setting& setting) {
    const YamlValue* value = config.find(setting.name);
    return value != nullptr ? same_value(setting.value, *value) : setting.value.is_null();
  });
}

/// Python takes [0], and [0, 0] for all joints alike, where ours takes 0; and a list of names where
/// ours takes a text.
YamlValue value_of(Parameter::Type type, const YamlValue& saved) {
  const bool list = type == Parameter::Type::integers || type == Parameter::Type::numbers;
  if (list || !saved.is_sequence() || saved.items.empty()) return saved;
  if (type == Parameter::Type::text) {
    const auto names = joined_names(saved);
    return names ? made_scalar(*names, saved.span) : saved;
  }
  const bool alike = ranges::all_of(
      saved.items, [&](const YamlValue& item) { return same_value(item, saved.items[0]); });
  return alike ? saved.items[0] : saved;
}

std::string class_of(const std::string& id) {
  return id.substr(id.rfind('/') + 1);
}

/// An entity that stands for a class of the same name in another module, if there is one.
std::pair<const Entity*, std::string> namesake(const Library& library, const std::string& id,
                                               Use use) {
  for (const auto& [name, entity] : library.all_entities()) {
    for (const auto& eagerx : entity.eagerx_ids) {
      if (is_kind(entity, use) && eagerx.id.value != id &&
          class_of(eagerx.id.value) == class_of(id))
        return {&entity, eagerx.id.value};
    }
  }
  return {nullptr, ""};
}

/// The same class with other ports, or other spaces of them: what its users do not share is left
/// open.
void widen(SavedEntity& known, const SavedEntity& other) {
  for (const auto& [section, ports] : other.ports) {
    for (const auto& port : ports) {
      auto& mine = known.ports[section];
      const auto found = ranges::find(
          mine, port.name.value, [](const SavedPort& p) { return std::string_view(p.name.value); });
      if (found == mine.end()) {
        mine.push_back(port);
        continue;
      }
      const YamlValue* a = found->find("space");
      const YamlValue* b = port.find("space");
      if (a == nullptr || b == nullptr || same_value(*a, *b)) continue;
      found->has_spaces_apart = true;
      for (auto& entry : found->settings.entries) {
        if (entry.key != "space") continue;
        std::erase_if(entry.value.entries, [&](const YamlValue::Entry& e) {
          return e.key != "dtype" || b->find("dtype") == nullptr ||
                 !same_value(e.value, *b->find("dtype"));
        });
      }
    }
  }
}

}  // namespace

const char* to_string(Use use) {
  static constexpr std::array kNames = {"engine",    "node",        "object",
                                        "processor", "engine node", "engine state"};
  return kNames.at(static_cast<std::size_t>(use));
}

bool is_common_parameter(std::string_view name) {
  return ranges::contains(kAlways, name);
}

bool same_value(const YamlValue& a, const YamlValue& b) {
  if (a.is_sequence() && a.items.size() == 1 && b.is_scalar()) return same_value(a.items[0], b);
  if (b.is_sequence() && b.items.size() == 1 && a.is_scalar()) return same_value(a, b.items[0]);
  if (a.kind != b.kind || a.items.size() != b.items.size() ||
      a.entries.size() != b.entries.size() || is_python_object(a) != is_python_object(b))
    return false;
  for (std::size_t i = 0; i < a.items.size(); ++i) {
    if (!same_value(a.items[i], b.items[i])) return false;
  }
  for (const auto& entry : a.entries) {
    const YamlValue* other = b.find(entry.key);
    if (other == nullptr || !same_value(entry.value, *other)) return false;
  }
  if (!a.is_scalar()) return true;
  const auto left = a.quoted ? std::nullopt : parse_number(a.text);
  const auto right = b.quoted ? std::nullopt : parse_number(b.text);
  return left && right ? *left == *right : a.text == b.text;
}

EntityMapping::Choice EntityMapping::choose(const std::string& id, const YamlValue& config,
                                            Use use) const {
  Choice choice;
  std::size_t conditions = 0;
  for (const auto& [name, entity] : library_.all_entities()) {
    for (const auto& eagerx : entity.eagerx_ids) {
      if (eagerx.id.value != id || !is_kind(entity, use)) continue;
      choice.known = true;
      if (!holds(eagerx.when, config)) continue;
      // A script's class is what its user says it is.
      if (is_of_script(id) && choice.best != nullptr && choice.best->own != entity.own) {
        if (entity.own) choice = {&entity, true, false};
        if (entity.own) conditions = eagerx.when.size();
        continue;
      }
      const bool first = choice.best == nullptr;
      // The one that says most of the parameters.
      if (!first && eagerx.when.size() < conditions) continue;
      choice.ambiguous = !first && eagerx.when.size() == conditions && choice.best != &entity;
      if (choice.ambiguous) continue;
      choice.best = &entity;
      conditions = eagerx.when.size();
    }
  }
  return choice;
}

const Entity* EntityMapping::look_up(const std::string& id, const YamlValue& config,
                                     Use use) const {
  return choose(id, config, use).best;
}

const Entity* EntityMapping::find(const Spanned<std::string>& id, const YamlValue& config, Use use,
                                  const std::string& user) {
  const Choice choice = choose(id.value, config, use);
  if (choice.best == nullptr) {
    Missing& missing = missing_[id.value];
    missing.use = use;
    missing.other_parameters = choice.known;
    const auto first = [](const auto& other) -> const auto& {
      return other.first;
    };
    if (!ranges::contains(missing.users, user, first)) missing.users.emplace_back(user, id.span);
  } else if (choice.ambiguous) {
    diagnostics_
        .error("E0801", id.span, fmt::format("more than one entity stands for `{}`", id.value))
        .help = fmt::format("one of them is `{}`: tell them apart with `when:` in their manifests",
                            choice.best->id.value);
  }
  return choice.best;
}

const Entity* EntityMapping::require(const SavedEntity& saved, Use use, const std::string& user) {
  const Entity* known = look_up(saved.id.value, saved.config, use);
  if (known != nullptr) return known;
  find(saved.id, saved.config, use, user);
  Missing& missing = missing_.at(saved.id.value);
  if (missing.saved.id.value.empty()) {
    missing.saved = saved;
  } else {
    widen(missing.saved, saved);
  }
  return nullptr;
}

bool EntityMapping::may_stand_in(const Entity& entity, const SavedEntity& saved,
                                 const std::string& user) {
  const std::string& id = saved.id.value;
  if (!is_of_script(id) || entity.own) return true;
  const std::string where = difference(entity, saved);
  const std::string text =
      where.empty() ? fmt::format(
                          "{} is a class of a script, `{}`: `{}` stands in for it, as it has the "
                          "same {}parameters",
                          user, id, entity.id.value,
                          entity.kind == EntityKind::processor ? "" : "ports, spaces and ")
                    : fmt::format(
                          "{} is a class of a script, `{}`, and another one than `{}`, which has "
                          "other {}",
                          user, id, entity.id.value, where);
  if (!reported_.insert(text).second) return where.empty();  // of another connection of an action
  if (where.empty()) {
    diagnostics_.warning("E0806", saved.id.span, text).help = fmt::format(
        "compare the script with `eagerx-gen info {}`; an entity of yours with `eagerx: [{}]`, in "
        "a folder of `--path`, is taken in its place",
        entity.id.value, id);
    return true;
  }
  diagnostics_.error("E0801", saved.id.span, text).help = fmt::format(
      "write an entity with `eagerx: [{}]` in its manifest.yaml, give its folder with `--path`, "
      "and name it differently",
      id);
  return false;
}

bool EntityMapping::knows(const std::string& id) const {
  return ranges::any_of(library_.all_entities(),
                        [&](const auto& item) { return stands_for(item.second, id); });
}

bool EntityMapping::stands_for(const Entity& entity, const std::string& id) {
  return ranges::any_of(entity.eagerx_ids,
                        [&](const EagerxId& eagerx) { return eagerx.id.value == id; });
}

std::vector<Setting> EntityMapping::settings(const Entity& entity, const YamlValue& config,
                                             const std::string& user) {
  std::vector<Setting> result;
  std::vector<std::string> taken;
  for (const auto& parameter : entity.config) {
    taken.push_back(parameter.eagerx);
    const auto entry = ranges::find(config.entries, parameter.eagerx, &YamlValue::Entry::key);
    if (entry == config.entries.end() || entry->value.is_null() ||
        is_condition(entity, parameter.eagerx))
      continue;
    if (is_python_object(entry->value)) {
      diagnostics_
          .error("E0803", entry->value.span,
                 fmt::format("`{}` of {} is a Python object, `{}`", entry->key, user,
                             entry->value.text))
          .help = "save the graph with a plain number, text or list in its place";
      continue;
    }
    YamlValue value = value_of(parameter.type, entry->value);
    if (parameter.fallback && same_value(*parameter.fallback, value)) continue;
    result.push_back({parameter.name.value, entry->key_span, std::move(value)});
  }
  for (const auto& eagerx : entity.eagerx_ids) {
    for (const auto& condition : eagerx.when) taken.push_back(condition.name);
  }
  std::vector<std::string> unknown;
  Span span;
  for (const auto& entry : config.entries) {
    if (entry.value.is_null() || contains(taken, entry.key) || ranges::contains(kAlways, entry.key))
      continue;
    if (unknown.empty()) span = entry.key_span;
    unknown.push_back(entry.key);
  }
  if (!unknown.empty()) {
    diagnostics_.note(span, fmt::format("`{}` of {} {} left out: `{}` has no such parameter",
                                        join(unknown, "`, `"), user,
                                        unknown.size() == 1 ? "is" : "are", entity.id.value));
  }
  return result;
}

std::optional<ProcessorSpec> EntityMapping::processor(const SavedPort& port,
                                                      const std::string& user) {
  const YamlValue* saved = port.find("processor");
  if (saved == nullptr) return std::nullopt;
  const YamlValue* type = saved->find("processor_type");
  if (type == nullptr || !type->is_scalar()) {
    diagnostics_.error("E0802", saved->span,
                       fmt::format("the processor of {} has no `processor_type`", user));
    return std::nullopt;
  }
  // The parameters stand next to the type, or under `config`.
  const YamlValue* config = saved->find("config");
  const YamlValue& parameters = config != nullptr && config->is_map() ? *config : *saved;
  const Entity* entity =
      find({type->text, type->span}, parameters, Use::processor, "the processor of " + user);
  if (entity == nullptr) return std::nullopt;
  SavedEntity as_saved;
  as_saved.id = {type->text, type->span};
  as_saved.config = parameters;
  if (!may_stand_in(*entity, as_saved, "the processor of " + user)) return std::nullopt;
  return ProcessorSpec{{entity->id.value, type->span},
                       settings(*entity, parameters, "the processor of " + user)};
}

void EntityMapping::report_missing() {
  for (const auto& [id, missing] : missing_) {
    const auto& [user, span] = missing.users.front();
    auto& problem = diagnostics_.error(
        "E0801", span,
        missing.other_parameters
            ? fmt::format("`{}` has no counterpart in C++ for these parameters", id)
            : fmt::format("`{}` has no counterpart in C++", id));
    problem.label = fmt::format("used by {}", user);
    constexpr std::size_t kMostUsers = 8;
    for (std::size_t i = 1; i < std::min(missing.users.size(), kMostUsers); ++i)
      problem.notes.push_back(
          {fmt::format("used by {} too", missing.users[i].first), missing.users[i].second, ""});
    const auto [other, other_id] = namesake(library_, id, missing.use);
    problem.help = fmt::format(
        "write {} {} with `eagerx: [{}]` in its manifest.yaml, and give its folder with `--path`",
        missing.use == Use::node || missing.use == Use::processor ? "a" : "an",
        to_string(missing.use), id);
    if (other != nullptr) {
      problem.help += fmt::format("\n`{}` stands for `{}`: if that is the same, add `{}` to it",
                                  other->id.value, other_id, id);
    }
  }
}

}  // namespace eagerx::gen

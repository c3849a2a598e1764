#include "generator/frontend/import/saved.hpp"

#include <fmt/format.h>

#include <array>

#include "generator/frontend/spec/named.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

constexpr std::array kSections = {"inputs",    "outputs", "states",      "sensors",
                                  "actuators", "targets", "feedthroughs"};

/// Replaces `$(config x)` by that parameter, in a file as a whole no more often than is sensible: a
/// long list of references to a long list would otherwise grow without limit.
class Substitution {
 public:
  YamlValue run(YamlValue value, const YamlValue& config) {
    for (auto& item : value.items) item = run(std::move(item), config);
    for (auto& entry : value.entries) entry.value = run(std::move(entry.value), config);
    const auto reference = value.is_scalar() ? parse_reference(value.text) : std::nullopt;
    if (!reference || reference->what != "config" || !reference->part.empty()) return value;
    if (!spend(searches_, config.entries.size())) return value;
    const YamlValue* found = config.find(reference->name);
    return found != nullptr && afford(*found) ? *found : value;
  }

 private:
  static bool spend(std::size_t& left, std::size_t cost) {
    const bool enough = cost <= left;
    left -= enough ? cost : left;
    return enough;
  }

  bool afford(const YamlValue& yaml) {
    constexpr std::size_t kTextOfAValue = 64;
    return spend(values_, 1 + yaml.text.size() / kTextOfAValue) &&
           ranges::all_of(yaml.items, [&](const YamlValue& item) { return afford(item); }) &&
           ranges::all_of(yaml.entries,
                          [&](const YamlValue::Entry& entry) { return afford(entry.value); });
  }

  std::size_t searches_ = 50'000'000;  // entries looked at
  std::size_t values_ = 300'000;       // copied
};

class SavedReader {
 public:
  SavedReader(const YamlValue& root, Diagnostics& diagnostics)
      : root_(root), diagnostics_(diagnostics) {}

  std::optional<SavedGraph> read() {
    const std::size_t errors_before = diagnostics_.error_count();
    saved_.file = root_.span.file;
    for (const char* key : {"nodes", "connects"}) {
      if (root_.find(key) == nullptr)
        fail(root_.span, fmt::format("`{}` is missing: is the file cut off?", key));
    }
    if (diagnostics_.error_count() != errors_before) return std::nullopt;
    read_entities(member(root_, "nodes"), saved_.entities);
    if (const YamlValue* backup = root_.find("backup"); backup != nullptr && backup->is_map())
      read_backup(*backup);
    read_links(*root_.find("connects"));
    const YamlValue* engine = root_.find("engine_id");
    if (engine != nullptr && engine->is_scalar()) saved_.engine_id = {engine->text, engine->span};
    if (saved_.find("environment") == nullptr && diagnostics_.error_count() == errors_before)
      fail(member(root_, "nodes").span, "the graph has no node `environment`");
    if (diagnostics_.error_count() != errors_before) return std::nullopt;
    return std::move(saved_);
  }

 private:
  void fail(Span span, std::string message) {
    diagnostics_.error("E0802", span, std::move(message)).help =
        "this is not a file that EAGERx's Graph.save or BaseEnv.save wrote";
  }

  /// The mapping under `key`; reported and empty if it is something else.
  const YamlValue& member(const YamlValue& map, const char* key) {
    static const YamlValue kEmpty = [] {
      YamlValue yaml;
      yaml.kind = YamlKind::map;
      return yaml;
    }();
    const YamlValue* value = map.find(key);
    if (value == nullptr || value->is_null()) return kEmpty;
    if (value->is_map()) return *value;
    fail(value->span, fmt::format("expected a mapping for `{}`, found {}", key, describe(*value)));
    return kEmpty;
  }

  void read_entities(const YamlValue& nodes, std::vector<SavedEntity>& into) {
    for (const auto& entry : nodes.entries) {
      if (auto entity = read_entity(entry)) into.push_back(std::move(*entity));
    }
  }

  /// Objects; of everything else the nodes themselves say more.
  void read_backup(const YamlValue& backup) {
    for (const auto& entry : backup.entries) {
      if (!entry.value.is_map()) continue;
      if (entry.value.find("entity_type") == nullptr) {
        note_processors(entry);
        continue;
      }
      if (auto entity = read_entity(entry)) saved_.backup.push_back(std::move(*entity));
    }
  }

  void note_processors(const YamlValue::Entry& node) {
    const YamlValue* inputs = node.value.find("inputs");
    if (inputs == nullptr || !inputs->is_map()) return;
    for (const auto& input : inputs->entries) {
      const YamlValue* processor = input.value.is_map() ? input.value.find("processor") : nullptr;
      if (processor != nullptr && !processor->is_null())
        saved_.processors_when_added.insert(fmt::format("{}.{}", node.key, input.key));
    }
  }

  std::optional<SavedEntity> read_entity(const YamlValue::Entry& entry) {
    const YamlValue& yaml = entry.value;
    if (!yaml.is_map()) {
      fail(yaml.span, fmt::format("expected a mapping for the node `{}`, found {}", entry.key,
                                  describe(yaml)));
      return std::nullopt;
    }
    SavedEntity entity;
    entity.name = {entry.key, entry.key_span};
    entity.config = plain_values(member(yaml, "config"));
    entity.kind = kind_of(entry.key, yaml);
    const char* type = entity.kind == SavedEntity::Kind::object ? "entity_type" : "node_type";
    const YamlValue* id = entity.config.find("entity_id");
    if (id == nullptr || !id->is_scalar()) id = yaml.find(type);
    if (id == nullptr || !id->is_scalar()) {
      fail(entry.key_span, fmt::format("the node `{}` has no `entity_id`", entry.key));
      return std::nullopt;
    }
    entity.id = {id->text, id->span};
    for (const char* section : kSections) {
      read_ports(yaml, section, entity);
      entity.selected[section] = texts(entity.config.find(section));
    }
    // Feedthroughs are selected with the outputs that they are for.
    entity.selected["feedthroughs"] = entity.selected["outputs"];
    if (entity.kind == SavedEntity::Kind::engine) read_objects(member(yaml, "objects"), entity);
    return entity;
  }

  static SavedEntity::Kind kind_of(const std::string& name, const YamlValue& yaml) {
    if (yaml.find("entity_type") != nullptr) return SavedEntity::Kind::object;
    if (name == "environment") return SavedEntity::Kind::environment;
    return name == "engine" ? SavedEntity::Kind::engine : SavedEntity::Kind::node;
  }

  void read_ports(const YamlValue& yaml, const char* section, SavedEntity& entity) {
    for (const auto& entry : member(yaml, section).entries) {
      if (!entry.value.is_map()) {
        fail(entry.value.span,
             fmt::format("expected a mapping for `{}.{}.{}`, found {}", entity.name.value, section,
                         entry.key, describe(entry.value)));
        continue;
      }
      entity.ports[section].push_back(
          {{entry.key, entry.key_span},
           substitution_.run(plain_values(entry.value), entity.config)});
    }
  }

  std::vector<Spanned<std::string>> texts(const YamlValue* list) {
    std::vector<Spanned<std::string>> result;
    // An empty Python dict where a list is meant: EngineSpec.add_object without engine nodes.
    const bool empty = list != nullptr && list->is_map() && list->entries.empty();
    if (list == nullptr || list->is_null() || empty) return result;
    if (!list->is_sequence()) {
      fail(list->span, fmt::format("expected a list of names, found {}", describe(*list)));
      return result;
    }
    for (const auto& item : list->items) {
      const bool twice = ranges::contains(result, item.text, &Spanned<std::string>::value);
      if (item.is_scalar() && twice) {
        fail(item.span, fmt::format("`{}` is listed twice", item.text));
      } else if (item.is_scalar()) {
        result.push_back({item.text, item.span});
      } else {
        fail(item.span, fmt::format("expected a name, found {}", describe(item)));
      }
    }
    return result;
  }

  void read_objects(const YamlValue& objects, const SavedEntity& engine) {
    for (const auto& entry : objects.entries) {
      if (!entry.value.is_map()) {
        fail(entry.value.span, fmt::format("expected a mapping for the object `{}`, found {}",
                                           entry.key, describe(entry.value)));
        continue;
      }
      SavedObject object;
      object.name = {entry.key, entry.key_span};
      object.parameters = plain_values(member(entry.value, "add_object"));
      for (const auto& state : member(entry.value, "engine_states").entries) {
        object.states.push_back({state.key, state.key_span});
        object.engine_states.push_back({{state.key, state.key_span}, plain_values(state.value)});
      }
      object.nodes = texts(entry.value.find("nodes"));
      saved_.objects.push_back(std::move(object));
    }
    constexpr std::string_view kSupervisor = "/supervisor";
    for (const auto& name : texts(engine.config.find("node_names"))) {
      if (name.value.ends_with(kSupervisor))
        saved_.env_name = name.value.substr(0, name.value.size() - kSupervisor.size());
    }
  }

  void read_links(const YamlValue& connects) {
    if (!connects.is_sequence() && !connects.is_null())
      fail(connects.span,
           fmt::format("expected a list of connections, found {}", describe(connects)));
    for (const auto& written : connects.items) {
      const YamlValue item = plain_values(written);
      const bool pair = item.is_sequence() && item.items.size() == 2;
      const auto from = pair ? end_of(item.items[0]) : std::nullopt;
      const auto to = pair ? end_of(item.items[1]) : std::nullopt;
      if (from && to) {
        saved_.links.push_back({*from, *to});
      } else {
        fail(written.span, "expected a source and a target, each [node, kind, name]");
      }
    }
  }

  static std::optional<SavedEnd> end_of(const YamlValue& yaml) {
    if (!yaml.is_sequence() || yaml.items.size() != 3) return std::nullopt;
    for (const auto& item : yaml.items) {
      if (!item.is_scalar()) return std::nullopt;
    }
    return SavedEnd{yaml.items[0].text, yaml.items[1].text, yaml.items[2].text, yaml.items[2].span};
  }

  const YamlValue& root_;
  Diagnostics& diagnostics_;
  Substitution substitution_;
  SavedGraph saved_;
};

}  // namespace

const YamlValue* SavedPort::find(std::string_view key) const {
  const YamlValue* value = settings.find(key);
  return value == nullptr || value->is_null() ? nullptr : value;
}

const SavedPort* SavedEntity::port(std::string_view section, std::string_view wanted) const {
  const auto found = ports.find(section);
  if (found == ports.end()) return nullptr;
  return find_named(found->second, wanted);
}

bool SavedEntity::is_selected(std::string_view section, std::string_view wanted) const {
  const auto found = selected.find(section);
  return found != selected.end() &&
         ranges::contains(found->second, wanted, &Spanned<std::string>::value);
}

const YamlValue* SavedEntity::parameter(std::string_view key) const {
  const YamlValue* value = config.find(key);
  return value == nullptr || value->is_null() ? nullptr : value;
}

const SavedEntity* SavedGraph::find(std::string_view name) const {
  return find_named(entities, name);
}

const SavedObject* SavedGraph::owner_of(std::string_view node) const {
  for (const auto& object : objects) {
    if (node.starts_with(object.name.value + "/")) return &object;
  }
  return nullptr;
}

bool SavedGraph::flattened() const {
  return find("engine") != nullptr;
}

std::optional<SavedGraph> read_saved_graph(const YamlValue& root, Diagnostics& diagnostics) {
  return SavedReader(root, diagnostics).read();
}

}  // namespace eagerx::gen

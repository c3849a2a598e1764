// Requirements of a file, before it is converted: one run reports everything that is missing.
#include <fmt/format.h>

#include "generator/frontend/import/entity_mapping.hpp"
#include "generator/frontend/import/translate.hpp"
#include "generator/frontend/spec/named.hpp"

namespace eagerx::gen {
namespace {

class Requirements {
 public:
  Requirements(const SavedGraph& saved, EntityMapping& mapping)
      : saved_(saved), mapping_(mapping) {}

  void run() {
    for (const auto& object : saved_.objects) {
      if (!is_whole(object)) inside(object);
    }
    for (const auto& entity : saved_.entities) entity_of_graph(entity);
  }

 private:
  void entity_of_graph(const SavedEntity& entity) {
    const std::string& name = entity.name.value;
    if (saved_.owner_of(name) != nullptr) return;
    switch (entity.kind) {
      case SavedEntity::Kind::engine:
        mapping_.require(entity, Use::engine, "the engine");
        return;
      case SavedEntity::Kind::object:
        mapping_.require(entity, Use::object, fmt::format("the object `{}`", name));
        break;
      case SavedEntity::Kind::node:
        mapping_.require(entity, Use::node, fmt::format("the node `{}`", name));
        break;
      case SavedEntity::Kind::environment:
        break;
    }
    processors(entity);
  }

  /// Whether an object of ours replaces the engine nodes.
  bool is_whole(const SavedObject& object) {
    const SavedEntity* backup = find_named(saved_.backup, object.name.value);
    if (backup == nullptr) return true;  // another problem
    const Entity* entity =
        mapping_.require(*backup, Use::object, fmt::format("the object `{}`", object.name.value));
    const SavedEntity& saved_engine = *saved_.find("engine");
    const Entity* engine =
        mapping_.look_up(saved_engine.id.value, saved_engine.config, Use::engine);
    return entity != nullptr && engine != nullptr && entity->implementation(*engine) != nullptr;
  }

  void inside(const SavedObject& object) {
    for (const auto& entity : saved_.entities) {
      if (saved_.owner_of(entity.name.value) != &object) continue;
      mapping_.require(entity, Use::engine_node,
                       fmt::format("the engine node `{}`", entity.name.value));
      processors(entity);
    }
    for (const auto& state : object.engine_states) {
      const YamlValue* made = state.find("state");
      const YamlValue* type = made != nullptr ? made->find("state_type") : nullptr;
      if (type == nullptr || !type->is_scalar()) continue;
      SavedEntity entity = bare({type->text, type->span}, *made);
      entity.ports["states"].push_back(state);
      mapping_.require(entity, Use::engine_state,
                       fmt::format("the state `{}.{}`", object.name.value, state.name.value));
    }
  }

  void processors(const SavedEntity& entity) {
    for (const auto& [section, ports] : entity.ports) {
      for (const auto& port : ports) {
        const YamlValue* saved = port.find("processor");
        const YamlValue* type = saved != nullptr ? saved->find("processor_type") : nullptr;
        if (type == nullptr || !type->is_scalar() || !entity.is_selected(section, port.name.value))
          continue;
        const YamlValue* config = saved->find("config");
        SavedEntity processor = bare({type->text, type->span},
                                     config != nullptr && config->is_map() ? *config : *saved);
        processor.ports["inputs"].push_back(port);
        mapping_.require(processor, Use::processor,
                         "the processor of " + written(entity, section, port));
      }
    }
  }

  static std::string written(const SavedEntity& entity, const std::string& section,
                             const SavedPort& port) {
    return entity.kind == SavedEntity::Kind::environment && section == "outputs"
               ? fmt::format("the action `{}`", port.name.value)
               : fmt::format("`{}.{}`", entity.name.value, port.name.value);
  }

  static SavedEntity bare(const Spanned<std::string>& id, const YamlValue& parameters) {
    SavedEntity entity;
    entity.id = id;
    entity.config = parameters;
    return entity;
  }

  const SavedGraph& saved_;
  EntityMapping& mapping_;
};

}  // namespace

void require_all(const SavedGraph& saved, EntityMapping& mapping) {
  Requirements(saved, mapping).run();
}

}  // namespace eagerx::gen

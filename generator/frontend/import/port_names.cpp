// Ports have another name here than in EAGERx if the manifest says so (`eagerx: NAME`).
#include <algorithm>
#include <array>

#include "generator/frontend/import/translate.hpp"

namespace eagerx::gen {
namespace {

Use use_of(const SavedGraph& saved, const SavedEntity& entity) {
  if (entity.kind == SavedEntity::Kind::engine) return Use::engine;
  if (entity.kind == SavedEntity::Kind::object) return Use::object;
  return saved.owner_of(entity.name.value) != nullptr ? Use::engine_node : Use::node;
}

void rename(SavedGraph& saved, SavedEntity& entity, const std::string& section,
            const PortManifest& port) {
  const std::string& name = port.name.value;
  for (auto& saved_port : entity.ports[section]) {
    if (saved_port.name.value == port.eagerx) saved_port.name.value = name;
  }
  for (auto& selected : entity.selected[section]) {
    if (selected.value == port.eagerx) selected.value = name;
  }
  for (auto& link : saved.links) {
    for (SavedEnd* end : {&link.from, &link.to}) {
      if (end->entity == entity.name.value && end->section == section && end->port == port.eagerx)
        end->port = name;
    }
  }
}

void rename_all(SavedGraph& saved, SavedEntity& entity, const Entity& ours) {
  for (const auto& [section, ports] : {std::pair{"inputs", &ours.inputs},
                                       {"outputs", &ours.outputs},
                                       {"states", &ours.states},
                                       {"targets", &ours.reset_targets},
                                       {"sensors", &ours.sensors},
                                       {"actuators", &ours.actuators}}) {
    for (const PortManifest& port : *ports) {
      if (port.eagerx != port.name.value && !port.eagerx.empty())
        rename(saved, entity, section, port);
    }
  }
}

}  // namespace

void rename_ports(SavedGraph& saved, const EntityMapping& mapping) {
  for (auto* entities : {&saved.entities, &saved.backup}) {
    for (auto& entity : *entities) {
      const Entity* ours = mapping.look_up(entity.id.value, entity.config, use_of(saved, entity));
      if (ours != nullptr) rename_all(saved, entity, *ours);
    }
  }
}

}  // namespace eagerx::gen

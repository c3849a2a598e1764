#include "generator/frontend/library/library.hpp"

#include "generator/frontend/spec/named.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {

std::string from_global_namespace(const std::string& cpp_name) {
  return cpp_name.starts_with("eagerx::") || cpp_name.starts_with("::") ? cpp_name
                                                                        : "::" + cpp_name;
}

const PortManifest* Entity::input(std::string_view name) const {
  return find_named(inputs, name);
}
const PortManifest* Entity::output(std::string_view name) const {
  return find_named(outputs, name);
}
const PortManifest* Entity::sensor(std::string_view name) const {
  return find_named(sensors, name);
}
const PortManifest* Entity::actuator(std::string_view name) const {
  return find_named(actuators, name);
}
const PortManifest* Entity::state(std::string_view name) const {
  return find_named(states, name);
}

const PortManifest* Entity::reset_target(std::string_view name) const {
  return find_named(reset_targets, name);
}

bool Entity::works_on(const Entity& engine) const {
  const auto has = [&](const std::string& name) { return contains(engines, name); };
  return engines.empty() || has(engine.id.value) || ranges::any_of(engine.runs, has);
}

const ObjectEngine* Entity::implementation(const Entity& engine) const {
  const auto made_for = [&](const std::string& name) -> const ObjectEngine* {
    for (const auto& each : object_engines) {
      if (each.engine.value == name) return &each;
    }
    return nullptr;
  };
  const ObjectEngine* found = made_for(engine.id.value);
  for (std::size_t i = 0; found == nullptr && i < engine.runs.size(); ++i)
    found = made_for(engine.runs[i]);
  return found;
}

std::vector<std::string> Library::ids(EntityKind kind) const {
  std::vector<std::string> result;
  for (const auto& [id, entity] : all_entities()) {
    if (entity.kind == kind) result.push_back(id);
  }
  return result;
}

std::vector<std::string> Library::engines_of_family(const std::string& name) const {
  std::vector<std::string> result;
  if (find(name) != nullptr) return result;
  for (const auto& [id, entity] : all_entities()) {
    if (contains(entity.runs, name)) result.push_back(id);
  }
  return result;
}

std::string_view to_string(EntityKind kind) {
  switch (kind) {
    case EntityKind::node:
      return "node";
    case EntityKind::engine:
      return "engine";
    case EntityKind::engine_node:
      return "engine node";
    case EntityKind::engine_state:
      return "engine state";
    case EntityKind::object:
      return "object";
    case EntityKind::processor:
      return "processor";
  }
  return "";
}

}  // namespace eagerx::gen

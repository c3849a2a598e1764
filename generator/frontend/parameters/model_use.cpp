// An object as a parameter: its model on an engine, and the model's parameters.
#include <fmt/format.h>

#include "generator/frontend/parameters/config.hpp"

namespace eagerx::gen {
namespace {

FormatPtr model_format() {
  return format::one_of(
      "the id of an object, or a mapping with its `type` and `config`",
      {format::record("an object", {{"type", format::name("the id of an object"), true, "its id"},
                                    {"config", config_format(), false, "its parameters"}}),
       format::name("the id of an object")});
}

/// The help for an entity that is not an object for the model's engine: suggests the first one that
/// is.
std::string help_for_model(const Library& library, const Entity& engine) {
  for (const std::string& id : library.ids(EntityKind::object)) {
    if (library.find(id)->implementation(engine) != nullptr)
      return fmt::format("name an object that is made for `{}`, such as `{}`", engine.id.value, id);
  }
  return {};
}

}  // namespace

std::shared_ptr<const ModelUse> read_model(const Library& library, const Parameter& parameter,
                                           const YamlValue& yaml, Diagnostics& diagnostics) {
  if (!check(yaml, *model_format(), diagnostics)) return nullptr;
  const std::size_t errors_before = diagnostics.error_count();
  const YamlValue& type = yaml.is_scalar() ? yaml : *yaml.find("type");
  const Entity* engine = find_entity(library, {parameter.engine, parameter.name.span},
                                     EntityKind::engine, diagnostics);
  const std::string other = engine == nullptr ? "" : help_for_model(library, *engine);
  const Entity* object =
      find_entity(library, {type.text, type.span}, EntityKind::object, diagnostics, other);
  if (object == nullptr || engine == nullptr) return nullptr;
  ModelUse use;
  use.object = object;
  use.implementation =
      find_implementation(library, *object, *engine, type.span, diagnostics, other);
  use.config =
      resolve_config(library, *object, read_config(yaml.find("config")), type.span, diagnostics);
  if (diagnostics.error_count() != errors_before) return nullptr;
  return std::make_shared<const ModelUse>(std::move(use));
}

}  // namespace eagerx::gen

#include "generator/driver/commands/entity_json.hpp"

#include <algorithm>
#include <filesystem>

#include "generator/frontend/read/scalar.hpp"
#include "generator/support/files/paths.hpp"

namespace eagerx::gen {
namespace {

Json json_of(const YamlValue& yaml) {
  if (yaml.is_null()) return nullptr;
  if (yaml.is_sequence()) {
    Json list = Json::list();
    for (const auto& item : yaml.items) list.push_back(json_of(item));
    return list;
  }
  if (yaml.is_map()) {
    Json object = Json::object();
    for (const auto& entry : yaml.entries) object[entry.key] = json_of(entry.value);
    return object;
  }
  if (yaml.quoted) return yaml.text;
  if (const auto whole = parse_int(yaml.text)) return *whole;
  if (const auto number = parse_number(yaml.text)) return *number;
  if (const auto truth = parse_bool(yaml.text)) return *truth;
  return yaml.text;
}

/// Adds what is said, and nothing of what is not.
void add(Json& object, std::string_view name, const std::optional<YamlValue>& value) {
  if (value) object[name] = json_of(*value);
}
void add(Json& object, std::string_view name, const std::string& text) {
  if (!text.empty()) object[name] = text;
}
void add(Json& object, std::string_view name, const std::vector<std::string>& texts) {
  if (!texts.empty()) object[name] = texts;
}

/// Bounds and quantities may be fractions: as the text that messages have.
Json json_of_number(const std::string& text) {
  if (const auto whole = parse_int(text)) return *whole;
  if (const auto value = parse_number(text)) return *value;
  return text;
}

Json json_of(const ConditionNumber& number) {
  return json_of_number(to_string(number));
}

void add(Json& object, std::string_view name, const std::optional<QuantitySpec>& quantity) {
  if (!quantity) return;
  const Rational* number = quantity->number();
  object[name] =
      number != nullptr ? json_of_number(number->to_string()) : json_of(*quantity->expression());
}

Json json_of(const Parameter& parameter) {
  Json json{{"name", parameter.name.value}, {"type", std::string(type_of(parameter))}};
  add(json, "unit", parameter.unit);
  add(json, "about", parameter.about);
  add(json, "default", parameter.fallback);
  if (parameter.low) json["low"] = json_of(*parameter.low);
  if (parameter.high) json["high"] = json_of(*parameter.high);
  add(json, "options", parameter.options);
  add(json, "engine", parameter.engine);
  if (parameter.eagerx != parameter.name.value) add(json, "eagerx", parameter.eagerx);
  if (parameter.tunable) json["tunable"] = parameter.tunes_running ? "running" : "reset";
  return json;
}

Json json_of(const PortManifest& port) {
  Json json{{"name", port.name.value}};
  const SpaceSpec& space = port.space;
  if (space.like) json["like"] = space.like->value;
  if (space.dtype) json["dtype"] = space.dtype->value;
  add(json, "shape", space.shape);
  add(json, "low", space.low);
  add(json, "high", space.high);
  add(json, "unit", port.unit);
  add(json, "about", port.about);
  add(json, "rate", port.rate);
  add(json, "window", port.settings.window);
  add(json, "delay", port.settings.delay);
  add(json, "max_delay", port.settings.max_delay);
  if (skips(port.settings)) json["skip"] = true;
  if (port.optional) json["optional"] = true;
  if (port.tunes_running) json["running"] = true;
  if (port.eagerx != port.name.value) add(json, "eagerx", port.eagerx);
  return json;
}

void add(Json& json, std::string_view name, const std::vector<PortManifest>& ports) {
  for (const auto& port : ports) json[name].push_back(json_of(port));
}

Json json_of(const CppClass& cpp) {
  return {{"class", cpp.name}, {"header", cpp.include}};
}

/// The implementation of an object on one engine.
Json json_of(const ObjectEngine& made) {
  Json json{{"engine", made.engine.value}, {"vectorized", made.vectorized}};
  add(json, "summary", made.summary);
  add(json, "description", made.description);
  if (!made.model.name.empty()) json["model"] = json_of(made.model);
  const auto add_parts = [&](std::string_view name, const std::vector<EntitySpec>& parts) {
    for (const auto& part : parts)
      json[name].push_back({{"name", part.name.value}, {"type", part.type.value}});
  };
  add_parts("nodes", made.nodes);
  add_parts("states", made.states);
  return json;
}

/// A file from the folder that includes are relative to; both may be relative to the working
/// folder.
std::string place_of(const std::string& file, const std::string& root) {
  namespace fs = std::filesystem;
  const fs::path folder = absolute_path(root.empty() ? "." : root).lexically_normal();
  return absolute_path(file).lexically_normal().lexically_relative(folder).generic_string();
}

/// Where the class also calculates with SIMD vectors: true, false, or "some parameters".
Json vectorized_of(const Entity& entity) {
  if (entity.vectorized.empty()) return false;
  const auto constant = holds(entity.vectorized, {});
  return constant ? Json(*constant) : Json("some parameters");
}

}  // namespace

std::string_view kind_of(const Entity& entity) {
  return entity.is_reset_node() ? "reset node" : to_string(entity.kind);
}

std::string_view type_of(const Parameter& parameter) {
  switch (parameter.type) {
    case Parameter::Type::integer:
      return "int";
    case Parameter::Type::number:
      return "float";
    case Parameter::Type::boolean:
      return "bool";
    case Parameter::Type::text:
      return "string";
    case Parameter::Type::keyword:
      return "choice";
    case Parameter::Type::integers:
      return "ints";
    case Parameter::Type::numbers:
      return "floats";
    case Parameter::Type::model:
      return "object of";
  }
  return "";
}

Json entity_json(const Entity& entity) {
  Json json{{"id", entity.id.value},
            {"kind", std::string(kind_of(entity))},
            {"summary", entity.summary},
            {"description", entity.description},
            {"manifest", place_of(entity.path, entity.include_root)}};
  for (const auto& known : entity.eagerx_ids) {
    Json when = Json::object();
    for (const auto& [name, span, value] : known.when) when[name] = json_of(value);
    json["eagerx"].push_back({{"id", known.id.value}, {"when", std::move(when)}});
  }
  if (!entity.cpp.include.empty()) json["cpp"] = json_of(entity.cpp);
  json["vectorized"] = vectorized_of(entity);
  add(json, "engines", entity.engines);
  add(json, "runs", entity.runs);
  if (entity.asynchronous) json["asynchronous"] = true;
  for (const auto& made : entity.object_engines) json["made_for"].push_back(json_of(made));
  for (const auto& parameter : entity.config) json["config"].push_back(json_of(parameter));
  add(json, "sensors", entity.sensors);
  add(json, "actuators", entity.actuators);
  add(json, "inputs", entity.inputs);
  add(json, "outputs", entity.outputs);
  add(json, "states", entity.states);
  add(json, "targets", entity.reset_targets);
  for (const auto& required : entity.requirements)
    json["requires"].push_back({{"that", required.text}, {"because", required.because}});
  add(json, "counts", entity.counts);
  add(json, "moves", entity.moves);
  add(json, "packages", entity.packages);
  if (entity.system) json["system"] = entity.system->value;
  if (entity.family) json["family"] = entity.family->value;
  if (entity.is_composite()) json["composite"] = json_of(*entity.composite);
  return json;
}

Json target_json(const Target& target) {
  Json json{{"id", target.id.value},
            {"kind", "target"},
            {"summary", target.summary},
            {"description", target.description}};
  for (const auto& [name, value] : target.facts) json["facts"][name] = value;
  add(json, "system", target.system);
  add(json, "family", target.family);
  json["vectorized"] = target.vectorized;
  return json;
}

Json library_json(const Library& library) {
  Json json{{"entities", Json::list()}, {"targets", Json::list()}};
  for (const auto& [id, entity] : library.all_entities())
    json["entities"].push_back(entity_json(entity));
  for (const auto& [id, target] : library.all_targets())
    json["targets"].push_back(target_json(target));
  return json;
}

}  // namespace eagerx::gen

#include "generator/frontend/library/schema.hpp"

#include <fmt/format.h>

#include "generator/frontend/spec/graph_spec.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/frontend/spec/schema.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// The member of an object; it is there.
Json& at(Json& json, std::string_view name) {
  return json[name];
}

void set_description(Json& schema, const std::string& about, const std::string& unit) {
  const std::string text = unit.empty() ? about : fmt::format("{} ({})", about, unit);
  if (!text.empty()) schema["description"] = text;
}

/// A number as a parameter takes it: with a unit, where it has one that is read.
Json number_schema(const Parameter& parameter, bool whole) {
  const Unit* unit = find_unit(parameter.unit);
  Json schema;
  if (whole) {
    schema["type"] = "integer";
  } else {
    schema =
        schema_of(*format::number("a number", unit != nullptr ? unit->quantity : Quantity::none));
  }
  if (schema.as<Json::Object>()->front().name != "type") return schema;
  const auto bound = [&](const char* key, const std::optional<ConditionNumber>& value) {
    if (!value) return;
    if (const auto* exact = std::get_if<Rational>(&*value)) {
      schema[key] = exact->to_double();
    } else if (const auto* real = std::get_if<double>(&*value)) {
      schema[key] = *real;
    } else {
      schema[key] = std::get<std::int64_t>(*value);
    }
  };
  bound("minimum", parameter.low);
  bound("maximum", parameter.high);
  return schema;
}

/// `{csv: FILE, column: NAME}`.
Json table_schema() {
  Json file{{"type", "string"}, {"description", "a csv file, from the graph's folder"}};
  Json column{{"type", Json::List{"string", "integer"}},
              {"description", "a column, by its name or its number from 1 on (default: all)"}};
  return Json{{"type", "object"},
              {"properties", Json{{"csv", std::move(file)}, {"column", std::move(column)}}},
              {"required", Json::List{"csv"}},
              {"additionalProperties", false}};
}

/// Of an element of an array: `$(0.5 * index)`, `{each: […]}`.
Json element_schema() {
  const Json computed{{"type", "string"}, {"pattern", "\\$\\("}};
  const Json each{{"type", "object"},
                  {"properties", Json{{"each", Json{{"type", "array"}}}}},
                  {"required", Json::List{"each"}},
                  {"additionalProperties", false}};
  return Json{{"anyOf", Json::List{computed, each}}};
}

Json type_schema(const Library& library, EntityKind kind);

/// An object, by its id or with its `config`.
Json model_schema(const Library& library) {
  const Json type = type_schema(library, EntityKind::object);
  Json written{{"type", "object"},
               {"properties", Json{{"type", type}, {"config", Json{{"type", "object"}}}}},
               {"required", Json::List{"type"}},
               {"additionalProperties", false}};
  return Json{{"anyOf", Json::List{type, std::move(written)}}};
}

Json parameter_schema(const Library& library, const Parameter& parameter) {
  using Is = Parameter::Type;
  Json schema;
  if (parameter.type == Is::boolean) {
    schema["type"] = "boolean";
  } else if (parameter.type == Is::text) {
    schema["type"] = Json::List{"string", "number", "boolean"};
  } else if (parameter.type == Is::keyword) {
    schema["enum"] = parameter.options;
  } else if (parameter.type == Is::model) {
    schema = model_schema(library);
  } else {
    const Json one =
        number_schema(parameter, parameter.type == Is::integer || parameter.type == Is::integers);
    const bool list = parameter.type == Is::integers || parameter.type == Is::numbers;
    schema = one;
    // A single number is a list of one.
    if (list)
      schema =
          Json{{"anyOf", Json::List{one, Json{{"type", "array"}, {"items", one}}, table_schema()}}};
  }
  set_description(schema, parameter.about, parameter.unit);
  return schema;
}

/// `config:` of an entity.
Json config_schema(const Library& library, const Entity& entity) {
  Json properties = Json::object();
  Json required = Json::list();
  for (const Parameter& parameter : entity.config) {
    const Json plain = parameter_schema(library, parameter);
    Json property{{"anyOf", Json::List{plain, element_schema()}}};
    set_description(property, parameter.about, parameter.unit);
    properties[parameter.name.value] = std::move(property);
    if (!parameter.fallback) required.push_back(parameter.name.value);
  }
  const bool any_required = !required.as<Json::List>()->empty();
  Json schema;
  schema["type"] = any_required ? Json("object") : Json(Json::List{"object", "null"});
  schema["additionalProperties"] = false;
  schema["properties"] = std::move(properties);
  if (any_required) schema["required"] = std::move(required);
  return schema;
}

/// A mapping from ports to settings; `list`: or a list of their names.
Json ports_schema(const std::vector<PortManifest>& ports, bool list) {
  Json properties = Json::object();
  for (const PortManifest& port : ports) {
    Json about = Json::object();
    set_description(about, port.about, port.unit);
    properties[port.name.value] = std::move(about);
  }
  Json map;
  map["type"] = Json::List{"object", "null"};
  map["properties"] = std::move(properties);
  map["additionalProperties"] = false;
  if (!list) return map;
  Json names;
  names["type"] = "array";
  if (!ports.empty()) names["items"] = Json{{"enum", names_of(ports)}};
  return Json{{"anyOf", Json::List{names, map}}};
}

/// The ids of a kind, with what they are.
Json type_schema(const Library& library, EntityKind kind) {
  const std::vector<std::string> ids = library.ids(kind);
  std::vector<std::string> summaries;
  summaries.reserve(ids.size());
  for (const std::string& id : ids) summaries.push_back(library.find(id)->summary);
  Json schema;
  schema["enum"] = ids;
  schema["enumDescriptions"] = summaries;
  schema["description"] = fmt::format("the id of a {}", to_string(kind));
  return schema;
}

/// Makes `schema`, of a mapping with `type` and `config`, one of the entities of a kind.
void specialise(Json& schema, const Library& library, EntityKind kind) {
  at(at(schema, "properties"), "type") = type_schema(library, kind);
  Json branches = Json::list();
  for (const std::string& id : library.ids(kind)) {
    const Entity& entity = *library.find(id);
    Json properties;
    properties["config"] = config_schema(library, entity);
    const auto add = [&](const char* key, const std::vector<PortManifest>& ports, bool list) {
      properties[key] = ports_schema(ports, list);
    };
    if (kind == EntityKind::object) {
      add("sensors", entity.sensors, true);
      add("actuators", entity.actuators, true);
    } else if (kind == EntityKind::node) {
      add("inputs", entity.inputs, true);
      add("outputs", entity.outputs, true);
    }
    // Those of a composite are of what is inside.
    if (kind != EntityKind::processor && !entity.is_composite())
      add("states", entity.states, false);
    Json then;
    then["properties"] = std::move(properties);
    const bool needs_config =
        ranges::any_of(entity.config, [](const Parameter& each) { return !each.fallback; });
    if (needs_config) then["required"] = Json::List{"config"};
    const Json is_type = {{"properties", Json{{"type", Json{{"const", id}}}}},
                          {"required", Json::List{"type"}}};
    branches.push_back(Json{{"if", is_type}, {"then", std::move(then)}});
  }
  schema["allOf"] = std::move(branches);
}

/// Calls f for each schema of a key `name`, wherever it is.
template <class F>
void for_each_property(Json& schema, std::string_view name, F&& f) {
  if (auto* members = std::get_if<Json::Object>(&schema.value)) {
    for (JsonMember& member : *members) {
      if (member.name == "properties") {
        for (JsonMember& property : *std::get_if<Json::Object>(&member.value.value)) {
          if (property.name == name) f(property.value);
        }
      }
      for_each_property(member.value, name, f);
    }
  } else if (auto* items = std::get_if<Json::List>(&schema.value)) {
    for (Json& item : *items) for_each_property(item, name, f);
  }
}

/// `processor: NAME`, or with its `config`.
Json processor_schema(const Library& library, const Json& plain) {
  const Json* options = member(&plain, "anyOf");
  Json written = options->as<Json::List>()->front();
  specialise(written, library, EntityKind::processor);
  const Json::List one = {written, type_schema(library, EntityKind::processor)};
  const Json list = {{"type", "array"}, {"minItems", 1}, {"items", Json{{"anyOf", one}}}};
  return Json{{"anyOf", Json::List{one[0], one[1], list}}};
}

}  // namespace

Json graph_schema(const Library& library) {
  Json schema = schema_of(graph_format());
  Json& properties = at(schema, "properties");
  // First: the branches below have properties that may be called so, too.
  std::optional<Json> processor;  // the same everywhere
  for_each_property(schema, "processor", [&](Json& each) {
    if (!processor) processor = processor_schema(library, each);
    const std::string about = text_of(member(&each, "description"));
    each = *processor;
    each["description"] = about;
  });
  specialise(at(properties, "engine"), library, EntityKind::engine);
  specialise(at(at(properties, "objects"), "additionalProperties"), library, EntityKind::object);
  specialise(at(at(properties, "nodes"), "additionalProperties"), library, EntityKind::node);
  return with_extending(std::move(schema));
}

Json manifest_schema() {
  Json branches = Json::list();
  for (const std::string& kind : manifest_kinds()) {
    const Json is_kind = {{"properties", Json{{"kind", Json{{"const", kind}}}}},
                          {"required", Json::List{"kind"}}};
    Json form = schema_of(*manifest_format(kind));
    if (const Format* composite = composite_format(kind)) {
      const Json has_graph = {{"required", Json::List{"graph"}}};
      form = Json{{"if", has_graph}, {"then", schema_of(*composite)}, {"else", std::move(form)}};
    }
    branches.push_back(Json{{"if", is_kind}, {"then", std::move(form)}});
  }
  Json kind;
  kind["enum"] = manifest_kinds();
  kind["description"] = "kind of manifest";
  Json schema;
  schema["type"] = "object";
  schema["properties"] = Json{{"kind", std::move(kind)}};
  schema["required"] = Json::List{"kind"};
  schema["allOf"] = std::move(branches);
  return schema;
}

}  // namespace eagerx::gen

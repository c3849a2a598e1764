#include "generator/frontend/spec/schema.hpp"

#include <fmt/format.h>

#include "generator/frontend/read/bytes.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

void add_bounds(Json& schema, const Format& format) {
  if (format.low) schema[format.low_exclusive ? "exclusiveMinimum" : "minimum"] = *format.low;
  if (format.high) schema["maximum"] = *format.high;
}

/// A key with nothing behind it is an empty mapping where nothing is required.
Json object_type(bool may_be_empty) {
  return may_be_empty ? Json(Json::List{"object", "null"}) : Json("object");
}

Json record_schema(const Format& format) {
  const bool empty = ranges::none_of(format.fields, &Field::required);
  Json schema = {{"type", object_type(empty)},
                 {"additionalProperties", format.item ? schema_of(*format.item) : Json(false)}};
  Json properties = Json::object();
  Json required = Json::list();
  for (const auto& field : format.fields) {
    Json property = schema_of(*field.format);
    property["description"] = field.about;
    properties[field.name] = std::move(property);
    if (field.required) required.push_back(field.name);
  }
  schema["properties"] = std::move(properties);
  if (required.as<Json::List>()->empty()) return schema;
  schema["required"] = std::move(required);
  return schema;
}

/// A fraction, and with a quantity any number with one of its units.
std::string text_pattern(const Format& format) {
  const bool fraction = format.kind == Format::Kind::decimal;
  const std::string number = fraction ? "[0-9]+/[0-9]+" : "";
  if (format.quantity == Quantity::none) return "^" + number + "$";
  std::string units;
  for (const std::string& unit : units_of(format.quantity))
    units += (units.empty() ? "" : "|") + unit;
  if (format.quantity == Quantity::time) units += "|\u00b5s|\u03bcs";
  const std::string with_unit = "[-+]?(" + (fraction ? number + "|" : "") +
                                "[0-9]*\\.?[0-9]+([eE][-+]?[0-9]+)?) *(" + units + ")";
  return "^(" + (fraction ? number + "|" : "") + with_unit + ")$";
}

/// A number, or a text with a unit.
Json memory_schema() {
  std::string units;
  for (const std::string& unit : units_of_memory()) units += (units.empty() ? "" : "|") + unit;
  return {{"anyOf", Json::List{Json{{"type", "integer"}, {"minimum", 0}},
                               Json{{"type", "string"},
                                    {"pattern", "^[0-9]+(\\.[0-9]+)? *(" + units + ")$"}}}}};
}

Json number_schema(const Format& format) {
  Json number = {{"type", "number"}};
  add_bounds(number, format);
  if (format.kind == Format::Kind::number && format.quantity == Quantity::none) return number;
  const Json text = {{"type", "string"}, {"pattern", text_pattern(format)}};
  return {{"anyOf", Json::List{number, text}}};
}

}  // namespace

Json schema_of(const Format& format) {
  static constexpr const char* kIdentifier = "^[A-Za-z][A-Za-z0-9_]*$";
  // Of elements of arrays and of what is in a composite: `arm/leg[2]`.
  static constexpr const char* kPart =
      "[A-Za-z][A-Za-z0-9_]*(\\[[^\\]]+\\])?(/[A-Za-z][A-Za-z0-9_]*(\\[[^\\]]+\\])?)*";
  static const std::string kInner = fmt::format("^{}$", kPart);
  static const std::string kDotted = fmt::format("^{0}(\\.{0})*$", kPart);
  switch (format.kind) {
    case Format::Kind::any:
      return Json::object();
    case Format::Kind::text:
      return {{"type", Json::List{"string", "number", "boolean"}}};
    case Format::Kind::name:
      return {{"type", "string"}, {"pattern", kIdentifier}};
    case Format::Kind::port:
      return {{"type", "string"}, {"pattern", fmt::format("^{0}(\\.{0}){{1,2}}$", kPart)}};
    case Format::Kind::path:
      return {{"type", "string"}, {"pattern", "^[A-Za-z0-9_./+-]+$"}};
    case Format::Kind::boolean:
      return {{"type", "boolean"}};
    case Format::Kind::keyword:
      return {{"enum", format.keywords}};
    case Format::Kind::decimal:
    case Format::Kind::number:
      return number_schema(format);
    case Format::Kind::memory:
      return memory_schema();
    case Format::Kind::integer: {
      Json schema = {{"type", "integer"}};
      add_bounds(schema, format);
      return schema;
    }
    case Format::Kind::list: {
      Json schema = {{"type", "array"}, {"items", schema_of(*format.item)}};
      if (format.min_items > 0) schema["minItems"] = format.min_items;
      return schema;
    }
    case Format::Kind::map: {
      Json schema = {{"type", object_type(true)}};
      if (!format.file_names)
        schema["propertyNames"] =
            Json{{"pattern", format.dotted_names  ? kDotted
                             : format.inner_names ? kInner
                                                  : std::string(kIdentifier)}};
      schema["additionalProperties"] = schema_of(*format.item);
      return schema;
    }
    case Format::Kind::record:
      return record_schema(format);
    case Format::Kind::one_of: {
      Json options = Json::list();
      for (const auto& option : format.options) options.push_back(schema_of(*option));
      return {{"anyOf", std::move(options)}};
    }
  }
  return Json::object();
}

namespace {

/// Takes the `required` of a mapping.
Json taken_needs(Json& schema) {
  Json needs = Json::object();
  auto* members = std::get_if<Json::Object>(&schema.value);
  if (members == nullptr) return needs;
  const auto found = ranges::find(*members, "required", &JsonMember::name);
  if (found == members->end()) return needs;
  needs["required"] = found->value;
  members->erase(found);
  return needs;
}

}  // namespace

Json with_extending(Json graph) {
  Json needs = taken_needs(graph);
  Json parts = Json::object();
  for (JsonMember& section : *std::get_if<Json::Object>(&graph["properties"].value)) {
    if (Json part = taken_needs(section.value); !part.as<Json::Object>()->empty())
      parts[section.name] = std::move(part);
  }
  for (const char* entities : {"objects", "nodes"})
    parts[entities] = Json{{"additionalProperties",
                            taken_needs(graph["properties"][entities]["additionalProperties"])}};
  needs["properties"] = std::move(parts);
  graph["if"] = Json{{"required", Json::List{"extends"}}};
  graph["then"] = Json::object();
  graph["else"] = std::move(needs);
  return graph;
}

std::string schema_text(const Json& schema, const std::string& title, const std::string& id) {
  Json all = {
      {"$schema", "http://json-schema.org/draft-07/schema#"}, {"$id", id}, {"title", title}};
  for (const JsonMember& key : *schema.as<Json::Object>()) all[key.name] = key.value;
  return dump_json(all) + "\n";
}

std::string json_schema(const Format& format, const std::string& title, const std::string& id) {
  return schema_text(with_extending(schema_of(format)), title, id);
}

}  // namespace eagerx::gen

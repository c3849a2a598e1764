#include <algorithm>
#include <nlohmann/json.hpp>

#include "generator/spec/format.hpp"

namespace eagerx::gen {
namespace {

using Json = nlohmann::ordered_json;

Json schema_of(const Format& format);

void add_bounds(Json& schema, const Format& format) {
  if (format.low) schema[format.low_exclusive ? "exclusiveMinimum" : "minimum"] = *format.low;
  if (format.high) schema["maximum"] = *format.high;
}

/// A key with nothing behind it is an empty mapping where nothing is required.
Json object_type(bool may_be_empty) {
  return may_be_empty ? Json({"object", "null"}) : Json("object");
}

Json record_schema(const Format& format) {
  const bool empty = std::none_of(format.fields.begin(), format.fields.end(),
                                  [](const Field& field) { return field.required; });
  Json schema = {{"type", object_type(empty)}, {"additionalProperties", false}};
  Json properties = Json::object();
  Json required = Json::array();
  for (const auto& field : format.fields) {
    Json property = schema_of(*field.format);
    property["description"] = field.about;
    properties[field.name] = std::move(property);
    if (field.required) required.push_back(field.name);
  }
  schema["properties"] = std::move(properties);
  if (!required.empty()) schema["required"] = std::move(required);
  return schema;
}

Json decimal_schema(const Format& format) {
  Json number = {{"type", "number"}};
  add_bounds(number, format);
  return {{"anyOf", {number, {{"type", "string"}, {"pattern", "^[0-9]+/[0-9]+$"}}}}};
}

Json schema_of(const Format& format) {
  static constexpr const char* kIdentifier = "^[A-Za-z][A-Za-z0-9_]*$";
  switch (format.kind) {
    case Format::Kind::any:
      return Json::object();
    case Format::Kind::text:
      return {{"type", {"string", "number", "boolean"}}};
    case Format::Kind::name:
      return {{"type", "string"}, {"pattern", kIdentifier}};
    case Format::Kind::port:
      return {{"type", "string"},
              {"pattern", "^[A-Za-z][A-Za-z0-9_]*(\\.[A-Za-z][A-Za-z0-9_]*){1,2}$"}};
    case Format::Kind::boolean:
      return {{"type", "boolean"}};
    case Format::Kind::keyword:
      return {{"enum", format.keywords}};
    case Format::Kind::decimal:
      return decimal_schema(format);
    case Format::Kind::integer:
    case Format::Kind::number: {
      Json schema = {{"type", format.kind == Format::Kind::integer ? "integer" : "number"}};
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
      if (!format.file_names) schema["propertyNames"] = {{"pattern", kIdentifier}};
      schema["additionalProperties"] = schema_of(*format.item);
      return schema;
    }
    case Format::Kind::record:
      return record_schema(format);
    case Format::Kind::one_of: {
      Json options = Json::array();
      for (const auto& option : format.options) options.push_back(schema_of(*option));
      return {{"anyOf", std::move(options)}};
    }
  }
  return Json::object();
}

}  // namespace

std::string json_schema(const Format& format, const std::string& title, const std::string& id) {
  Json schema = {
      {"$schema", "http://json-schema.org/draft-07/schema#"}, {"$id", id}, {"title", title}};
  schema.update(schema_of(format));
  return schema.dump(2) + "\n";
}

}  // namespace eagerx::gen

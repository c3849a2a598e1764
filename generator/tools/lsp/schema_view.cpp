#include "generator/tools/lsp/schema_view.hpp"

#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen::lsp {
namespace {

bool is_one(const Json& value, const std::string& text) {
  if (const auto* const word = value.as<std::string>()) return *word == text;
  if (const auto* const truth = value.as<bool>()) return text == (*truth ? "true" : "false");
  return false;
}

/// Whether a map has the keys and the values of an `if`.
bool holds(const Json& condition, const OutlineNode* node) {
  const auto* const required = member(&condition, "required");
  if (required != nullptr && required->is<Json::List>()) {
    for (const Json& name : *required->as<Json::List>()) {
      if (node == nullptr || node->find(text_of(&name)) == nullptr) return false;
    }
  }
  const auto* const properties = member(&condition, "properties");
  if (properties == nullptr || !properties->is<Json::Object>()) return true;
  return ranges::all_of(*properties->as<Json::Object>(), [&](const JsonMember& each) {
    const OutlineNode* const value = node != nullptr ? node->find(each.name) : nullptr;
    if (value == nullptr) return true;
    if (const Json* const only = member(&each.value, "const")) return is_one(*only, value->text);
    const Json* const some = member(&each.value, "enum");
    return some == nullptr || !some->is<Json::List>() ||
           ranges::any_of(*some->as<Json::List>(),
                          [&](const Json& one) { return is_one(one, value->text); });
  });
}

void add_all(const Json& schema, const OutlineNode* node, Schemas& result) {
  result.push_back(&schema);
  for (const char* const kind : {"allOf", "anyOf", "oneOf"}) {
    const Json* const parts = member(&schema, kind);
    if (parts == nullptr || !parts->is<Json::List>()) continue;
    for (const Json& part : *parts->as<Json::List>()) add_all(part, node, result);
  }
  if (const Json* const condition = member(&schema, "if")) {
    const Json* const branch = member(&schema, holds(*condition, node) ? "then" : "else");
    if (branch != nullptr) add_all(*branch, node, result);
  }
}

const Json* below(const Json& schema, const std::variant<std::string, std::size_t>& step) {
  if (!std::holds_alternative<std::string>(step)) return member(&schema, "items");
  const std::string& key = std::get<std::string>(step);
  if (const Json* const named = member(member(&schema, "properties"), key)) return named;
  const Json* const others = member(&schema, "additionalProperties");
  return others != nullptr && others->is<Json::Object>() ? others : nullptr;
}

/// Whether all that is known of the value's type is `type`, null aside.
bool is_only(const Json& schema, const std::string& type) {
  const Json* const types = member(&schema, "type");
  if (types == nullptr) return false;
  if (!types->is<Json::List>()) return text_of(types) == type;
  return ranges::all_of(*types->as<Json::List>(), [&](const Json& each) {
    return text_of(&each) == type || text_of(&each) == "null";
  });
}

/// Whether a `required` has the name.
bool names(const Json* list, const std::string& name) {
  return list != nullptr && list->is<Json::List>() &&
         ranges::any_of(*list->as<Json::List>(),
                        [&](const Json& each) { return text_of(&each) == name; });
}

}  // namespace

Schemas schemas_at(const Json& schema, const OutlineNode& top, const OutlinePath& path) {
  const OutlineNode* node = &top;
  Schemas now;
  add_all(schema, node, now);
  OutlinePath walked;
  for (const auto& step : path) {
    walked.push_back(step);
    node = node_at(top, walked);
    Schemas next;
    for (const Json* const each : now) {
      if (const Json* const part = below(*each, step)) add_all(*part, node, next);
    }
    now = std::move(next);
  }
  return now;
}

std::vector<SchemaKey> keys_in(const Schemas& schemas) {
  std::vector<SchemaKey> keys;
  for (const Json* const schema : schemas) {
    const Json* const properties = member(schema, "properties");
    if (properties == nullptr || !properties->is<Json::Object>()) continue;
    for (const JsonMember& each : *properties->as<Json::Object>()) {
      auto known = ranges::find(keys, each.name, &SchemaKey::name);
      if (known == keys.end()) known = keys.insert(keys.end(), {.name = each.name, .about = {}});
      if (known->about.empty()) known->about = text_of(member(&each.value, "description"));
      known->is_map = known->is_map || is_only(each.value, "object");
      known->is_list = known->is_list || is_only(each.value, "array");
    }
  }
  for (SchemaKey& key : keys) {
    key.required = ranges::any_of(
        schemas, [&](const Json* each) { return names(member(each, "required"), key.name); });
  }
  return keys;
}

std::vector<SchemaValue> values_in(const Schemas& schemas) {
  std::vector<SchemaValue> values;
  const auto add = [&](std::string text, std::string about) {
    if (!ranges::contains(values, text, &SchemaValue::text))
      values.push_back({std::move(text), std::move(about)});
  };
  for (const Json* const schema : schemas) {
    const Json* const some = member(schema, "enum");
    if (some != nullptr && some->is<Json::List>()) {
      const Json* const texts = member(schema, "enumDescriptions");
      const auto* const abouts = texts != nullptr ? texts->as<Json::List>() : nullptr;
      std::size_t i = 0;
      for (const Json& each : *some->as<Json::List>()) {
        if (const auto* const text = each.as<std::string>())
          add(*text, abouts != nullptr && i < abouts->size() ? text_of(&(*abouts)[i]) : "");
        ++i;
      }
    }
    if (is_only(*schema, "boolean")) {
      add("true", "");
      add("false", "");
    }
  }
  return values;
}

std::string about(const Schemas& schemas) {
  std::string result;
  for (const Json* const schema : schemas) {
    const std::string text = text_of(member(schema, "description"));
    if (!text.empty() && result.find(text) == std::string::npos)
      result += (result.empty() ? "" : "\n\n") + text;
  }
  return result;
}

}  // namespace eagerx::gen::lsp

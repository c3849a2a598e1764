// The JSON schema of the graph file, and the table it comes from.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "generator/frontend/read/tree.hpp"
#include "generator/frontend/spec/graph_spec.hpp"

namespace eagerx::gen {
namespace {

using Json = nlohmann::json;

std::string schema_text() {
  return json_schema(graph_format(), "eagerx-gen graph", "eagerx-gen/graph.schema.json");
}

std::string file_text(const std::string& path) {
  std::ifstream file(std::string(EAGERX_SOURCE_DIR) + "/" + path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// As an editor reads the file: quoted texts are texts, and everything else is what it looks like.
Json json_of(const YamlValue& yaml) {
  if (yaml.is_null()) return nullptr;
  if (yaml.is_sequence()) {
    Json list = Json::array();
    for (const auto& item : yaml.items) list.push_back(json_of(item));
    return list;
  }
  if (yaml.is_map()) {
    Json map = Json::object();
    for (const auto& entry : yaml.entries) map[entry.key] = json_of(entry.value);
    return map;
  }
  if (yaml.quoted || !Json::accept(yaml.text)) return yaml.text;
  return Json::parse(yaml.text);
}

/// As much of JSON schema as json_schema() writes; the first problem, or empty.
std::string problem_in(const Json& value, const Json& schema, const std::string& where) {
  if (schema.contains("anyOf")) {
    for (const auto& option : schema["anyOf"]) {
      if (problem_in(value, option, where).empty()) return "";
    }
    return where + " fits no option";
  }
  if (schema.contains("if")) {
    const char* branch = problem_in(value, schema["if"], where).empty() ? "then" : "else";
    if (auto problem = problem_in(value, schema.value(branch, Json::object()), where);
        !problem.empty())
      return problem;
  }
  if (schema.contains("enum") &&
      std::find(schema["enum"].begin(), schema["enum"].end(), value) == schema["enum"].end())
    return where + " is not a choice";
  if (schema.contains("type")) {
    const auto is = [&](const std::string& type) {
      if (type == "integer") return value.is_number_integer();
      if (type == "number") return value.is_number();
      return std::string(value.type_name()) == type;
    };
    const Json& types = schema["type"];
    const bool fits = types.is_array() ? std::any_of(types.begin(), types.end(),
                                                     [&](const Json& t) { return is(t); })
                                       : is(types);
    if (!fits) return where + " has the wrong type";
  }
  if (value.is_string() && schema.contains("pattern") &&
      !std::regex_search(value.get<std::string>(),
                         std::regex(schema["pattern"].get<std::string>())))
    return where + " has the wrong form";
  if (schema.contains("exclusiveMinimum") &&
      !(value.get<double>() > schema["exclusiveMinimum"].get<double>()))
    return where + " is too small";
  if (schema.contains("minimum") && value.get<double>() < schema["minimum"].get<double>())
    return where + " is too small";
  if (value.is_array() && schema.contains("items")) {
    for (const auto& item : value) {
      if (auto problem = problem_in(item, schema["items"], where + "[]"); !problem.empty())
        return problem;
    }
  }
  if (!value.is_object()) return "";
  for (const auto& name : schema.value("required", Json::array())) {
    if (!value.contains(name)) return where + " misses " + name.get<std::string>();
  }
  const Json names = schema.value("propertyNames", Json::object());
  for (const auto& [key, item] : value.items()) {
    const std::string place = where + "." + key;
    if (auto problem = problem_in(key, names, place + " as a key"); !problem.empty())
      return problem;
    const bool known = schema.contains("properties") && schema["properties"].contains(key);
    const Json other = schema.value("additionalProperties", Json(true));
    if (!known && other == Json(false)) return place + " is unknown";
    if (!known && other.is_boolean()) continue;
    if (auto problem = problem_in(item, known ? schema["properties"][key] : other, place);
        !problem.empty())
      return problem;
  }
  return "";
}

std::string problem_in_graph(const std::string& text) {
  SourceMap sources;
  Diagnostics diagnostics;
  const YamlValue tree = read_yaml_text("graph.yaml", text, sources, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  return problem_in(json_of(tree), Json::parse(schema_text()), "graph");
}

TEST(Schema, IsTheOneInExamples) {
  EXPECT_EQ(schema_text(), file_text("examples/graph.schema.json"))
      << "write it again: eagerx-gen schema > examples/graph.schema.json";
}

TEST(Schema, AcceptsTheGraphsOfThisRepository) {
  for (const char* graph :
       {"examples/pendulum_swing_up/graph.yaml", "tests/golden/multi_rate/graph.yaml",
        "tests/programs/own_library.yaml", "tests/diagnostics/cases/base.yaml"}) {
    EXPECT_EQ(problem_in_graph(file_text(graph)), "") << graph;
  }
}

TEST(Schema, AcceptsNamesOfPartsAsKeys) {
  const std::string graph = file_text("tests/diagnostics/cases/base.yaml");
  const std::string parts =
      "safety: {actuators: {pendulum.u: 0.0}}\nbudget: {nodes: {pendulum/u: {flash: 1000}}}\n";
  EXPECT_EQ(problem_in_graph(graph + parts), "");
  EXPECT_NE(problem_in_graph(graph + "safety: {actions: {pendulum.u: 0.0}}\n"), "");
}

TEST(Schema, RefusesWhatTheParserRefuses) {
  for (const char* name :
       {"key_typo", "key_unknown", "key_missing", "type_wrong", "rate_negative", "rate_nonsense",
        "delay_nonsense", "port_malformed", "state_keyword", "space_nonsense", "agent_unknown"}) {
    EXPECT_NE(problem_in_graph(file_text("tests/diagnostics/cases/" + std::string(name) + ".yaml")),
              "")
        << name;
  }
}

TEST(Schema, DescribesEveryKey) {
  const auto check_all = [](const auto& self, const Json& schema,
                            const std::string& where) -> void {
    const Json properties = schema.value("properties", Json::object());
    for (const auto& [key, property] : properties.items()) {
      EXPECT_FALSE(property.value("description", "").empty()) << where << "." << key;
      self(self, property, where + "." + key);
    }
    for (const char* inner : {"items", "additionalProperties"}) {
      if (schema.contains(inner) && schema[inner].is_object())
        self(self, schema[inner], where + "[]");
    }
    for (const auto& option : schema.value("anyOf", Json::array())) self(self, option, where);
  };
  check_all(check_all, Json::parse(schema_text()), "graph");
}

}  // namespace
}  // namespace eagerx::gen

// Manifests of what an imported graph needs and does not exist.
#include <gtest/gtest.h>

#include "tests/unit/import/saved_text.hpp"

namespace eagerx::gen {
namespace {

/// EAGERx's sensors have no delay of their own: what is saved of a connection is all of it.

TEST(MissingEntities, NamesThatYamlReadsOtherwiseSurvive) {
  SourceMap sources;
  Diagnostics diagnostics;
  const std::string own =
      "  n: {node_type: m/Own, config: {entity_id: m/Own, rate: 10, inputs: [y, 1e3], outputs: "
      "['on'], states: ['null'], 'off': 2, 'double': 3}, inputs: {y: {space: " +
      std::string(kSpace) + "}, 1e3: {space: " + kSpace + "}}, outputs: {'on': {space: " + kSpace +
      "}}, states: {'null': {space: " + kSpace + "}}}\n";
  const YamlValue tree =
      read_yaml_text("state.yaml", file(environment("10") + object() + own), sources, diagnostics);
  const Library library = load_library({{"tests/data/import/models", {}}}, sources, diagnostics);
  const auto missing = missing_entities(tree, library, {}, diagnostics);
  ASSERT_TRUE(missing && missing->size() == 1) << render_text(diagnostics, sources, false);
  const std::string& text = missing->front().manifest;
  for (const char* line :
       {"\n  'y': {", "\n  a_1e3: {eagerx: '1e3', ", "\n  'on': {", "\n  'null': {",
        "\n  'off': {type: int, default: 2", "\n  double_: {eagerx: double, type: int, default: 3"})
    EXPECT_NE(text.find(line), std::string::npos) << line << "\n" << text;
  const YamlValue manifest = read_yaml_text("manifest.yaml", text, sources, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors()) << text;
  const YamlValue* inputs = manifest.find("inputs");
  ASSERT_NE(inputs, nullptr);
  EXPECT_NE(inputs->find("y"), nullptr);
}

/// The manifest of a missing class of engine node that has this output.

std::string manifest_with_output(const std::string& output) {
  std::string text = flattened("{window: 1}");
  const auto replace = [&](std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + 1))
      text.replace(at, from.size(), to);
  };
  replace("oracle_nodes/OObject", "m/Thing");  // so that its engine nodes are looked for, too
  replace("oracle_nodes/OSensor", "m/Own");
  replace("inputs: [tick, i0]", "inputs: [tick, i1]");
  replace("o0: {processor: null}", "o0: {" + output + "}");
  SourceMap sources;
  Diagnostics diagnostics;
  const YamlValue tree = read_yaml_text("state.yaml", text, sources, diagnostics);
  const Library library = load_library({{"tests/data/import/models", {}}}, sources, diagnostics);
  const auto missing = missing_entities(tree, library, {}, diagnostics);
  for (const auto& entity : missing.value_or(std::vector<MissingEntity>()))
    if (entity.id == "m/Own") return entity.manifest;
  ADD_FAILURE() << text << render_text(diagnostics, sources, false);
  return {};
}

// A key `apart` in the settings of a port was once taken for an internal mark.

TEST(MissingEntities, AKeyOfAPortIsNoMarkOfOurs) {
  const std::string manifest = manifest_with_output("space: {dtype: float32}");
  EXPECT_NE(manifest.find("{like: i1}"), std::string::npos) << manifest;
  EXPECT_EQ(manifest_with_output("space: {dtype: float32}, apart: 1"), manifest);
}

}  // namespace
}  // namespace eagerx::gen

// Whole numbers beyond 2^53, which doubles do not all hold.
#include <gtest/gtest.h>

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {
namespace {

YamlValue scalar(const std::string& text) {
  YamlValue yaml;
  yaml.kind = YamlKind::scalar;
  yaml.text = text;
  return yaml;
}

/// The code of the problem that a value of a parameter has; "" if it has none.
std::string problem_of(const std::string& value) {
  SourceMap sources;
  Diagnostics diagnostics;
  const YamlValue tree = read_yaml_text("manifest.yaml", R"(
kind: node
id: Large
summary: A node.
header: large.hpp
class: Large
config:
  n: {type: int, low: -9007199254740993, high: 9007199254740993, about: a number}
  list: {type: ints, default: [], low: -9223372036854775808, high: 9223372036854775807, about: more}
)",
                                        sources, diagnostics);
  const auto entity = read_entity_manifest(tree, "manifest.yaml", diagnostics);
  EXPECT_TRUE(entity) << render_text(diagnostics, sources, false);
  const Config config = resolve_config({}, *entity, {{"n", {}, scalar(value)}}, {}, diagnostics);
  return diagnostics.all().empty() ? "" : diagnostics.all().front().code;
}

TEST(Exact, BoundsOfParameters) {
  EXPECT_EQ(problem_of("9007199254740993"), "");
  EXPECT_EQ(problem_of("9007199254740994"), "E0323");
  EXPECT_EQ(problem_of("-9007199254740993"), "");
  EXPECT_EQ(problem_of("-9007199254740994"), "E0323");
}

bool kept(const std::string& value, std::optional<Dtype> dtype) {
  Diagnostics diagnostics;
  const bool result = are_exact_as_doubles(scalar(value), dtype, "E0326", diagnostics);
  EXPECT_EQ(diagnostics.has_errors(), !result);
  return result;
}

TEST(Exact, BoundsOfSpacesAreKeptOrRefused) {
  for (const char* value : {"0", "-1", "+7", "9007199254740992", "-9007199254740992",
                            "9007199254740994", "9223372036854775807", "-9223372036854775808"})
    EXPECT_TRUE(kept(value, Dtype::int64)) << value;
  for (const char* value : {"9007199254740993", "-9007199254740993", "9223372036854775806"})
    EXPECT_FALSE(kept(value, Dtype::int64)) << value;
  EXPECT_TRUE(kept("18446744073709551615", Dtype::uint64));
  EXPECT_FALSE(kept("18446744073709551614", Dtype::uint64));
  EXPECT_FALSE(kept("9223372036854775807", Dtype::uint64));
  EXPECT_TRUE(kept("9007199254740993", Dtype::float64));  // rounded, as every literal of C++
  EXPECT_FALSE(kept("9007199254740993", std::nullopt));
  EXPECT_TRUE(kept("9223372036854775807", std::nullopt));
}

}  // namespace
}  // namespace eagerx::gen

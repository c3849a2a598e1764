// No text or tag of a user is taken for what the generator found out itself.
#include <gtest/gtest.h>

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {
namespace {

/// Codes of the problems of parameters, which a file of EAGERx gives with whatever tags.
std::vector<std::string> problems_of(const std::string& config, References references = {}) {
  SourceMap sources;
  Diagnostics diagnostics;
  const YamlValue tree = read_yaml_text("manifest.yaml", R"(
kind: node
id: Named
summary: A node.
header: named.hpp
class: Named
config:
  n: {type: int, default: 0, about: a number}
  x: {type: float, default: 0.0, about: a number}
  name: {type: string, default: "", about: a text}
)",
                                        sources, diagnostics);
  const auto entity = read_entity_manifest(tree, "manifest.yaml", diagnostics);
  EXPECT_TRUE(entity) << render_text(diagnostics, sources, false);
  const YamlValue given = read_yaml_text("x", config, sources, diagnostics, Tags::accept);
  EXPECT_FALSE(diagnostics.has_errors()) << render_text(diagnostics, sources, false);
  const auto settings = substitute(read_config(&given), references, diagnostics);
  const Config read = resolve_config({}, *entity, settings, {}, diagnostics);
  std::vector<std::string> codes;
  for (const auto& each : diagnostics.all()) codes.push_back(each.code);
  return codes;
}

using Codes = std::vector<std::string>;

TEST(Origin, TextsOfUsersAreTexts) {
  for (const char* word : {"unresolved", "computed", "apart", "python object"}) {
    EXPECT_EQ(problems_of(std::string("name: ") + word), Codes()) << word;
    EXPECT_EQ(problems_of(std::string("n: ") + word), Codes{"E0322"}) << word;
  }
}

TEST(Origin, TagsOfUsersAreTags) {
  EXPECT_EQ(problems_of("n: !<unresolved> five"), Codes{"E0322"});
  EXPECT_EQ(problems_of("x: !<computed> 1/3"), Codes{"E0322"});
}

TEST(Origin, WhatIsComputedMayBeAFractionAndWhatIsNotKnownIsSaidOnce) {
  References references;
  references[parameter_reference("third")] = made_scalar("3", {});
  EXPECT_EQ(problems_of("x: $(1 / config third)", references), Codes());
  EXPECT_EQ(problems_of("x: $(1 / config fourth)", references), Codes{"E0324"});
}

TEST(Origin, ATextThatLooksLikeAReferenceIsPutInAsItIs) {
  References references;
  YamlValue text = made_scalar("$(config other)", {});
  text.quoted = true;
  references[parameter_reference("label")] = text;
  references[parameter_reference("other")] = made_scalar("5", {});
  Diagnostics diagnostics;
  const YamlValue once = substitute(made_scalar("$(config label)", {}), references, diagnostics);
  EXPECT_EQ(once.text, "$(config other)");
  EXPECT_EQ(substitute(once, references, diagnostics).text, "$(config other)");
  EXPECT_FALSE(diagnostics.has_errors());
}

}  // namespace
}  // namespace eagerx::gen

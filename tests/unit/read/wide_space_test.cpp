#include <gtest/gtest.h>

#include "generator/frontend/read/tree.hpp"

namespace eagerx::gen {
namespace {

/// The messages about a text, with the place of each.
std::string problems(const std::string& text) {
  SourceMap sources;
  Diagnostics diagnostics;
  read_yaml_text("graph.yaml", text, sources, diagnostics, Tags::refuse);
  std::string result;
  for (const auto& d : diagnostics.all())
    result +=
        std::to_string(d.span.line) + ":" + std::to_string(d.span.column) + " " + d.message + "\n";
  return result;
}

TEST(WideSpace, IsNamedWhereItSeparates) {
  const std::string no_break = " a no-break space (U+00A0) is not a separator in YAML\n";
  EXPECT_EQ(problems("rate:\u00a030\n"), "1:6" + no_break);
  EXPECT_EQ(problems("nodes:\n\u00a0 a: 1\n"), "2:1" + no_break);
  EXPECT_EQ(problems("nodes:\n  - \u00a0a\n"), "2:5" + no_break);
  EXPECT_EQ(problems("node: {a: 1,\u00a0b: 2}\n"), "1:13" + no_break);
  EXPECT_EQ(problems("node: {a:\u00a01}\n"), "1:10" + no_break);
  EXPECT_EQ(problems("a: 1\nb:\u30001\n"), "2:3 this space (U+3000) is not a separator in YAML\n");
}

TEST(WideSpace, IsACharacterInTextsAndComments) {
  EXPECT_EQ(problems("about: 10\u00a0V, and\u00a0more\n"), "");
  EXPECT_EQ(problems("#\u00a0comment\na: 1 #\u00a0{,\u00a0\n"), "");
  EXPECT_EQ(problems("a: \"x:\u00a0y\"\nb: {c: '\u00a0'}\n"), "");
}

}  // namespace
}  // namespace eagerx::gen

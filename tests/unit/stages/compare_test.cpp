// Graphs compared by what they mean.
#include "generator/analysis/compare/compare.hpp"

#include "tests/unit/stages/graphs.hpp"

namespace eagerx::gen {
namespace {

GraphFacts facts(const std::string& text) {
  const auto graph = graph_of_text(text);
  return facts_of(info_of(*graph->plan, graph->spec->budget, graph->diagnostics));
}

TEST(Compare, OneLineADifference) {
  const GraphFacts first = {{"name", "a"}, {"nodes.x.rate", "30"}, {"nodes.x", "Gain"}};
  const GraphFacts second = {{"name", "b"}, {"nodes.y", "Gain"}, {"nodes.y.rate", "30"}};
  EXPECT_EQ(differences(first, second), "- nodes.x: Gain\n+ nodes.y: Gain\n~ name: a → b\n")
      << "of a node that only one has, one line";
  EXPECT_EQ(differences(first, first), "");
}

TEST(Compare, OrderAndWrittenDefaultsMeanNothing) {
  std::string other = swing();
  const std::string line = "  - {from: smooth.filtered, to: pendulum.u}\n";
  other.erase(other.find(line), line.size());
  other += line;
  EXPECT_EQ(differences(facts(swing()), facts(other)), "");
  const std::string same = swing("30.0");
  EXPECT_EQ(differences(facts(swing()), facts(same)), "");
}

TEST(Compare, ARateThatChangedIsSaidWithItsConsequences) {
  const std::string text = differences(facts(swing()), facts(swing("60")));
  EXPECT_NE(text.find("smooth"), std::string::npos) << text;
  EXPECT_NE(text.find("30 → 60"), std::string::npos) << text;
}

}  // namespace
}  // namespace eagerx::gen

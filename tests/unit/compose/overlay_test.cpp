// Variants over states, also of what is in a composite.
#include "generator/frontend/compose/overlay.hpp"

#include <gtest/gtest.h>

#include "generator/frontend/read/tree.hpp"

namespace eagerx::gen {
namespace {

struct Overlaid {
  SourceMap sources;
  Diagnostics diagnostics;
  YamlValue graph;

  Overlaid(std::string base, std::string over)
      : graph(laid_over(read_yaml_text("base.yaml", std::move(base), sources, diagnostics),
                        read_yaml_text("over.yaml", std::move(over), sources, diagnostics),
                        diagnostics)) {}
  [[nodiscard]] const YamlValue* state(std::string_view name) const {
    return graph.find("objects")->find("robot")->find("states")->find(name);
  }
  [[nodiscard]] std::string report() const { return render_text(diagnostics, sources, false); }
};

constexpr const char* kBase =
    "objects:\n"
    "  robot:\n"
    "    states:\n"
    "      body.mass: {uniform: {low: 0.8, high: 1.2}}\n"
    "      body.drag: {space: {low: 0.1, high: 0.2}, uniform: space}\n"
    "      speed: uniform\n"
    "nodes:\n"
    "  choice: {config: {value: 1, choice: [1]}}\n";

TEST(Overlay, AnotherWayToSampleTakesThePlaceOfTheOneBelow) {
  const Overlaid all(kBase,
                     "objects: {robot: {states: {body.mass: {value: 1.0}, body.drag: {normal: "
                     "{mean: 0.1, std: 0.1}}, speed: {value: 0}}}}");
  EXPECT_EQ(all.report(), "");
  ASSERT_NE(all.state("body.mass"), nullptr);
  EXPECT_EQ(all.state("body.mass")->entries.size(), 1U);
  EXPECT_EQ(all.state("body.mass")->find("value")->text, "1.0");
  EXPECT_EQ(all.state("body.drag")->find("uniform"), nullptr);
  EXPECT_NE(all.state("body.drag")->find("space"), nullptr);
  EXPECT_EQ(all.state("speed")->find("value")->text, "0");
}

TEST(Overlay, TheSameWayIsLaidOverKeyByKey) {
  const Overlaid all(kBase, "objects: {robot: {states: {body.mass: {uniform: {high: 1.0}}}}}");
  EXPECT_EQ(all.state("body.mass")->find("uniform")->find("low")->text, "0.8");
  EXPECT_EQ(all.state("body.mass")->find("uniform")->find("high")->text, "1.0");
}

TEST(Overlay, SettingsOfANodeAreNoWays) {
  const Overlaid all(kBase, "nodes: {choice: {config: {choice: [2]}}}");
  EXPECT_NE(all.graph.find("nodes")->find("choice")->find("config")->find("value"), nullptr);
}

TEST(Overlay, RemovesAStateOfAComposite) {
  const Overlaid all(kBase, "remove: [objects.robot.states.body.mass]");
  EXPECT_EQ(all.report(), "");
  EXPECT_EQ(all.state("body.mass"), nullptr);
  EXPECT_NE(all.state("body.drag"), nullptr);
}

TEST(Overlay, SuggestsAStateOfAComposite) {
  const Overlaid all(kBase, "remove: [objects.robot.states.body.mas]");
  EXPECT_NE(all.report().find("did you mean `objects.robot.states.body.mass`?"), std::string::npos)
      << all.report();
}

}  // namespace
}  // namespace eagerx::gen

// Drawings of graphs; tests/drawings looks at those of the examples.
#include <algorithm>

#include "generator/tools/drawing/format.hpp"
#include "tests/unit/stages/graphs.hpp"

namespace eagerx::gen {
namespace {

Drawing drawing(const std::string& text, GraphView view = GraphView::user) {
  const auto graph = graph_of_text(text);
  return drawing_of(*graph->graph, {}, view);
}

TEST(Drawing, ItsFormatIsThatOfTheFile) {
  EXPECT_EQ(drawing_format_of("a.b/graph.svg"), DrawingFormat::svg);
  EXPECT_EQ(drawing_format_of("graph.gv"), DrawingFormat::dot);
  EXPECT_EQ(drawing_format_of("graph.mermaid"), DrawingFormat::mermaid);
  for (const char* path : {"", "svg", "graph.SVG", "graph.png", "graph.svg/"})
    EXPECT_FALSE(drawing_format_of(path)) << path;
}

TEST(Drawing, AnObjectIsABoxAsWrittenAndItsNodesAsItRuns) {
  const Drawing user = drawing(swing()), engine = drawing(swing(), GraphView::engine);
  const auto has = [](const Drawing& here, const std::string& name) {
    return std::ranges::find(here.boxes, name, &Box::name) != here.boxes.end();
  };
  EXPECT_TRUE(has(user, "pendulum") && has(user, "smooth") && !has(user, "pendulum/theta"));
  EXPECT_FALSE(has(engine, "pendulum"));
  EXPECT_GT(engine.boxes.size(), user.boxes.size());
}

/// As in a variant that has reference steps instead of an agent: a box that nothing leads to.
TEST(Drawing, AGraphWithoutActionsHasNoBoxForThem) {
  for (const GraphView view : {GraphView::user, GraphView::engine}) {
    const Drawing what = drawing(
        "name: g\nrate: 30\nengine: {type: OdeEngine, rate: 30}\nobjects:\n"
        "  pendulum: {type: Pendulum, sensors: [theta]}\nnodes:\n"
        "  drive: {type: Reference, rate: 30, config: {shape: step, amplitude: 0.4}}\n"
        "actions: {}\nobservations: [angle]\nconnections:\n"
        "  - {from: drive.y, to: pendulum.u}\n  - {from: pendulum.theta, to: observations.angle}\n",
        view);
    EXPECT_EQ(std::ranges::find(what.boxes, "actions", &Box::name), what.boxes.end());
    for (const Wire& wire : what.wires) {
      EXPECT_LT(wire.output, what.boxes.at(wire.from).outputs.size()) << wire.about;
      EXPECT_LT(wire.input, what.boxes.at(wire.to).inputs.size()) << wire.about;
    }
    const auto to_angle = std::ranges::find_if(what.wires, [&](const Wire& wire) {
      return what.boxes.at(wire.to).name == "observations";
    });
    ASSERT_NE(to_angle, what.wires.end());
    EXPECT_TRUE(what.boxes.at(to_angle->from).name.starts_with("pendulum"));
  }
}

TEST(Drawing, BoxesLieApartAndWiresEndAtPorts) {
  const Drawing what = nested(drawing(swing(), GraphView::engine));
  const Layout layout = layout_of(what, Composites::closed);
  ASSERT_EQ(layout.boxes.size(), what.boxes.size());
  for (std::size_t a = 0; a < layout.boxes.size(); ++a) {
    const PlacedBox& one = layout.boxes[a];
    EXPECT_GE(one.corner.x, 0);
    EXPECT_LE(one.corner.x + one.width, layout.width);
    for (std::size_t b = a + 1; b < layout.boxes.size(); ++b) {
      const PlacedBox& other = layout.boxes[b];
      EXPECT_TRUE(one.corner.x + one.width <= other.corner.x ||
                  other.corner.x + other.width <= one.corner.x ||
                  one.corner.y + one.height <= other.corner.y ||
                  other.corner.y + other.height <= one.corner.y)
          << what.boxes[a].name << " and " << what.boxes[b].name;
    }
  }
  for (std::size_t w = 0; w < what.wires.size(); ++w) {
    const Wire& wire = what.wires[w];
    const PlacedBox& to = layout.boxes[wire.to];
    const Point& end = layout.wires[w].points.back();
    EXPECT_EQ(end.x, to.corner.x) << wire.about;
    EXPECT_EQ(end.y, to.corner.y + to.input_y[wire.input]) << wire.about;
  }
}

TEST(Drawing, ForeignTextStaysText) {
  Drawing what = drawing(swing());
  what.title = what.boxes[0].name = what.boxes[0].about = "</text><script>\"|{}]-->";
  const std::string svg = drawing_text(what, DrawingFormat::svg);
  EXPECT_EQ(svg.find("<script"), std::string::npos);
  EXPECT_NE(svg.find("&lt;script"), std::string::npos);
  for (const auto format : {DrawingFormat::dot, DrawingFormat::mermaid}) {
    const std::string text = drawing_text(what, format);
    EXPECT_EQ(text.find("</text><script>\"|{}]"), std::string::npos) << text;
  }
}

TEST(Drawing, LongNamesAreCut) {
  const std::string name(5'000, 'x');
  EXPECT_LT(shown(name).size(), 100U);
  EXPECT_EQ(shown("short"), "short");
}

TEST(Drawing, IsTheSameEveryTime) {
  EXPECT_EQ(svg_of(drawing(swing())), svg_of(drawing(swing())));
}

}  // namespace
}  // namespace eagerx::gen

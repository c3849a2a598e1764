// Arrays and composites become a flat graph, like a handwritten one.
#include "generator/frontend/compose/compose.hpp"

#include <gtest/gtest.h>

#include "generator/frontend/compose/flat_text.hpp"

namespace eagerx::gen {
namespace {

struct Composed {
  SourceMap sources;
  Diagnostics diagnostics;
  Library library =
      load_library({}, sources, diagnostics, {{std::string(EAGERX_SOURCE_DIR) + "/models", {}}});
  FlatGraph flat;

  explicit Composed(std::string text)
      : flat(compose(read_yaml_text("graph.yaml", std::move(text), sources, diagnostics), library,
                     sources, diagnostics)) {}

  [[nodiscard]] std::string text() const { return flat_text(flat.root, sources); }
  [[nodiscard]] std::string codes() const {
    std::string all;
    for (const Diagnostic& each : diagnostics.all()) all += each.code + " ";
    return all;
  }
  /// "from -> to" of each connection, in order.
  [[nodiscard]] std::vector<std::string> connections() const {
    std::vector<std::string> all;
    for (const YamlValue& each : flat.root.find("connections")->items)
      all.push_back(each.find("from")->text + " -> " + each.find("to")->text);
    return all;
  }
};

constexpr const char* kArray =
    "name: tested\n"
    "rate: 10\n"
    "nodes:\n"
    "  lag: {type: Gain, rate: 10, count: 2, config: {gain: {each: [[1.0], [2.0]]}}}\n"
    "actions: {x: {space: {dtype: float32, shape: [2], low: -1, high: 1}}}\n"
    "observations: [y]\n"
    "connections:\n"
    "  - {from: 'actions.x[*]', to: 'lag[*].signal', delay: 0.1}\n"
    "  - {from: 'lag[*].y', to: 'observations.y[*]', skip: true}\n";

TEST(Compose, AnArrayIsItsElementsWithTheirConnections) {
  const Composed array(kArray);
  EXPECT_EQ(array.codes(), "");
  EXPECT_EQ(array.flat.form, GraphForm::flat);
  EXPECT_EQ(array.text(),
            "name: tested\n"
            "rate: 10\n"
            "nodes:\n"
            "  'lag[0]': {type: Gain, rate: 10, config: {gain: [1.0]}}\n"
            "  'lag[1]': {type: Gain, rate: 10, config: {gain: [2.0]}}\n"
            "  mux/observations/y: {type: Mux, rate: 10, config: {size: 2}, inputs: [a, b]}\n"
            "actions:\n"
            "  x: {space: {dtype: float32, shape: [2], low: -1, high: 1}}\n"
            "observations: [y]\n"
            "connections:\n"
            "  - {from: actions.x, to: 'lag[0].signal', delay: 0.1, processor: {type: GetIndex, "
            "config: {index: 0}}}\n"
            "  - {from: actions.x, to: 'lag[1].signal', delay: 0.1, processor: {type: GetIndex, "
            "config: {index: 1}}}\n"
            "  - {from: 'lag[0].y', to: mux/observations/y.a, skip: true}\n"
            "  - {from: 'lag[1].y', to: mux/observations/y.b, skip: true}\n"
            "  - {from: mux/observations/y.y, to: observations.y}\n");
}

TEST(Compose, AnArrayOfAnotherSizeThanItsValuesIsRefused) {
  std::string text = kArray;
  text.replace(text.find("count: 2"), 8, "count: 3");
  EXPECT_EQ(Composed(text).codes(), "E0391 ");
}

TEST(Compose, AGraphWithoutArraysStaysAsItIsWritten) {
  const Composed plain(
      "name: tested\nrate: 10\nnodes: {a: {type: Gain, rate: 10, config: {gain: 1.0}}}\n");
  EXPECT_EQ(plain.codes(), "");
  EXPECT_EQ(plain.flat.form, GraphForm::written);
}

constexpr const char* kComposite =
    "name: tested\n"
    "rate: 20\n"
    "nodes:\n"
    "  control:\n"
    "    type: CascadeController\n"
    "    rate: 20\n"
    "    config: {max_speed: 30.0, max_current: 1.2, max_voltage: 12.0}\n"
    "actions: {x: {space: {dtype: float32, shape: [1], low: -1, high: 1}}}\n"
    "observations: [u]\n"
    "connections:\n"
    "  - {from: actions.x, to: control.speed, delay: 0.1}\n"
    "  - {from: control.voltage, to: observations.u, window: 3}\n";

TEST(Compose, ACompositeIsItsNodesAtTheirRates) {
  const Composed composite(kComposite);
  EXPECT_EQ(composite.codes(), "");
  std::vector<std::string> nodes;
  for (const auto& entry : composite.flat.root.find("nodes")->entries)
    nodes.push_back(entry.key + " " + entry.value.find("rate")->text);
  EXPECT_EQ(nodes, (std::vector<std::string>{"control/position 1", "control/speed 5",
                                             "control/current 20", "control/back_emf 20"}));
}

TEST(Compose, AConnectionToACompositeGoesToAllThatItsPortIsBoundTo) {
  const Composed composite(kComposite);
  EXPECT_EQ(composite.connections(),
            (std::vector<std::string>{"control/position.u -> control/speed.setpoint",
                                      "control/speed.u -> control/current.setpoint",
                                      "control/back_emf.y -> control/current.feed_forward",
                                      "actions.x -> control/speed.measured",
                                      "actions.x -> control/back_emf.signal",
                                      "control/current.u -> observations.u"}));
  const auto& connections = composite.flat.root.find("connections")->items;
  EXPECT_EQ(connections[3].find("delay")->text, "0.1");
  EXPECT_EQ(connections[4].find("delay")->text, "0.1");
  EXPECT_EQ(connections[5].find("window")->text, "3");
}

// W0114 takes a delay without a unit for milliseconds.
TEST(Compose, ADelayAtACompositeKeepsThatItHasAUnit) {
  std::string text = kComposite;
  text.insert(text.find("actions:"), "    inputs: {setpoint: {delay: 1/3 s}}\n");
  text += "  - {from: actions.x, to: control.setpoint}\n";
  Composed composite(text);
  const auto spec = read_graph_spec(composite.flat.root, "graph.yaml", composite.diagnostics,
                                    composite.flat.form);
  EXPECT_EQ(composite.codes(), "");
  ASSERT_TRUE(spec);
  const auto& delay = spec->connections.back().settings.delay;
  ASSERT_TRUE(delay && delay->number() != nullptr);
  EXPECT_EQ(*delay->number(), Rational(1, 3));
  EXPECT_TRUE(delay->with_unit);
}

TEST(Compose, ReadsOnlyWhatTheGraphUses) {
  const Composed composite(kComposite);
  EXPECT_TRUE(composite.library.entities.contains("CascadeController"));
  EXPECT_FALSE(composite.library.entities.contains("Pendulum"));
}

}  // namespace
}  // namespace eagerx::gen

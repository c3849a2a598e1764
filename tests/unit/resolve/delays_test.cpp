// Delays of connections, from what is written to seconds; and graphs without an engine.
#include <gtest/gtest.h>

#include "tests/unit/graph_of_text.hpp"

namespace eagerx::gen {
namespace {

/// Two nodes one after the other, without an engine. `port` is said of the first one's input.
std::string chain(const std::string& port, const std::string& connection) {
  return "name: tested\nrate: 10\n"
         "nodes:\n"
         "  first: {type: Gain, rate: 10, config: {gain: 2.0}, inputs: {signal: {" +
         port +
         "}}}\n"
         "  second: {type: Gain, rate: 20, config: {gain: 2.0}}\n"
         "actions: {x: {space: {dtype: float32, shape: [1], low: -1, high: 1}}}\n"
         "observations: [y]\n"
         "connections:\n"
         "  - {from: actions.x, to: first.signal" +
         connection +
         "}\n"
         "  - {from: first.y, to: second.signal}\n"
         "  - {from: second.y, to: observations.y, skip: true}\n";
}

const Input& first_input(const GraphOfText& graph) {
  return graph.graph->nodes[1].inputs.front();
}

TEST(Delays, AreExactSecondsOfTheirUnit) {
  EXPECT_EQ(first_input(*graph_of_text(chain("", ", delay: 50 ms"))).delay_s, Rational(1, 20));
  EXPECT_EQ(first_input(*graph_of_text(chain("", ", delay: 0.1"))).delay_s, Rational(1, 10));
  EXPECT_EQ(first_input(*graph_of_text(chain("", ""))).delay_s, Rational());
}

TEST(Delays, OfAConnectionTakeThePlaceOfThePorts) {
  EXPECT_EQ(first_input(*graph_of_text(chain("delay: 0.2", ""))).delay_s, Rational(1, 5));
  EXPECT_EQ(first_input(*graph_of_text(chain("delay: 0.2", ", delay: 0.3"))).delay_s,
            Rational(3, 10));
  EXPECT_EQ(first_input(*graph_of_text(chain("delay: 0.2", ", delay: 0"))).delay_s, Rational());
}

TEST(Delays, ThatAreSampledHaveALongestOne) {
  const auto sampled =
      graph_of_text(chain("delay: 0.2", ", delay: {uniform: {low: 0.0, high: 0.125}}"));
  EXPECT_EQ(first_input(*sampled).delay_s, Rational());
  EXPECT_EQ(first_input(*sampled).max_delay_s, Rational(1, 8));
  EXPECT_TRUE(first_input(*sampled).random_delay);
  EXPECT_EQ(read_graph_text(chain("", ", delay: {normal: {mean: 0.1, std: 0.1}}"))->codes(),
            "E0327");
}

TEST(Delays, AreNotAboveTheLongest) {
  EXPECT_EQ(read_graph_text(chain("", ", delay: 0.2, max_delay: 0.1"))->codes(), "E0327");
  const auto equal = graph_of_text(chain("", ", delay: 100 ms, max_delay: 0.1"));
  EXPECT_EQ(first_input(*equal).max_delay_s, Rational(1, 10));
}

std::string pendulum(const std::string& engine, const std::string& connection) {
  return "name: tested\nrate: 10\nengine: {type: OdeEngine, rate: 10" + engine +
         "}\n"
         "objects: {arm: {type: Pendulum, sensors: {theta: {rate: 10, delay: 0.2}}}}\n"
         "actions: {voltage: {space: {like: arm.u}}}\nobservations: [angle]\n"
         "connections:\n  - {from: actions.voltage, to: arm.u}\n"
         "  - {from: arm.theta, to: observations.angle" +
         connection + "}\n";
}

TEST(Delays, OfASensorAreThoseOfItsConnections) {
  const auto delay_s = [](const std::string& engine, const std::string& connection) {
    const auto graph = graph_of_text(pendulum(engine, connection));
    return graph->graph->environment().inputs.front().delay_s;
  };
  EXPECT_EQ(delay_s("", ""), Rational(1, 5));
  EXPECT_EQ(delay_s("", ", delay: 0.1"), Rational(1, 10));
  EXPECT_EQ(delay_s(", simulate_delays: false", ", delay: 0.1"), Rational());
}

TEST(WithoutAnEngine, NodesFollowTheEnvironment) {
  const auto graph = graph_of_text(chain("", ""));
  const auto& nodes = graph->graph->nodes;
  EXPECT_FALSE(graph->graph->has_engine());
  ASSERT_EQ(nodes.size(), 3U);
  EXPECT_EQ(nodes[1].name, "first");
  EXPECT_EQ(nodes[2].name, "second");
  EXPECT_EQ(nodes[1].inputs.front().source_node, Graph::kEnvironment);
  EXPECT_EQ(nodes[2].inputs.front().source_node, 1U);
  EXPECT_EQ(nodes[0].inputs.front().source_node, 2U);
}

TEST(WithoutAnEngine, PartsAreOfTheSameNodes) {
  const auto graph =
      graph_of_text(chain("", "") + "placement: {second: {part: apart, target: linux-sim}}\n");
  const Placement& placement = *graph->graph->placement;
  ASSERT_EQ(placement.part_of.size(), 3U);
  EXPECT_EQ(placement.part_of[0], placement.part_of[1]);
  EXPECT_NE(placement.part_of[2], placement.part_of[1]);
}

TEST(WithoutAnEngine, ObjectsAreRefused) {
  EXPECT_EQ(read_graph_text("name: tested\nrate: 10\nobjects: {arm: {type: Pendulum}}\n"
                            "actions: {voltage: {space: {like: arm.u}}}\nobservations: [angle]\n"
                            "connections:\n  - {from: actions.voltage, to: arm.u}\n"
                            "  - {from: arm.theta, to: observations.angle}\n")
                ->codes(),
            "E0202");
}

}  // namespace
}  // namespace eagerx::gen

// Ages between what a budget may name; tests/semantics/ages compares many graphs with a simulation.
#include "generator/graph/plan/ages.hpp"

#include <gtest/gtest.h>

#include "tests/unit/graph_of_text.hpp"

namespace eagerx::gen {
namespace {

/// "motor.theta -> motor.u 9/1000", a line for each pair; times in s.
std::string ages(const GraphOfText& graph, const PathEnds& ends) {
  const DataAges found(*graph.plan, ends);
  std::string text;
  for (const DataAge& age : found.known()) {
    text += age.from + " -> " + age.to + " " + age.newest_s.to_string() + "\n";
    Rational sum;
    for (const AgeEdge& edge : age.path) {
      EXPECT_GE(edge.newest_s, Rational()) << edge.input;
      sum = sum + edge.newest_s;
    }
    EXPECT_LE(age.newest_s, sum) << age.from;
  }
  return text;
}

constexpr const char* kCascade =
    "name: cascade\nrate: 100\nengine: {type: OdeEngine, rate: 1000}\n"
    "objects:\n  motor: {type: DcMotor, sensors: {theta: {rate: 1000}, theta_dot: {rate: 1000}},\n"
    "          actuators: {u: {rate: 1000}}}\n"
    "nodes:\n"
    "  position: {type: PidController, rate: 250, config: {kp: 8, low: -40, high: 40},\n"
    "             inputs: [measured, setpoint]}\n"
    "  speed: {type: PidController, rate: 500, config: {kp: 0.3, low: -12, high: 12},\n"
    "          inputs: [measured, setpoint]}\n"
    "actions: {angle: {space: {dtype: float32, shape: [1], low: -3, high: 3}}}\n"
    "observations: [theta, speed]\n"
    "connections:\n"
    "  - {from: actions.angle, to: position.setpoint}\n"
    "  - {from: motor.theta, to: observations.theta}\n"
    "  - {from: motor.theta, to: position.measured}\n"
    "  - {from: position.u, to: speed.setpoint}\n"
    "  - {from: motor.theta_dot, to: speed.measured}\n"
    "  - {from: motor.theta_dot, to: observations.speed, delay: 20 ms}\n"
    "  - {from: speed.u, to: motor.u}\n";

TEST(Ages, AreThoseOfTheEndsThatAreAskedFor) {
  const auto graph = graph_of_text(kCascade);
  EXPECT_EQ(usual_ends(*graph->graph), (PathEnds{false, false, true}));
  EXPECT_EQ(ages(*graph, {false, false, true}),
            "motor.theta -> motor.u 0.003\nmotor.theta_dot -> motor.u 0.001\n");
  EXPECT_EQ(ages(*graph, {true, false, false}), "actions.angle -> motor.u 0.011\n");
  EXPECT_EQ(ages(*graph, {false, true, true}),
            "motor.theta -> observations.theta 0\nmotor.theta_dot -> observations.speed 0.02\n");
  EXPECT_EQ(ages(*graph, {true, true, false}), "") << "the engine is not a path of data";
}

TEST(Ages, OfPathsAroundTheAgentAreThoseWithoutIt) {
  std::string text = kCascade;
  const std::string around = "  - {from: motor.theta, to: position.measured}\n";
  text.replace(text.find(around), around.size(),
               "  - {from: motor.theta, to: position.measured, delay: 30 ms}\n");
  const auto graph = graph_of_text(text);
  EXPECT_EQ(ages(*graph, {false, false, true}),
            "motor.theta -> motor.u 0.011\nmotor.theta_dot -> motor.u 0.001\n")
      << "the agent's answer is fresher";
  EXPECT_EQ(ages(*graph, {false, false, false}),
            "motor.theta -> motor.u 0.033\nmotor.theta_dot -> motor.u 0.001\n");
}

/// A library: what is measured at 100 Hz goes through a controller at `rate_hz`.
std::unique_ptr<GraphOfText> alone(const std::string& rate_hz, const std::string& settings) {
  return graph_of_text(
      "name: alone\nrate: 100\nnodes:\n  speed: {type: PidController, rate: " + rate_hz +
      ", config: {kp: 2, low: -6, high: 6}}\n"
      "actions: {angle: {space: {dtype: float32, shape: [1], low: -3, high: 3}}}\n"
      "observations: [voltage]\nconnections:\n"
      "  - {from: actions.angle, to: speed.measured" +
      settings + "}\n  - {from: speed.u, to: observations.voltage, skip: true}\n");
}

TEST(Ages, WithoutAnEngineAreCountedBetweenCallsOfStep) {
  const auto age = [](const std::string& rate_hz, const std::string& settings) {
    const auto graph = alone(rate_hz, settings);
    return ages(*graph, usual_ends(*graph->graph));
  };
  EXPECT_EQ(age("100", ""), "actions.angle -> observations.voltage 0\n");
  EXPECT_EQ(age("1000", ""), "actions.angle -> observations.voltage 0\n");
  EXPECT_EQ(age("50", ""), "actions.angle -> observations.voltage 0.01\n");
  EXPECT_EQ(age("1000", ", delay: 50 ms"), "actions.angle -> observations.voltage 0.05\n");
  EXPECT_EQ(age("100", ", skip: true"), "actions.angle -> observations.voltage 0.01\n");
}

TEST(Ages, UnknownConnectionsCountBetweenTheirEndsOnly) {
  std::string text = kCascade;
  text.replace(text.find("20 ms"), 5, "40000");
  const auto graph = graph_of_text(text);
  const DataAges found(*graph->plan, {false, true, true});
  EXPECT_EQ(found.unknown().size(), 1U);
  EXPECT_EQ(found.unknown("motor.theta_dot", "observations.speed").size(), 1U);
  EXPECT_TRUE(found.unknown("motor.theta", "observations.theta").empty());
  EXPECT_TRUE(DataAges(*graph->plan, {false, false, false}).unknown().empty());
  EXPECT_EQ(DataAges(*graph->plan, {false, false, true}).unknown().size(), 1U);
}

TEST(Ages, NamesOfEnds) {
  const auto graph = graph_of_text(kCascade);
  using Names = std::vector<std::string>;
  EXPECT_EQ(names_of_sources(*graph->graph, true), Names{"actions.angle"});
  EXPECT_EQ(names_of_destinations(*graph->graph, false), Names{"motor.u"});
  EXPECT_EQ(names_of_destinations(*graph->graph, true),
            (Names{"observations.speed", "observations.theta"}));
}

}  // namespace
}  // namespace eagerx::gen

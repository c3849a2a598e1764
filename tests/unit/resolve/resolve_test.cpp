#include <gtest/gtest.h>

#include <algorithm>

#include "generator/frontend/read/tree.hpp"
#include "generator/graph/resolve/graph.hpp"

namespace eagerx::gen {
namespace {

/// The library is loaded once; a graph points into it.
struct Resolved {
  SourceMap sources;
  Diagnostics diagnostics;
  std::optional<Graph> graph;
};

const Library& library() {
  static SourceMap sources;
  static Diagnostics diagnostics;
  static const Library kLibrary =
      load_library({{std::string(EAGERX_SOURCE_DIR) + "/models", {}},
                    {std::string(EAGERX_SOURCE_DIR) + "/tests/data/library", {}}},
                   sources, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  return kLibrary;
}

std::unique_ptr<Resolved> resolved(const std::string& objects_and_more,
                                   const ResolveOptions& options = {}) {
  auto result = std::make_unique<Resolved>();
  const std::string head =
      "name: tested\nrate: 30\nengine: {type: OdeEngine, rate: 30, config: {method: rk4, substeps: "
      "7}}\n";
  const YamlValue tree =
      read_yaml_text("graph.yaml", head + objects_and_more, result->sources, result->diagnostics);
  const auto spec = read_graph_spec(tree, "graph.yaml", result->diagnostics);
  if (spec) result->graph = resolve(*spec, library(), options, result->diagnostics);
  EXPECT_TRUE(result->graph) << render_text(result->diagnostics, result->sources, false);
  return result;
}

constexpr const char* kPendulum =
    "objects:\n  arm: {type: Pendulum}\n"
    "actions: {voltage: {space: {like: arm.u}}}\nobservations: [angle]\n"
    "connections:\n  - {from: actions.voltage, to: arm.u}\n  - {from: arm.theta, to: "
    "observations.angle}\n";

const GraphNode* node(const Resolved& resolved, const std::string& name) {
  const auto& nodes = resolved.graph->nodes;
  const auto found =
      std::find_if(nodes.begin(), nodes.end(), [&](const GraphNode& n) { return n.name == name; });
  return found == nodes.end() ? nullptr : &*found;
}

std::int64_t integer(const GraphNode& node, const std::string& parameter) {
  for (const auto& item : node.config) {
    if (item.parameter->name.value == parameter) return std::get<std::int64_t>(item.value);
  }
  return -1;
}

TEST(Resolve, KeepsTheEngineNodesThatAreNeededAndTheirSyncedDescendants) {
  const auto result = resolved(kPendulum);
  std::vector<std::string> names;
  for (const auto& item : result->graph->nodes) names.push_back(item.name);
  // u_applied is synchronised and hears u, so EAGERx runs it, connected or not; theta_dot is
  // neither.
  EXPECT_EQ(names, (std::vector<std::string>{"environment", "engine", "arm/x", "arm/theta", "arm/u",
                                             "arm/u_applied"}));
}

TEST(Resolve, TakesRatesFromSensorsAndActuators) {
  std::string text = kPendulum;
  text.replace(text.find("type: Pendulum"), 14,
               "type: Pendulum, sensors: {theta: {rate: 12.5}}, actuators: {u: {rate: 10}}");
  const auto result = resolved(text);
  EXPECT_EQ(node(*result, "arm/x")->rate_hz, Rational::parse("12.5"));
  EXPECT_EQ(node(*result, "arm/theta")->rate_hz, Rational::parse("12.5"));
  EXPECT_EQ(node(*result, "arm/u")->rate_hz, Rational(10));
}

TEST(Resolve, AnotherEngineOfTheCommandLineHasItsDefaultsTheSameOneItsConfig) {
  EXPECT_EQ(integer(resolved(kPendulum)->graph->engine(), "substeps"), 7);
  EXPECT_EQ(integer(resolved(kPendulum, {"OdeEngine", "", {}})->graph->engine(), "substeps"), 7);
  EXPECT_TRUE(resolved(kPendulum, {"", "double", {}})->graph->double_precision);
  EXPECT_FALSE(resolved(kPendulum)->graph->double_precision);
}

TEST(Resolve, SpacesFollowConnectionsAndProcessors) {
  const auto result = resolved(
      "objects:\n  arm: {type: Pendulum}\n"
      "nodes:\n  smooth: {type: ButterworthFilter, rate: 30, config: {cutoff_hz: 5}}\n"
      "actions: {voltage: {space: {like: arm.u, low: -1}}}\nobservations: [angle]\n"
      "connections:\n  - {from: actions.voltage, to: smooth.signal}\n  - {from: smooth.filtered, "
      "to: arm.u}\n"
      "  - {from: arm.theta, to: observations.angle, processor: DecomposedAngle}\n");
  const Graph& graph = *result->graph;
  EXPECT_EQ(graph.environment().outputs[0].space.describe(), "float32 [1]");
  EXPECT_EQ(graph.environment().outputs[0].space.low, (std::vector<double>{-1.0}));
  EXPECT_EQ(graph.environment().outputs[0].space.high, (std::vector<double>{2.0}));
  EXPECT_EQ(node(*result, "smooth")->outputs[0].space.low, (std::vector<double>{-1.0}));
  EXPECT_EQ(graph.environment().inputs[0].space.describe(), "float32 [2]");
  EXPECT_EQ(graph.environment().inputs[0].processor->input.describe(), "float32 []");
}

TEST(Resolve, ALoopOfSkipsTakesItsSpaceFromWhatIsDeclared) {
  const auto result = resolved(
      "nodes:\n  a: {type: ButterworthFilter, rate: 30, config: {cutoff_hz: 5}, inputs: {signal: "
      "{space: {shape: [3]}}}}\n"
      "  b: {type: ButterworthFilter, rate: 30, config: {cutoff_hz: 5}}\n"
      "actions: []\nobservations: [seen]\n"
      "connections:\n  - {from: a.filtered, to: b.signal}\n  - {from: b.filtered, to: a.signal, "
      "skip: true}\n  - {from: b.filtered, to: observations.seen}\n");
  EXPECT_EQ(node(*result, "b")->outputs[0].space.describe(), "float32 [3]");
}

TEST(Resolve, ConnectionsWinOverSelectionsAndThoseOverManifests) {
  const auto result = resolved(
      "nodes:\n  a: {type: LeakySum, rate: 30, config: {weights: [1, 1]}, inputs: {first: {delay: "
      "0.1}, second: {window: 5}}}\n"
      "actions: {push: {space: {like: a.first, low: -1, high: 1}}}\nobservations: [sum]\n"
      "connections:\n  - {from: actions.push, to: a.first, window: 3}\n  - {from: actions.push, "
      "to: a.second, window: 7, skip: true}\n"
      "  - {from: a.sum, to: observations.sum, skip: true}\n");
  const GraphNode& a = *node(*result, "a");
  EXPECT_EQ(a.inputs[0].window, 3U);  // the manifest says 2
  EXPECT_EQ(a.inputs[0].delay_s, Rational::parse("0.1"));
  EXPECT_EQ(a.inputs[1].window, 7U);
  EXPECT_TRUE(a.inputs[1].skip);
}

TEST(Resolve, ManifestsReferToParametersTheirSizesAndTheirElements) {
  const auto result = resolved(
      "objects:\n  arm: {type: Pendulum, states: {model_state: uniform}}\n"
      "nodes:\n  filter: {type: WindowedButterworth, rate: 30, config: {N: 3, Wn: 5}}\n"
      "  down: {type: ResetAngle, rate: 30, config: {u_range: [-1.5, 1]}}\n"
      "actions: {voltage: {space: {like: arm.u}}}\nobservations: [both]\n"
      "connections:\n  - {from: actions.voltage, to: filter.signal}\n"
      "  - {from: filter.filtered, to: down.feedthroughs.u}\n  - {from: down.u, to: arm.u}\n"
      "  - {from: arm.theta, to: down.theta}\n  - {from: arm.theta_dot, to: down.theta_dot}\n"
      "  - {from: arm.states.model_state, to: down.targets.goal}\n"
      "  - {from: arm.u_applied, to: observations.both, processor: {type: GetIndex, config: "
      "{index: "
      "[0, 0]}}}\n");
  EXPECT_EQ(node(*result, "filter")->inputs[0].window, 3U);
  EXPECT_EQ(node(*result, "down")->outputs[0].space.low, std::vector<double>{-1.5});
  EXPECT_EQ(node(*result, "down")->outputs[0].space.high, std::vector<double>{1.0});
  EXPECT_EQ(result->graph->environment().inputs[0].space.describe(), "float32 [2]");
}

TEST(Resolve, ASensorsSpaceIsWhatItsProcessorGives) {
  std::string text = kPendulum;
  text.replace(text.find("type: Pendulum"), 14,
               "type: Pendulum, sensors: {theta: {processor: DecomposedAngle, space: {shape: [2], "
               "low: -0.5}}}");
  const auto result = resolved(text);
  const Output& theta = node(*result, "arm/theta")->outputs[0];
  EXPECT_EQ(theta.raw.describe(), "float32 []");
  EXPECT_EQ(theta.space.describe(), "float32 [2]");
  EXPECT_EQ(theta.space.low, std::vector<double>{-0.5});
  EXPECT_EQ(theta.space.high, std::vector<double>{1.0});  // the processor's
}

TEST(Resolve, AStateOfAnObjectMayBeThatOfAnEngineNode) {
  const auto result = resolved(
      "objects:\n  arm: {type: DcscPendulum, config: {max_delay: 0.25}, states: {delay: uniform, "
      "model_state: {space: {low: -1.0, high: 1.0}, uniform: space}}}\n"
      "actions: {voltage: {space: {like: arm.u}}}\nobservations: [x]\n"
      "connections:\n  - {from: actions.voltage, to: arm.u}\n  - {from: arm.x, to: "
      "observations.x}\n");
  const auto& states = node(*result, "arm/u")->states;
  ASSERT_EQ(states.size(), 1U);
  EXPECT_TRUE(states[0].settable);
  EXPECT_EQ(states[0].random->second, std::vector<double>{0.25});
  ASSERT_EQ(result->graph->objects[0].states.size(), 1U);
  const State& model_state = result->graph->objects[0].states[0];
  EXPECT_EQ(model_state.random->first, (std::vector<double>{-1.0, -1.0}));
  EXPECT_EQ(model_state.random->second, (std::vector<double>{1.0, 1.0}));
}

TEST(Resolve, ADrawnDelayReplacesAWrittenOne) {
  const auto result = resolved(
      "objects:\n  arm: {type: Pendulum}\n"
      "nodes:\n  smooth: {type: ButterworthFilter, rate: 30, config: {cutoff_hz: 5}, inputs: "
      "{signal: {delay: 0.1}}}\n"
      "actions: {voltage: {space: {like: arm.u}}}\nobservations: [angle]\n"
      "connections:\n  - {from: actions.voltage, to: smooth.signal, delay: {uniform: {low: 0, "
      "high: 0.05}}}\n"
      "  - {from: smooth.filtered, to: arm.u}\n  - {from: arm.theta, to: observations.angle}\n");
  const Input& input = node(*result, "smooth")->inputs[0];
  EXPECT_EQ(input.delay_s, Rational());
  EXPECT_EQ(input.max_delay_s, Rational::parse("0.05"));
}

}  // namespace
}  // namespace eagerx::gen

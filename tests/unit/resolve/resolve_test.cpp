#include <gtest/gtest.h>

#include <algorithm>

#include "generator/read/tree.hpp"
#include "generator/resolve/graph.hpp"

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
      "name: test\nrate: 30\nengine: {type: OdeEngine, rate: 30, config: {method: rk4, substeps: "
      "7}}\n";
  const Node tree =
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
  EXPECT_EQ(integer(resolved(kPendulum, {"OdeEngine", ""})->graph->engine(), "substeps"), 7);
  EXPECT_TRUE(resolved(kPendulum, {"", "double"})->graph->double_precision);
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

}  // namespace
}  // namespace eagerx::gen

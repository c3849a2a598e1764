// The rules of resolve for engine nodes, actions and circles.
#include <gtest/gtest.h>

#include "generator/graph/resolve/prune.hpp"
#include "tests/unit/graph_of_text.hpp"

namespace eagerx::gen {
namespace {

/// Engine nodes, of which those in `synchronised` have an input `tick`.
std::vector<UnresolvedNode> engine_nodes(std::size_t count,
                                         const std::vector<std::size_t>& synchronised) {
  std::vector<UnresolvedNode> nodes(count);
  for (const std::size_t node : synchronised) nodes[node].inputs.emplace_back().name = "tick";
  return nodes;
}

TEST(EngineNodes, AreThoseOfUsedSensorsAndActuatorsWithWhatTheyNeed) {
  // 0 actuator -> 1 motor -> 2 encoder; 3 camera -> 4 filter
  const std::vector<InnerLink> links = {{0, 1}, {1, 2}, {3, 4}};
  struct Row {
    std::vector<std::size_t> synchronised, sensors, actuators;
    std::vector<bool> needed;
  };
  const std::vector<Row> rows = {
      {{}, {}, {}, {false, false, false, false, false}},
      {{}, {2}, {}, {true, true, true, false, false}},  // what it reads, too
      {{}, {4}, {}, {false, false, false, true, true}},
      {{}, {}, {0}, {true, false, false, false, false}},
      {{1}, {}, {0}, {true, true, false, false, false}},  // behind the actuator, with the engine
      {{2}, {}, {0}, {true, true, true, false, false}},
      {{1}, {}, {}, {false, false, false, false, false}},  // its actuator is not in use
      {{1, 4}, {4}, {0}, {true, true, false, true, true}},
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(needed_engine_nodes(engine_nodes(5, rows[i].synchronised), links, rows[i].sensors,
                                  rows[i].actuators),
              rows[i].needed)
        << i;
  }
}

TEST(AppliedActions, AreWithinTheirActuators) {
  struct Row {
    std::string space;  // of the action
    double low, high;   // of what is applied; the actuator takes -2 to 2
    std::string narrowed_by;
  };
  const std::vector<Row> rows = {{"low: -1, high: 1", -1.0, 1.0, ""},
                                 {"low: -2, high: 2", -2.0, 2.0, ""},
                                 {"low: -3, high: 1", -2.0, 1.0, "pendulum.u"},
                                 {"low: 3, high: 4", -2.0, 2.0, "pendulum.u"}};
  for (const Row& row : rows) {
    const auto graph = graph_of_text(
        "name: tested\nrate: 10\n"
        "engine: {type: OdeEngine, rate: 60}\n"
        "objects: {pendulum: {type: Pendulum, actuators: {u: {space: {low: -2, high: 2}}}}}\n"
        "actions: {u: {space: {dtype: float32, shape: [1], " +
        row.space +
        "}}}\n"
        "observations: [theta]\n"
        "connections:\n"
        "  - {from: actions.u, to: pendulum.u}\n"
        "  - {from: pendulum.theta, to: observations.theta}\n");
    ASSERT_EQ(graph->graph->applied.size(), 1U) << row.space;
    const AppliedAction& applied = graph->graph->applied.front();
    EXPECT_EQ(applied.space.low.front(), row.low) << row.space;
    EXPECT_EQ(applied.space.high.front(), row.high) << row.space;
    EXPECT_EQ(applied.narrowed_by, row.narrowed_by) << row.space;
  }
}

/// Two nodes in a circle; `skip` is said of the connection back.
std::string circle(const std::string& skip) {
  return "name: tested\nrate: 10\n"
         "nodes:\n"
         "  a: {type: Sum, rate: 10, inputs: [a, b]}\n"
         "  b: {type: Gain, rate: 10, config: {gain: 2.0}}\n"
         "actions: {x: {space: {dtype: float32, shape: [1], low: -1, high: 1}}}\n"
         "observations: [y]\n"
         "connections:\n"
         "  - {from: actions.x, to: a.a}\n"
         "  - {from: a.y, to: b.signal}\n"
         "  - {from: b.y, to: a.b" +
         skip +
         "}\n"
         "  - {from: b.y, to: observations.y, skip: true}\n";
}

TEST(Cycles, NeedAConnectionThatSkips) {
  EXPECT_EQ(read_graph_text(circle(""))->codes(), "E0314");
  EXPECT_EQ(read_graph_text(circle(", skip: true"))->codes(), "");
}

}  // namespace
}  // namespace eagerx::gen

// What crosses the link between the two programs of a split graph.
#include <gtest/gtest.h>

#include "tests/unit/graph_of_text.hpp"

namespace eagerx::gen {
namespace {

/// Sensors at 60 Hz, a filter at `filter_hz`, an agent at 30 Hz.
std::unique_ptr<GraphOfText> planned(const std::string& placement,
                                     const std::string& filter_hz = "30",
                                     const std::string& to_filter = "actions.voltage") {
  const std::string text =
      "name: tested\nrate: 30\nengine: {type: OdeEngine, rate: 60}\n"
      "objects:\n  arm: {type: Pendulum, sensors: {theta: {rate: 60}}}\n"
      "nodes:\n  smooth: {type: ButterworthFilter, rate: " +
      filter_hz +
      ", config: {cutoff_hz: 5}}\n"
      "actions: {voltage: {space: {like: arm.u}}}\nobservations: [angle]\n"
      "connections:\n  - {from: " +
      to_filter +
      ", to: smooth.signal}\n  - {from: smooth.filtered, to: arm.u}\n"
      "  - {from: arm.theta, to: observations.angle}\n"
      "placement: {" +
      placement + ": mps2-an386}\n";
  return graph_of_text(text);
}

std::vector<std::string> names(const Plan& plan, const std::vector<bool>& crosses) {
  std::vector<std::string> result;
  for (std::size_t c = 0; c < plan.channels.size(); ++c) {
    if (crosses[c]) result.push_back(plan.channels[c].name);
  }
  return result;
}
using Names = std::vector<std::string>;

TEST(Split, TheControllerGetsItsInputsAndTheHostEverythingOfTheBoard) {
  const auto result = planned("controller");
  const Split& split = *result->plan->split;
  EXPECT_EQ(names(*result->plan, split.to_board), (Names{"arm/theta/observation"}));
  EXPECT_EQ(names(*result->plan, split.to_host), (Names{"environment/voltage", "smooth/filtered"}));
  EXPECT_EQ(split.exchanges, 1.0);
  EXPECT_EQ(split.board_bytes, 2.0 + 2 * 4.0);  // the command, theta twice a step
  EXPECT_EQ(split.host_bytes, 4.0 + 4.0);
  EXPECT_EQ(split.board_payload, 2U + 8U + 18U);
}

TEST(Split, AFilterGetsTheActionOnly) {
  const auto result = planned("smooth");
  const Split& split = *result->plan->split;
  EXPECT_EQ(names(*result->plan, split.to_board), (Names{"environment/voltage"}));
  EXPECT_EQ(names(*result->plan, split.to_host), (Names{"smooth/filtered"}));
  EXPECT_EQ(split.exchanges, 1.0);
}

TEST(Split, EveryChangeOfSideIsAnExchange) {
  // The agent on the board, the filter behind it on the host; the sensors come from there.
  const auto agent = planned("agent");
  EXPECT_EQ(agent->plan->split->exchanges, 1.0);
  EXPECT_EQ(names(*agent->plan, agent->plan->split->to_host), (Names{"environment/voltage"}));
  // A filter that runs twice as often answers twice a step, once with nothing new for it.
  const auto fast = planned("smooth", "60");
  EXPECT_EQ(fast->plan->split->exchanges, 1.0);
  EXPECT_EQ(fast->plan->split->host_bytes, 8.0);
}

TEST(Split, TheControllerIsTheAgentAndAllNodes) {
  const auto result = planned("controller");
  EXPECT_TRUE(result->graph->placement->on_board[Graph::kEnvironment]);
  EXPECT_FALSE(result->graph->placement->on_board[Graph::kEngine]);
  EXPECT_EQ(result->graph->placement->board->id.value, "mps2-an386");
}

}  // namespace
}  // namespace eagerx::gen

// Messages on the links between the programs of a placed graph.
#include "generator/graph/plan/split.hpp"

#include <gtest/gtest.h>

#include "tests/unit/graph_of_text.hpp"

namespace eagerx::gen {
namespace {

/// Sensors at 60 Hz, a filter at `filter_hz`, an agent at 30 Hz.
std::unique_ptr<GraphOfText> planned(const std::string& placement,
                                     const std::string& filter_hz = "30",
                                     const std::string& to_filter = "actions.voltage",
                                     const std::string& more = "") {
  const std::string text =
      "name: tested\nrate: 30\nengine: {type: OdeEngine, rate: 60}\n"
      "objects:\n  arm: {type: Pendulum, sensors: {theta: {rate: 60}}}\n"
      "nodes:\n  smooth: {type: ButterworthFilter, rate: " +
      filter_hz +
      ", config: {cutoff_hz: 5}}\n"
      "actions: {voltage: {space: {like: arm.u}}}\nobservations: [angle]\n"
      "connections:\n  - {from: " +
      to_filter + ", to: smooth.signal}\n  - {from: smooth.filtered, to: arm.u" + more +
      "}\n"
      "  - {from: arm.theta, to: observations.angle}\n"
      "placement: {" +
      placement + (placement.find(':') == std::string::npos ? ": mps2-an386}\n" : "}\n");
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
  const PartLink& link = result->plan->split->links.front();
  EXPECT_EQ(names(*result->plan, link.to_part), (Names{"arm/theta/observation"}));
  EXPECT_EQ(names(*result->plan, link.to_hub), (Names{"environment/voltage", "smooth/filtered"}));
  EXPECT_EQ(link.exchanges, 1.0);
  EXPECT_EQ(link.part_bytes, 2.0 + 2 * 4.0);  // the command, theta twice a step
  EXPECT_EQ(link.hub_bytes, 4.0 + 4.0);
  EXPECT_EQ(link.part_payload, 2U + 8U + 18U);
}

TEST(Split, AFilterGetsTheActionOnly) {
  const auto result = planned("smooth");
  const PartLink& link = result->plan->split->links.front();
  EXPECT_EQ(names(*result->plan, link.to_part), (Names{"environment/voltage"}));
  EXPECT_EQ(names(*result->plan, link.to_hub), (Names{"smooth/filtered"}));
  EXPECT_EQ(link.exchanges, 1.0);
}

TEST(Split, EveryChangeOfSideIsAnExchange) {
  // The agent on the board, the filter behind it on the host; the sensors come from there.
  const auto agent = planned("agent");
  EXPECT_EQ(agent->plan->split->links.front().exchanges, 1.0);
  EXPECT_EQ(names(*agent->plan, agent->plan->split->links.front().to_hub),
            (Names{"environment/voltage"}));
  // A filter that runs twice as often answers twice a step, once with nothing new for it.
  const auto fast = planned("smooth", "60");
  EXPECT_EQ(fast->plan->split->links.front().exchanges, 1.0);
  EXPECT_EQ(fast->plan->split->links.front().hub_bytes, 8.0);
}

TEST(Split, TheControllerIsTheAgentAndAllNodes) {
  const auto result = planned("controller");
  const Placement& placement = *result->graph->placement;
  EXPECT_EQ(placement.part_of[Graph::kEnvironment], 0U);
  EXPECT_EQ(placement.part_of[Graph::kEngine], Placement::kHub);
  EXPECT_EQ(placement.parts.front().target->id.value, "mps2-an386");
  EXPECT_EQ(placement.parts.front().name, "board");
}

TEST(Split, WhatGoesFromOnePartToAnotherGoesThroughTheHub) {
  const auto result =
      planned("smooth: {part: filter}, agent: {host: gpu_pc}", "30", "actions.voltage");
  const Placement& placement = *result->graph->placement;
  ASSERT_EQ(placement.parts.size(), 2U);
  EXPECT_EQ(placement.parts[0].name, "filter");
  EXPECT_EQ(placement.parts[0].target->id.value, "linux-sim");
  EXPECT_EQ(placement.parts[1].name, "gpu_pc");
  EXPECT_EQ(placement.parts[1].host, "gpu_pc");
  const Plan& plan = *result->plan;
  EXPECT_EQ(names(plan, plan.split->links[1].to_hub), (Names{"environment/voltage"}));
  EXPECT_EQ(names(plan, plan.split->links[0].to_part), (Names{"environment/voltage"}));
  const LinkUse of_hub = link_use(plan, Part::hub, Graph::kEnvironment, 0);
  EXPECT_EQ(of_hub.from, 1U);
  EXPECT_EQ(of_hub.to, std::vector<std::size_t>{0});
  const LinkUse of_filter = link_use(plan, Part::placed(0), Graph::kEnvironment, 0);
  EXPECT_EQ(of_filter.from, 0U);
  EXPECT_TRUE(of_filter.to.empty());
  EXPECT_FALSE(link_use(plan, Part::whole, Graph::kEnvironment, 0).any());
}

TEST(Split, ADelayGivesTime) {
  const auto link = [](const std::string& placement, const std::string& more) {
    return planned(placement, "30", "actions.voltage", more)->plan->split->links.front();
  };
  const PartLink at_once = link("smooth: {part: filter}", "");
  EXPECT_TRUE(at_once.is_pipelined);
  EXPECT_EQ(at_once.depth, 1U);
  EXPECT_EQ(at_once.why_no_more, "`arm.u` reads it with no `delay`");
  EXPECT_EQ(link("smooth: {part: filter}", ", delay: 0.03").depth, 1U);  // less than an exchange
  const PartLink late = link("smooth: {part: filter}", ", delay: 0.1");
  EXPECT_EQ(late.depth, 4U);  // three steps, and the one that is sent
  EXPECT_EQ(late.why_no_more, "`arm.u` reads it with `delay: 0.1`");
  const PartLink later = link("smooth: {part: filter}", ", delay: 100");
  EXPECT_EQ(later.depth, 32U);
  EXPECT_EQ(later.why_no_more, "32 are the most of a link");
  // A delay that a reset may change may be none.
  EXPECT_EQ(link("smooth: {part: filter}", ", delay: 0.1, max_delay: 0.2").depth, 1U);
  const PartLink board = link("smooth: mps2-an386", ", delay: 0.1");
  EXPECT_TRUE(board.is_pipelined);
  EXPECT_EQ(board.depth, 1U);
  EXPECT_EQ(board.why_no_more, "a board holds one request at a time");
}

TEST(Split, AnActionIsAskedForBeforeItIsNeeded) {
  // The filter reads it at once, whatever is behind the filter.
  const auto at_once = planned("agent: {part: mind}", "30", "actions.voltage", ", delay: 0.1");
  const PartLink agent = at_once->plan->split->links.front();
  EXPECT_TRUE(agent.is_pipelined);
  EXPECT_TRUE(is_pipelined(*at_once->plan, Part::hub, Graph::kEnvironment));
  EXPECT_FALSE(is_pipelined(*at_once->plan, Part::placed(0), Graph::kEnvironment));
  EXPECT_EQ(agent.depth, 1U);
  EXPECT_EQ(agent.why_no_more, "`smooth.signal` reads it with no `delay`");
  const auto late = planned("agent: {part: mind}", "30", "actions.voltage, delay: 0.1");
  EXPECT_EQ(late->plan->split->links.front().depth, 4U);
  EXPECT_EQ(late->plan->split->links.front().why_no_more,
            "`smooth.signal` reads it with `delay: 0.1`");
}

TEST(Split, WhatAnotherPartReadsLateIsHandedOnLate) {
  const auto lags = [](const std::string& delay) {
    const auto result = planned("smooth: {part: filter}, agent: {part: mind}", "30",
                                "actions.voltage" + delay, ", delay: 0.2");
    return result->plan->split->links;
  };
  const std::vector<PartLink> at_once = lags("");
  EXPECT_EQ(at_once[0].lags[Graph::kEnvironment], 0U);
  EXPECT_EQ(at_once[1].depth, 1U);
  EXPECT_EQ(at_once[1].why_no_more, "part `filter` reads it with no `delay`");
  EXPECT_EQ(at_once[0].depth, 7U);
  const std::vector<PartLink> late = lags(", delay: 0.1");
  EXPECT_EQ(late[0].lags[Graph::kEnvironment], 3U);
  EXPECT_EQ(late[1].lags[Graph::kEnvironment], 0U);
  EXPECT_EQ(late[1].depth, 4U);
  EXPECT_EQ(late[1].why_no_more, "part `filter` reads it with `delay: 0.1`");
  // The hub does not wait for messages that arrive between two ticks.
  EXPECT_EQ(lags(", delay: 0.095")[0].lags[Graph::kEnvironment], 2U);
  EXPECT_EQ(lags(", delay: 0.1, max_delay: 0.2")[0].lags[Graph::kEnvironment], 0U);
  EXPECT_EQ(lags(", delay: 0.1, skip: true, window: 0")[0].lags[Graph::kEnvironment], 0U);
}

TEST(Split, TheControllerIsWhatNothingElsePlaces) {
  const auto result = planned("controller: mps2-an386, smooth: {part: filter}");
  const Placement& placement = *result->graph->placement;
  EXPECT_EQ(placement.parts[placement.part_of[Graph::kEnvironment]].name, "mps2-an386");
  for (std::size_t n = 0; n < result->graph->nodes.size(); ++n) {
    if (result->graph->nodes[n].name == "smooth") {
      EXPECT_EQ(placement.parts[placement.part_of[n]].name, "filter");
    }
  }
}

}  // namespace
}  // namespace eagerx::gen

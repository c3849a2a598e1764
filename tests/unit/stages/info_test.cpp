// Facts about a plan, and its budgets.
#include "generator/analysis/info/info.hpp"

#include "tests/unit/stages/graphs.hpp"

namespace eagerx::gen {
namespace {

TEST(Info, JsonSaysWhatTheTextSays) {
  const auto graph = graph_of_text(swing());
  const PlanInfo info = info_of(*graph->plan, graph->spec->budget, graph->diagnostics);
  const auto json = parse_json(dump_json(info_json(info)));
  ASSERT_TRUE(json);
  EXPECT_EQ(text_of(member(&*json, "name")), "swing");
  EXPECT_EQ(text_of(member(&*json, "engine")), "OdeEngine");
  const Json* buffers = member(&*json, "buffers");
  ASSERT_TRUE(buffers != nullptr && buffers->is<Json::List>());
  EXPECT_EQ(buffers->as<Json::List>()->size(), graph->plan->rings.size());
  const Json* ages = member(&*json, "ages");
  ASSERT_TRUE(ages != nullptr && ages->is<Json::List>());
  EXPECT_EQ(ages->as<Json::List>()->size(), info.ages.size());
  EXPECT_NE(plan_text(info).find("30"), std::string::npos);
  EXPECT_EQ(telemetry_text(*graph->plan), "");
  EXPECT_EQ(task_text(*graph->graph), "");
}

/// Codes of the problems with a budget.
std::string codes_of(const std::string& budget) {
  std::string text = swing("30", "budget: " + budget + "\n");
  const std::string last = "to: observations.angle";
  text.insert(text.find(last) + last.size(), ", delay: 0.1");
  const auto graph = graph_of_text(text);
  const PlanInfo info = info_of(*graph->plan, graph->spec->budget, graph->diagnostics);
  if (graph->spec->budget) check_plan_budget(info, *graph->spec->budget, graph->diagnostics);
  return graph->codes();
}

TEST(Info, ABudgetThatIsKeptSaysNothing) {
  EXPECT_EQ(codes_of("{age: 1}"), "");
  EXPECT_EQ(codes_of("{link: 1000000}"), "");
}

TEST(Info, ABudgetThatIsExceededIsAnError) {
  EXPECT_EQ(codes_of("{age: 0.001}"), "E0420");
  EXPECT_EQ(codes_of("{link: 10}"), "E0420");
}

TEST(Info, ABudgetNamesWhatThereIs) {
  EXPECT_EQ(codes_of("{age: [{from: pendulum.thetta, at_most: 1}]}"), "E0424");
}

/// Of a filter in a part of its own.
std::unique_ptr<GraphOfText> placed(const std::string& where, const std::string& more = "") {
  return graph_of_text(
      "name: tested\nrate: 30\nengine: {type: OdeEngine, rate: 30}\nobjects: {arm: {type: "
      "Pendulum}}\nnodes:\n  smooth: {type: ButterworthFilter, rate: 30, config: {cutoff_hz: 5}}\n"
      "actions: {voltage: {space: {like: arm.u}}}\nobservations: [angle]\nconnections:\n"
      "  - {from: actions.voltage, to: smooth.signal}\n  - {from: smooth.filtered, to: arm.u}\n"
      "  - {from: arm.theta, to: observations.angle}\nplacement: {" +
      where + "}\n" + more);
}

TEST(Info, APartSaysWhatCrossesItsLinkAndWhatThatCosts) {
  EXPECT_EQ(parts_text(*graph_of_text(swing())->plan, std::nullopt), "");
  const auto graph = placed("smooth: {part: filter, host: pc}", "budget: {parts: 19200}\n");
  EXPECT_EQ(parts_text(*graph->plan, graph->spec->budget), R"(
parts: programs of their own, each with a link to the hub, `host`
  filter, for linux-sim on pc
    takes       actions.voltage (4 B at 30 Hz)
    gives       smooth.filtered (4 B at 30 Hz)
    a step      1 exchange, 34 bytes with their frames
    the hub     waits for a message where it is read: `arm.u` reads it with no `delay`
    real time   1020 bytes/s, 9 % of a serial line at 115200 baud
    added age   none in lockstep, where a step waits; in real time over such a line 2.95 of the 33.33 ms of a step
    budget      19200 baud, of which it needs 10200
)");
  const auto two = placed("smooth: mps2-an386, agent: {part: mind}");
  const std::string text = parts_text(*two->plan, std::nullopt);
  EXPECT_NE(text.find("\n  mps2-an386, for mps2-an386\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\n  mind, for linux-sim on this machine\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\n  all of them: 2 exchanges and "), std::string::npos) << text;
  EXPECT_EQ(text.find("budget"), std::string::npos) << text;
}

TEST(Info, TelemetryIsOfBoardsThatAreNoParts) {
  const auto graph = placed("smooth: linux-sim", "telemetry: {channels: [smooth.filtered]}\n");
  EXPECT_EQ(telemetry_text(*graph->plan), "");
}

}  // namespace
}  // namespace eagerx::gen

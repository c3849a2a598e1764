// What a plan says of itself, and its budgets.
#include "generator/info/info.hpp"

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

}  // namespace
}  // namespace eagerx::gen

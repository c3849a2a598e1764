// Bounds of slots against the rates of a graph, and budgets of time.
#include "generator/analysis/fit/fit.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "generator/analysis/fit/steps.hpp"
#include "tests/unit/graph_of_text.hpp"

namespace eagerx::gen {
namespace {

/// A servo: 1 kHz, 500 Hz and, with the environment, 100 Hz.
std::unique_ptr<GraphOfText> cascade(const std::string& budget = "{}") {
  std::ifstream file(EAGERX_SOURCE_DIR "/tests/budget/cascade.yaml");
  return graph_of_text(std::string(std::istreambuf_iterator<char>(file), {}) + "budget: " + budget);
}

InstructionBound row(const std::string& name, std::uint64_t cycles) {
  return {name, cycles, cycles, true};
}

/// At 10 MHz, 1000 cycles are 100 us.
BoundReport report() {
  BoundReport report;
  report.time = TimeModel{"board", "Cortex-M4F", 10'000'000, 0, {}};
  report.parts = {row("step", 20'000), row("schedule", 10), row("policy", 500), row("guard", 90)};
  report.slots = {{row("1000 Hz", 1000), 1},
                  {row("1000 Hz, 500 Hz", 2000), 3},
                  {row("1000 Hz, 500 Hz, 100 Hz", 4000), 7}};
  report.nodes = {row("speed", 300), row("engine", 700), row("position", 1400)};
  return report;
}

TEST(Fit, AddsUpTheSlotsOfAHyperperiod) {
  const auto graph = cascade();
  const auto fit = fit_of(report(), *graph->plan);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->busiest.name, "1000 Hz, 500 Hz, 100 Hz");
  EXPECT_NEAR(fit->busiest.busy_s, 460e-6, 1e-12);
  EXPECT_NEAR(fit->busiest.until_next_s, 1e-3, 1e-12);
  EXPECT_NEAR(fit->hyperperiod_s, 10e-3, 1e-12);
  EXPECT_NEAR(fit->busy_s, 460e-6 + 4 * 201e-6 + 5 * 101e-6, 1e-12);
  ASSERT_EQ(fit->outputs.size(), 3U);
  // Each rate is due in the longest slot, whose outputs do not wait for the policy.
  for (const Fit::Outputs& outputs : fit->outputs) EXPECT_NEAR(outputs.latest_s, 401e-6, 1e-12);
}

TEST(Fit, SaysTheBusiestSlotInOneLine) {
  const auto graph = cascade();
  EXPECT_EQ(
      busiest_text(*fit_of(report(), *graph->plan)),
      "the slot of 1000 Hz, 500 Hz, 100 Hz takes up to 46.0 % of its time, 460.0 us of 1000.0 us");
}

TEST(Fit, TakesTheLongestOfIndistinguishableSlots) {
  const auto graph = cascade();
  BoundReport any = report();
  any.slots = {{row("any slot", 3000), std::nullopt}};
  const auto fit = fit_of(any, *graph->plan);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->busy_s, 10 * 301e-6 + 59e-6, 1e-12);
}

TEST(Fit, NeedsTimesAndAllBounds) {
  const auto graph = cascade();
  BoundReport without = report();
  without.time.reset();
  EXPECT_FALSE(fit_of(without, *graph->plan));
  BoundReport unbound = report();
  unbound.slots[0].is_bound = false;
  EXPECT_FALSE(fit_of(unbound, *graph->plan));
}

/// The servo with five steps in a hyperperiod of ten slots.
std::unique_ptr<GraphOfText> with_five_steps() {
  std::ifstream file(EAGERX_SOURCE_DIR "/tests/budget/cascade.yaml");
  std::string text(std::istreambuf_iterator<char>(file), {});
  text.replace(text.find("rate: 100\n"), 9, "rate: 500");
  return graph_of_text(text);
}

SlotBound slot(std::uint64_t due, std::uint64_t before, std::uint64_t after) {
  return {row("", before + after), due, {before, before}, {after, after}};
}

BoundReport of_five_steps() {
  BoundReport bounds = report();
  bounds.slots = {slot(1, 100, 20), slot(3, 300, 40), slot(7, 1000, 50)};
  return bounds;
}

TEST(Steps, HaveTheSlotsThatAreDueInEach) {
  const auto graph = with_five_steps();
  ASSERT_EQ(graph->plan->schedule.form, ScheduleForm::kinds);
  const auto steps = step_bounds(of_five_steps(), *graph->plan);
  ASSERT_TRUE(steps);
  EXPECT_EQ(steps->steps, 5U);
  // With the schedule, 10: after the observation at 7, slot 1, before that at 3; and so on.
  const std::uint64_t first = 10 + 50 + 120 + 300, usual = 10 + 40 + 120 + 300;
  const std::uint64_t last = 10 + 40 + 120 + 1000;
  EXPECT_EQ(steps->longest.most, last);
  EXPECT_EQ(steps->longest.cycles, last);
  EXPECT_EQ(steps->hyperperiod.most, first + 3 * usual + last);
}

TEST(Steps, AreNeverLongerThanTheBoundOfAnyStep) {
  const auto graph = with_five_steps();
  BoundReport bounds = of_five_steps();
  bounds.parts[0].most = 1100;
  EXPECT_EQ(step_bounds(bounds, *graph->plan)->longest.most, 1100U);
  bounds.parts[0].is_bound = false;
  EXPECT_EQ(step_bounds(bounds, *graph->plan)->longest.most, 1170U);
}

TEST(Steps, NeedTheBoundsOfAllKindsOfSlots) {
  const auto graph = with_five_steps();
  BoundReport none = of_five_steps();
  none.slots.pop_back();
  EXPECT_FALSE(step_bounds(none, *graph->plan));
  BoundReport unbound = of_five_steps();
  unbound.slots[1].is_bound = false;
  EXPECT_FALSE(step_bounds(unbound, *graph->plan));
  // Where each step is a hyperperiod, the bound of a step has just its slots.
  EXPECT_FALSE(step_bounds(of_five_steps(), *cascade()->plan));
}

std::vector<Diagnostic> problems(const std::string& budget, const BoundReport& bounds) {
  const auto graph = cascade(budget);
  Diagnostics diagnostics;
  check_time_budget(bounds, fit_of(bounds, *graph->plan), *graph->plan, *graph->spec->budget,
                    diagnostics);
  return diagnostics.all();
}

TEST(TimeBudget, IsKeptUpToItsLimit) {
  EXPECT_TRUE(problems("{time: 46 %, slot: 460 us}", report()).empty());
  EXPECT_TRUE(problems("{time: 0.5, slot: 1 ms}", report()).empty());
}

TEST(TimeBudget, NamesTheSlotAndTheNodesThatTakeMost) {
  const auto found = problems("{time: 40 %, slot: 400 us}", report());
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].code, "E0420");
  EXPECT_EQ(found[0].message,
            "the slot of 1000 Hz, 500 Hz, 100 Hz takes up to 46.0 % of the time until the next "
            "one, over its budget of 40 %");
  EXPECT_EQ(found[1].message,
            "the slot of 1000 Hz, 500 Hz, 100 Hz takes up to 460.0 us, 60.0 us over its budget of "
            "400 us");
  for (const Diagnostic& problem : found) {
    EXPECT_GT(problem.span.line, 0U);
    EXPECT_EQ(problem.help.text,
              "most of it, in a step: `position` 140.0 us, `engine` 70.0 us, `policy` 50.0 us");
  }
}

TEST(TimeBudget, NamesTheNodesOfThatSlotWhereTheyAreKnown) {
  BoundReport with_nodes = report();
  with_nodes.slots[2].nodes = {row("position", 200), row("engine", 3000)};
  const auto found = problems("{slot: 400 us}", with_nodes);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].help.text,
            "most of it: `engine` 300.0 us, `policy` 50.0 us, `position` 20.0 us");
}

TEST(TimeBudget, OfWhatHasNoTimeIsAnError) {
  BoundReport without = report();
  without.time.reset();
  without.why_no_time = "no cycles are known of a core `Cortex-M7`";
  const auto found = problems("{slot: 1 s}", without);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "E0422");
  EXPECT_EQ(found[0].message,
            "the time of slots has a budget, but no bound: no cycles are known of a core "
            "`Cortex-M7`");
}

}  // namespace
}  // namespace eagerx::gen

#include "generator/graph/plan/schedule.hpp"

#include <gtest/gtest.h>

#include <map>

#include "tests/unit/plan/expected_count.hpp"

namespace eagerx::gen {
namespace {

Graph graph_of(const std::vector<Rational>& rates) {
  Graph graph;
  for (const auto& rate : rates) {
    GraphNode node;
    node.name = "node" + std::to_string(graph.nodes.size());
    node.rate_hz = rate;
    graph.nodes.push_back(std::move(node));
  }
  return graph;
}

std::vector<RateClass> rates_of(const std::vector<Rational>& rates) {
  Diagnostics diagnostics;
  auto result = find_rates(graph_of(rates), diagnostics);
  EXPECT_TRUE(result && !diagnostics.has_errors());
  return result.value_or(std::vector<RateClass>{});
}

Schedule schedule_of(const std::vector<Rational>& rates, std::size_t nodes = 10) {
  return make_schedule(rates_of(rates), 0, nodes);
}

std::vector<Rational> parsed_all(const std::vector<const char*>& texts) {
  std::vector<Rational> result;
  for (const char* text : texts) result.push_back(parsed(text));
  return result;
}

/// Instants of the first `seconds`, in order, with the bits of the rates (fastest first) that tick
/// then.
std::vector<std::uint64_t> instants(const std::vector<RateClass>& rates, const Rational& seconds) {
  std::map<Rational, std::uint64_t, bool (*)(const Rational&, const Rational&)> due(
      [](const Rational& a, const Rational& b) { return a < b; });
  for (std::size_t i = 0; i < rates.size(); ++i) {
    for (std::int64_t n = 0; Rational(n) / rates[i].rate_hz < seconds; ++n)
      due[Rational(n) / rates[i].rate_hz] |= std::uint64_t{1} << i;
  }
  std::vector<std::uint64_t> masks;
  for (const auto& [time, mask] : due) masks.push_back(mask);
  return masks;
}

TEST(Rates, AreDistinctFastestFirstOnACommonGrid) {
  const auto rates = rates_of(parsed_all({"30", "60", "30", "20"}));
  ASSERT_EQ(rates.size(), 3U);
  EXPECT_EQ(rates[0].rate_hz, Rational(60));
  EXPECT_EQ(rates[1].rate_hz, Rational(30));
  EXPECT_EQ(rates[2].rate_hz, Rational(20));
  EXPECT_EQ(rates[0].period, 1U);
  EXPECT_EQ(rates[1].period, 2U);
  EXPECT_EQ(rates[2].period, 3U);
}

TEST(Rates, PeriodsKeepTheirProportions) {
  const auto texts = parsed_all({"30", "29.97", "30000/1001", "12.5", "0.5", "1000"});
  const auto rates = rates_of(texts);
  for (const auto& a : rates) {
    for (const auto& b : rates) {
      EXPECT_EQ(Rational(static_cast<std::int64_t>(a.period)) * a.rate_hz,
                Rational(static_cast<std::int64_t>(b.period)) * b.rate_hz);
    }
  }
}

TEST(Rates, WithoutACommonGridAreAnErrorAtTheirNode) {
  Diagnostics diagnostics;
  Graph graph = graph_of(parsed_all({"30", "1000.000000001", "29.9700299700299700"}));
  graph.nodes[2].span.line = 7;
  EXPECT_FALSE(find_rates(graph, diagnostics));
  ASSERT_EQ(diagnostics.error_count(), 1U);
  EXPECT_EQ(diagnostics.all().front().code, "E0402");
  EXPECT_EQ(diagnostics.all().front().span.line, 7U);
}

TEST(Rates, SixtyFourAreTheMost) {
  std::vector<Rational> rates;
  for (int i = 1; i <= 64; ++i) rates.push_back(Rational(i) / Rational(2));
  Diagnostics diagnostics;
  EXPECT_TRUE(find_rates(graph_of({rates.begin(), rates.begin() + 40}), diagnostics));
  EXPECT_FALSE(diagnostics.has_errors());
  std::vector<Rational> harmonic;  // 2^-k Hz: sixty-one have a common grid
  for (int i = 0; i <= 60; ++i) harmonic.push_back(Rational(1) / Rational(std::int64_t{1} << i));
  EXPECT_TRUE(find_rates(graph_of(harmonic), diagnostics));
  for (int i = 0; i < 4; ++i) harmonic.push_back(Rational(3 + 2 * i));
  EXPECT_FALSE(find_rates(graph_of(harmonic), diagnostics));
  ASSERT_EQ(diagnostics.error_count(), 1U);
  EXPECT_EQ(diagnostics.all().front().code, "E0403");
}

TEST(Schedule, SlotsAreTheInstantsOfTheHyperperiod) {
  const std::vector<std::vector<const char*>> graphs = {
      {"30"},      {"30", "60"},   {"20", "60", "30"}, {"10", "15", "6"},
      {"7", "30"}, {"12.5", "10"}, {"0.5", "2", "3"}};
  for (const auto& texts : graphs) {
    const auto rates = rates_of(parsed_all(texts));
    const Schedule schedule = make_schedule(rates, 0, 10);
    ASSERT_NE(schedule.form, ScheduleForm::countdown);
    ASSERT_EQ(schedule.slots, schedule.masks.size());
    const Rational hyperperiod = [&] {
      Rational period = Rational(1) / rates[0].rate_hz;
      for (const auto& rate : rates) period = lcm(period, Rational(1) / rate.rate_hz);
      return period;
    }();
    EXPECT_EQ(schedule.masks, instants(rates, hyperperiod)) << texts.front();
    // Twice around is the same again.
    std::vector<std::uint64_t> twice = schedule.masks;
    twice.insert(twice.end(), schedule.masks.begin(), schedule.masks.end());
    EXPECT_EQ(twice, instants(rates, hyperperiod * Rational(2))) << texts.front();
  }
}

TEST(Schedule, IsWrittenOutWhereAStepIsTheHyperperiod) {
  EXPECT_EQ(schedule_of({30}).form, ScheduleForm::constants);
  EXPECT_EQ(make_schedule(rates_of({30, 60}), 1, 10).form,
            ScheduleForm::constants);  // the environment at 30 Hz
}

TEST(Schedule, IsATableOfKindsWhereAStepIsAPartOfTheHyperperiod) {
  const auto rates = rates_of({30, 60});
  const Schedule schedule = make_schedule(rates, 0, 10);  // the environment at 60 Hz
  EXPECT_EQ(schedule.form, ScheduleForm::kinds);
  EXPECT_EQ(schedule.masks, (std::vector<std::uint64_t>{3, 1}));
  EXPECT_EQ(schedule.kinds, (std::vector<std::uint64_t>{3, 1}));
  const Schedule several = make_schedule(rates_of({60, 30, 20, 15, 10}), 4, 10);
  EXPECT_EQ(several.form, ScheduleForm::kinds);
  EXPECT_EQ(several.masks.size(), 12U);
  EXPECT_EQ(several.kinds.size(), 6U);
}

TEST(Schedule, IsATableOfMasksWhereSpecialisationsWouldBeTooMuchText) {
  const auto rates = rates_of({30, 60});  // two kinds of slots
  EXPECT_EQ(make_schedule(rates, 1, 300).form, ScheduleForm::constants);
  EXPECT_EQ(make_schedule(rates, 1, 301).form, ScheduleForm::table);
  EXPECT_EQ(make_schedule(rates, 0, 300).form, ScheduleForm::kinds);
  EXPECT_EQ(make_schedule(rates, 0, 301).form, ScheduleForm::table);
  const Schedule schedule = make_schedule(rates_of({630, 420, 315, 252, 180, 140}), 0, 7);
  EXPECT_EQ(schedule.kinds.size(), 35U);
  EXPECT_EQ(schedule.form, ScheduleForm::table);
}

TEST(Schedule, OfARoutineThatMayEndAtAnySlotHasMasks) {
  const auto rates = rates_of({30, 60});
  EXPECT_EQ(make_schedule(rates, 1, 10, true).form, ScheduleForm::table);
  EXPECT_EQ(make_schedule(rates, 0, 10, true).form, ScheduleForm::table);
  EXPECT_EQ(make_schedule(rates_of({30}), 0, 10, true).form, ScheduleForm::constants);
}

TEST(Schedule, RunsAreAllSlotsInOrder) {
  const Schedule schedule = make_schedule(rates_of({10, 60, 20}), 0, 10);
  std::vector<std::uint64_t> masks;
  for (const auto& run : schedule.runs) masks.insert(masks.end(), run.slots, run.mask);
  EXPECT_EQ(masks, schedule.masks);
  EXPECT_EQ(schedule.runs.size(), 4U);  // all, two fast ones, 20 Hz too, two fast ones
}

TEST(Schedule, LongRunsOfEqualSlotsAreLoops) {
  const auto rates = rates_of({1, 1000});
  EXPECT_EQ(make_schedule(rates, 1, 10).form, ScheduleForm::constants);  // 999 equal slots
  const auto many = rates_of({1, 5000});
  EXPECT_EQ(make_schedule(many, 1, 10).form, ScheduleForm::constants);
  EXPECT_EQ(make_schedule(many, 0, 10).form,
            ScheduleForm::countdown);  // as a table it would be too long
}

TEST(Schedule, ExplodingHyperperiodsAreCountedDown) {
  const auto rates = rates_of(parsed_all({"30", "29.97"}));
  const Schedule schedule = make_schedule(rates, 0, 10);
  EXPECT_EQ(schedule.form, ScheduleForm::countdown);
  EXPECT_TRUE(schedule.masks.empty());
  // 3000 + 2997 ticks in 100 s, of which 3 coincide
  EXPECT_EQ(rates[0].period * 3000, rates[1].period * 2997);
}

TEST(Schedule, HyperperiodsBeyondTheNumbersAreCountedDown) {
  std::vector<Rational> rates;
  for (const int prime : {101, 103, 107, 109, 113, 127, 131, 137, 139, 149, 151})
    rates.push_back(Rational(1) / Rational(prime));
  EXPECT_EQ(schedule_of(rates).form, ScheduleForm::countdown);
  EXPECT_FALSE(schedule_of(rates).slots);
}

}  // namespace
}  // namespace eagerx::gen

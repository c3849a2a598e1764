#include "generator/graph/plan/receptions.hpp"

#include <gtest/gtest.h>

#include "tests/unit/plan/expected_count.hpp"

namespace eagerx::gen {
namespace {

/// The real sequence: both nodes tick in the order of their times, messages are numbered, and every
/// tick looks at its window. How far back it looked is what the ring must hold.
struct Happened {
  std::uint64_t keep =
      1;  // most messages between the oldest that is looked at and the newest that is sent
  std::uint64_t window = 0;  // most messages in a window
  std::uint64_t least = 1'000'000;
  bool counts_agree = true;
};

Happened run(const Connection& c, std::uint32_t window, bool source_first, std::int64_t ticks) {
  Happened happened;
  std::int64_t sent = 0, total = 0;
  for (std::int64_t tick = 0; tick < ticks; ++tick) {
    const Rational now = Rational(tick) / c.rate;
    const auto is_sent = [&] {
      const Rational at = Rational(sent) / c.source_rate;
      return source_first ? at <= now : at < now;
    };
    while (is_sent()) ++sent;
    const std::int64_t arrived = expected_count(c, tick);
    total += arrived;
    const std::int64_t held = window == 0 ? arrived : std::min<std::int64_t>(window, total);
    if (total > sent) happened.counts_agree = false;  // from the future
    if (held > 0)
      happened.keep = std::max(happened.keep, static_cast<std::uint64_t>(sent - (total - held)));
    happened.window = std::max(happened.window, static_cast<std::uint64_t>(held));
    happened.least = std::min(happened.least, static_cast<std::uint64_t>(held));
  }
  return happened;
}

Input input_of(const Connection& c, std::uint32_t window) {
  Input input;
  input.name = "signal";
  input.written = "node.signal";
  input.delay_s = c.delay_s;
  input.skip = c.skip;
  input.window = window;
  return input;
}

ReceptionEnds ends_of(const Connection& c, bool source_first) {
  return {.source_rate_hz = c.source_rate, .rate_hz = c.rate, .source_first = source_first};
}

std::optional<Reception> plan(const Connection& c, std::uint32_t window, bool source_first) {
  Diagnostics diagnostics;
  auto reception = plan_reception(input_of(c, window), ends_of(c, source_first), diagnostics);
  EXPECT_EQ(reception.has_value(), !diagnostics.has_errors());
  return reception;
}

std::string describe(const Connection& c, std::uint32_t window, bool source_first) {
  return c.source_rate.to_string() + " Hz to " + c.rate.to_string() + " Hz, delay " +
         c.delay_s.to_string() + " s, window " + std::to_string(window) +
         (c.skip ? ", skipped" : "") + (source_first ? ", source first" : ", source last");
}

std::vector<Rational> few_rates() {
  return {1, 2, 3, 5, 7, 30, parsed("12.5")};
}

/// Calls `test(connection, window, source_first)` for everything that can be planned.
template <class Test>
void for_each_connection(Test&& test) {
  for (const Rational& source_rate : few_rates()) {
    for (const Rational& rate : few_rates()) {
      for (const Rational& delay : {Rational(0), parsed("0.07"), parsed("0.5"),
                                    Rational(1) / source_rate, Rational(2) / rate}) {
        for (const std::uint32_t window : {0U, 1U, 2U, 5U}) {
          test(Connection{source_rate, rate, delay, false}, window,
               true);  // without skip the source always runs first
          for (const bool source_first : {true, false})
            test(Connection{source_rate, rate, delay, true}, window, source_first);
        }
      }
    }
  }
}

/// Long enough for the delay to pass, the window to fill, and the pattern to come round twice.
std::int64_t enough_ticks(const Connection& c, std::uint32_t window) {
  const Counts counts = counts_of(c);
  return (counts.x + counts.b) / counts.a + 4 + (window + 1) * (counts.b / counts.a + 1) +
         2 * counts.b;
}

TEST(Receptions, RingsAreExactlyAsLargeAsNeeded) {
  int planned_connections = 0;
  for_each_connection([&](const Connection& c, std::uint32_t window, bool source_first) {
    const auto planned = plan(c, window, source_first);
    if (!planned) return;
    ++planned_connections;
    const Happened happened = run(c, window, source_first, enough_ticks(c, window));
    EXPECT_TRUE(happened.counts_agree) << describe(c, window, source_first);
    EXPECT_EQ(planned->keep, happened.keep) << describe(c, window, source_first);
    EXPECT_EQ(planned->max_size, std::max<std::uint64_t>(1, happened.window))
        << describe(c, window, source_first);
    if (planned->always_full) {
      EXPECT_EQ(happened.least, planned->max_size) << describe(c, window, source_first);
    }
  });
  EXPECT_GT(planned_connections, 1000);
}

/// Plans with delays from 0 to the longest; nullopt if some of them starve the input.
std::optional<Reception> plan_changing(const Connection& c, std::uint32_t window,
                                       bool source_first) {
  Diagnostics diagnostics;
  Input input = input_of(c, window);
  input.max_delay_s = c.delay_s;
  input.delay_s = Rational(0);
  return plan_reception(input, ends_of(c, source_first), diagnostics);
}

TEST(Receptions, RingsOfChangingDelaysHoldWhatAnyDelayNeedsAndNoMore) {
  int planned_connections = 0;
  for_each_connection([&](const Connection& c, std::uint32_t window, bool source_first) {
    const auto planned = plan_changing(c, window, source_first);
    if (!planned) return;
    ++planned_connections;
    std::uint64_t keep = 1, held = 1;
    constexpr int kSteps = 40;
    for (int i = 0; i <= kSteps; ++i) {
      const Connection delayed{c.source_rate, c.rate, c.delay_s * Rational(i, kSteps), c.skip};
      const Happened happened = run(delayed, window, source_first, enough_ticks(c, window));
      keep = std::max(keep, happened.keep);
      held = std::max(held, happened.window);
    }
    EXPECT_EQ(planned->keep, keep) << describe(c, window, source_first);
    EXPECT_EQ(planned->max_size, held) << describe(c, window, source_first);
    ASSERT_TRUE(planned->changing);
    EXPECT_TRUE(planned->count == Reception::Count::delayed ||
                planned->count == Reception::Count::skipped);
  });
  EXPECT_GT(planned_connections, 500);
}

TEST(Receptions, ALongestDelayThatAnEntitySetsHoldsAsFloat) {
  const Connection c{Rational(30), Rational(30), parsed("0.1"), false};
  Diagnostics diagnostics;
  Input input = input_of(c, 1);
  input.max_delay_s = c.delay_s;
  const auto sampled = plan_reception(input, ends_of(c, true), diagnostics);
  input.entity_sets_delay = true;
  const auto set = plan_reception(input, ends_of(c, true), diagnostics);
  ASSERT_TRUE(sampled && set);
  EXPECT_EQ(sampled->changing->longest_ns, 100'000'000);
  EXPECT_EQ(set->changing->longest_ns, 100'000'002);  // 0.1F is 0.1000000014901161 s
  EXPECT_EQ(set->keep, sampled->keep + 1);
}

TEST(Receptions, OnlySkippedInputsWithoutAMessageAtTickOneAreRefused) {
  for_each_connection([&](const Connection& c, std::uint32_t window, bool source_first) {
    const bool starves = c.skip && window > 0 && expected_count(c, 0) + expected_count(c, 1) == 0;
    EXPECT_EQ(!plan(c, window, source_first), starves) << describe(c, window, source_first);
  });
}

TEST(Receptions, TheDelayThatIsRecommendedWorksAndNoLongerOneDoes) {
  int recommended = 0;
  for_each_connection([&](const Connection& c, std::uint32_t window, bool source_first) {
    Diagnostics diagnostics;
    if (plan_reception(input_of(c, window), ends_of(c, source_first), diagnostics)) return;
    const std::string& help = diagnostics.all().front().help.text;
    const std::string begin = "shorten the delay to at most ";
    if (!help.starts_with(begin)) return;
    const Rational longest =
        parsed(help.substr(begin.size(), help.find(' ', begin.size()) - begin.size()).c_str());
    EXPECT_TRUE(plan({c.source_rate, c.rate, longest, true}, window, source_first))
        << describe(c, window, source_first) << help;
    EXPECT_FALSE(
        plan({c.source_rate, c.rate, longest + parsed("1e-9"), true}, window, source_first))
        << describe(c, window, source_first) << help;
    ++recommended;
  });
  EXPECT_GT(recommended, 10);
}

TEST(Receptions, TakeTheCheapestCount) {
  const auto count = [](const char* source_rate, const char* rate, const char* delay, bool skip) {
    return plan({parsed(source_rate), parsed(rate), parsed(delay), skip}, 1, !skip).value().count;
  };
  EXPECT_EQ(count("30", "30", "0", false), Reception::Count::ticks);
  EXPECT_EQ(count("30", "7", "0", false), Reception::Count::ticks);
  EXPECT_EQ(count("30", "30", "0.001", false), Reception::Count::delayed);
  EXPECT_EQ(count("30", "30", "0", true), Reception::Count::ticks_but_one);
  EXPECT_EQ(count("30", "10", "0", true), Reception::Count::ticks_but_one);
  EXPECT_EQ(count("10", "30", "0", true), Reception::Count::ticks_before);
  EXPECT_EQ(count("30", "7", "0", true), Reception::Count::skipped);
  EXPECT_EQ(count("30", "30", "0.03", true), Reception::Count::skipped);
}

TEST(Receptions, BoundCoversWhatIsTooLongToSimulate) {
  // 2^21 ticks and more until the pattern comes round: the bound may be larger than what is needed,
  // never smaller.
  const Connection c{parsed("1000003"), parsed("1000000"), parsed("0.0000005"), true};
  const auto planned = plan(c, 3, false);
  ASSERT_TRUE(planned);
  const Happened happened = run(c, 3, false, 20'000);
  EXPECT_GE(planned->keep, happened.keep);
  EXPECT_LE(planned->keep, happened.keep + 6);
  EXPECT_GE(planned->max_size, happened.window);
}

TEST(Receptions, WhatCannotBeCountedIsAnError) {
  Diagnostics diagnostics;
  const Connection c{parsed("1000000.0000001"), parsed("0.0000001"), 0, false};
  EXPECT_FALSE(plan_reception(input_of(c, 1), ends_of(c, true), diagnostics));
  ASSERT_EQ(diagnostics.error_count(), 1U);
  EXPECT_EQ(diagnostics.all().front().code, "E0402");
}

}  // namespace
}  // namespace eagerx::gen

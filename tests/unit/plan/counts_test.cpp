#include "generator/graph/plan/counts.hpp"

#include <gtest/gtest.h>

#include "tests/unit/plan/expected_count.hpp"

namespace eagerx::gen {
namespace {

std::string describe(const Connection& c) {
  return c.source_rate.to_string() + " Hz to " + c.rate.to_string() + " Hz, delay " +
         c.delay_s.to_string() + (c.skip ? " s, skipped" : " s");
}

TEST(Counts, EqualTheFormulaOfEagerx) {
  constexpr std::int64_t kTicks = 70;
  int configurations = 0;
  for (const Rational& source_rate : some_rates()) {
    for (const Rational& rate : some_rates()) {
      for (const Rational& delay : some_delays(source_rate, rate)) {
        for (const bool skip : {false, true}) {
          const Connection connection{source_rate, rate, delay, skip};
          const Counts counts = counts_of(connection);
          for (std::int64_t tick = 0; tick < kTicks; ++tick) {
            ASSERT_EQ(counts.at(tick), expected_count(connection, tick))
                << describe(connection) << ", tick " << tick;
          }
          ++configurations;
        }
      }
    }
  }
  EXPECT_GT(configurations, 5000);
}

TEST(Counts, WithoutSkipAMessageIsReceivedOnceItsDelayHasPassed) {
  for (const Rational& source_rate : some_rates()) {
    for (const Rational& rate : some_rates()) {
      for (const Rational& delay : some_delays(source_rate, rate)) {
        const Connection connection{source_rate, rate, delay, false};
        const Counts counts = counts_of(connection);
        std::int64_t total = 0;
        for (std::int64_t tick = 0; tick < 60; ++tick) {
          total += counts.at(tick);
          // seq 0 always, and every seq s with s/r_in + d <= N/r
          const std::int64_t passed = ((Rational(tick) / rate - delay) * source_rate).floor() + 1;
          ASSERT_EQ(total, std::max<std::int64_t>(1, passed))
              << describe(connection) << ", tick " << tick;
        }
      }
    }
  }
}

TEST(Counts, SentAndSendsAtFollowTheTimes) {
  for (const Rational& source_rate : some_rates()) {
    for (const Rational& rate : some_rates()) {
      const Counts counts = counts_of({source_rate, rate, 0, false});
      for (std::int64_t tick = 0; tick < 60; ++tick) {
        const Rational sent = Rational(tick) / rate * source_rate;
        ASSERT_EQ(counts.sent(tick), sent.floor() + 1);
        ASSERT_EQ(counts.sends_at(tick), sent.is_integer());
      }
    }
  }
}

TEST(Counts, DivisionRoundsDown) {
  EXPECT_EQ(floor_div(7, 2), 3);
  EXPECT_EQ(floor_div(-7, 2), -4);
  EXPECT_EQ(floor_div(-8, 2), -4);
  EXPECT_EQ(floor_div(0, 5), 0);
  EXPECT_EQ(floor_div(-1, 1'000'000'007), -1);
}

}  // namespace
}  // namespace eagerx::gen

// The run-time counters of runtime/eagerx/cursor.hpp against the generator's counts.
#include <gtest/gtest.h>

#include <eagerx/cursor.hpp>
#include <utility>

#include "generator/graph/plan/counts.hpp"

namespace eagerx::gen {
namespace {

constexpr std::int64_t kTicks = 700;
constexpr std::int64_t kDelays[] = {0, 1, 2, 3, 5, 7, 8, 30, 100, 1001};

template <std::int64_t A, std::int64_t B>
void compare_delayed() {
  for (const std::int64_t x : kDelays) {
    const Counts counts{A, B, x, false};
    eagerx::DelayCursor<A, B> cursor;
    for (int episode = 0; episode < 2; ++episode) {
      cursor.reset(x);
      std::int64_t total = 0;
      for (std::int64_t tick = 0; tick < kTicks; ++tick) {
        total += counts.at(tick);
        ASSERT_EQ(cursor.take(), static_cast<eagerx::Seq>(total))
            << A << "/" << B << ", x = " << x << ", tick " << tick;
      }
    }
  }
}

template <std::int64_t A, std::int64_t B>
void compare_skipped() {
  for (const std::int64_t x : kDelays) {
    const Counts counts{A, B, x, true};
    constexpr std::int64_t kOff = Counts{A, B, 0, true}.off();
    eagerx::SkipCursor<A, B, kOff> cursor;
    for (int episode = 0; episode < 2; ++episode) {
      cursor.reset(x);
      std::int64_t total = 0;
      for (std::int64_t tick = 0; tick < kTicks; ++tick) {
        total += counts.at(tick);
        ASSERT_EQ(cursor.take(), static_cast<eagerx::Seq>(total))
            << A << "/" << B << ", x = " << x << ", tick " << tick;
      }
    }
  }
}

template <std::int64_t A, std::int64_t B>
struct Ratio {
  static void compare() {
    compare_delayed<A, B>();
    compare_skipped<A, B>();
  }
};

template <class... Ratios>
void compare_all() {
  (Ratios::compare(), ...);
}

TEST(Cursor, CountsWhatThePlanCounts) {
  compare_all<Ratio<1, 1>, Ratio<1, 2>, Ratio<1, 3>, Ratio<1, 7>, Ratio<1, 50>, Ratio<2, 1>,
              Ratio<3, 1>, Ratio<7, 1>, Ratio<50, 1>, Ratio<2, 3>, Ratio<3, 2>, Ratio<3, 5>,
              Ratio<5, 3>, Ratio<7, 30>, Ratio<30, 7>, Ratio<12, 5>, Ratio<5, 12>, Ratio<100, 3>,
              Ratio<3, 100>, Ratio<999, 1000>, Ratio<1000, 999>, Ratio<1001, 1000>,
              Ratio<1000, 1001>>();
}

TEST(Cursor, SkippedWithoutDelayIsEverythingBeforeTheTickWhereOneRateDividesTheOther) {
  // Reception::Count::ticks_before and ticks_but_one rely on it.
  for (const auto& [a, b] :
       {std::pair<std::int64_t, std::int64_t>{1, 1}, {1, 4}, {4, 1}, {30, 1}, {1, 30}}) {
    const Counts counts{a, b, 0, true};
    std::int64_t total = 0;
    for (std::int64_t tick = 0; tick < kTicks; ++tick) {
      total += counts.at(tick);
      ASSERT_EQ(total, counts.sent(tick) - (counts.sends_at(tick) ? 1 : 0))
          << a << "/" << b << ", tick " << tick;
      if (b == 1) {
        ASSERT_TRUE(counts.sends_at(tick));
      }
    }
  }
}

TEST(Cursor, NewMessagesAreThoseSinceTheLastTick) {
  eagerx::NewMessages fresh;
  fresh.reset();
  EXPECT_EQ(fresh.take(1).held, 1U);
  EXPECT_EQ(fresh.take(1).held, 0U);
  const eagerx::Received received = fresh.take(5);
  EXPECT_EQ(received.end, 5U);
  EXPECT_EQ(received.held, 4U);
  fresh.reset();
  EXPECT_EQ(fresh.take(3).held, 3U);
}

TEST(Cursor, CountsForYears) {
  // Three years at 10 kHz, started far from zero: no sum overflows or drifts.
  constexpr std::int64_t kA = 1000, kB = 999;
  const std::int64_t ticks = 3LL * 365 * 86400 * 10'000;
  eagerx::FloorSequence<kA, kB> sequence;
  sequence.start(ticks, 17);
  for (std::int64_t n = ticks; n < ticks + 5000; ++n, sequence.advance()) {
    ASSERT_EQ(sequence.value(), floor_div(kA * n - 17, kB));
  }
}

}  // namespace
}  // namespace eagerx::gen

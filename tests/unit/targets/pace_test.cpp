// Slots of a board and steps on Linux on their deadlines, with a clock that the test moves.
#include <gtest/gtest.h>

#include <cstdint>
#include <eagerx/rate.hpp>
#include <targets/common/pace.hpp>
#include <targets/linux-sim/pacer.hpp>
#include <utility>

namespace eagerx::target {
namespace {

struct FakeClock {
  static inline std::uint64_t now = 0;
  static inline std::uint64_t stopped = 0;  // in the next wait
  static std::uint64_t ticks() { return now; }
  static void wait_for(std::uint64_t deadline) { now = deadline + std::exchange(stopped, 0); }
  static constexpr std::uint64_t hz() { return 168'000'000; }
};

constexpr std::int64_t kNsPerMs = 1'000'000;

TEST(PacedHooks, DeadlinesOfAnUnevenRateHoldForYears) {
  using Uneven = Rate<33'333'333, 1'000'000>;
  FakeClock::now = 1000;
  PacedHooks<FakeClock> hooks;
  hooks.set_pace(Pace::paced, kNsPerMs);
  hooks.wait_for_slot(Uneven{}, 0);
  std::uint64_t before = FakeClock::now;
  constexpr Seq kYear = 33'333'333ULL * 365 * 24 * 36 / 10;
  for (const Seq tick : {Seq{1}, Seq{109'802}, Seq{109'803}, kYear, kYear + 1}) {
    hooks.wait_for_slot(Uneven{}, tick);
    EXPECT_GT(FakeClock::now, before) << tick;
    before = FakeClock::now;
  }
  const auto seconds = static_cast<double>(FakeClock::now - 1000) / FakeClock::hz();
  EXPECT_NEAR(seconds, static_cast<double>(kYear + 1) / 33.333333, 1e-3);
  EXPECT_EQ(hooks.timing().late, 0U);
}

TEST(PacedHooks, AnEpisodeBeginsInTime) {
  PacedHooks<FakeClock> hooks;
  hooks.set_pace(Pace::paced, kNsPerMs);
  hooks.wait_for_slot(Rate<10>{}, 0);
  FakeClock::now += FakeClock::hz();
  hooks.wait_for_slot(Rate<10>{}, 1);
  EXPECT_EQ(hooks.timing().late_in_a_row, 1U);
  EXPECT_EQ(hooks.timing().too_late_in_a_row, 1U);
  hooks.wait_for_slot(Rate<10>{}, 0);
  EXPECT_EQ(hooks.timing().late_in_a_row, 0U);
  EXPECT_EQ(hooks.timing().too_late_in_a_row, 0U);
  EXPECT_EQ(hooks.timing().late, 1U) << "it is counted";
}

TEST(PacedHooks, APauseIsSeenBeforeTheAnswerIsApplied) {
  for (const bool asleep : {true, false}) {
    PacedHooks<FakeClock> hooks;
    hooks.set_pace(Pace::paced, 100 * kNsPerMs);
    hooks.wait_for_slot(Rate<10>{}, 0);
    if (asleep) FakeClock::stopped = FakeClock::hz();
    hooks.wait_for_slot(Rate<10>{}, 1);
    if (!asleep) FakeClock::now += FakeClock::hz();  // while the agent decides
    EXPECT_EQ(hooks.too_late_in_a_row(Rate<10>{}), 10U) << "a second of 100 ms each";
    hooks.wait_for_slot(Rate<10>{}, 12);
    EXPECT_EQ(hooks.too_late_in_a_row(Rate<10>{}), 0U);
  }
}

TEST(PacedHooks, AnAnswerHasAPeriod) {
  PacedHooks<FakeClock> hooks;
  hooks.set_pace(Pace::paced, kNsPerMs);
  hooks.wait_for_slot(Rate<10>{}, 0);
  hooks.wait_for_slot(Rate<10>{}, 1);
  FakeClock::now += FakeClock::hz() / 10;
  EXPECT_EQ(hooks.too_late_in_a_row(Rate<10>{}), 0U);
  FakeClock::now += 1;
  EXPECT_EQ(hooks.too_late_in_a_row(Rate<10>{}), 1U);
  hooks.set_pace(Pace::measured, kNsPerMs);
  EXPECT_EQ(hooks.too_late_in_a_row(Rate<10>{}), 0U) << "nothing is held to a deadline";
}

/// The same clock in nanoseconds.
struct FakeNs {
  static inline std::int64_t now = 0;
  static inline std::int64_t stopped = 0;  // in the next sleep
  static std::int64_t now_ns() { return now; }
  static void sleep_until(std::int64_t ns) { now = ns + std::exchange(stopped, 0); }
};
using FakePacer = linux_sim::PacerOn<FakeNs>;

TEST(Pacer, APauseIsSeenBeforeTheActionIsApplied) {
  for (const bool asleep : {true, false}) {
    FakePacer pacer(0.1, 1.0, 100 * kNsPerMs);
    pacer.start();
    if (asleep) FakeNs::stopped = 1000 * kNsPerMs;
    pacer.wait_for(1);
    if (!asleep) FakeNs::now += 1000 * kNsPerMs;
    EXPECT_EQ(pacer.late_in_a_row(), 10U);
    EXPECT_EQ(pacer.overruns(), 0U) << "no step took longer than it may";
    FakeNs::now += 1;
    pacer.wait_for(2);
    EXPECT_EQ(pacer.overruns(), 1U);
  }
}

TEST(Pacer, AStepThatBeginsLaterThanDeclaredIsLate) {
  FakePacer pacer(0.1, 1.0, 5 * kNsPerMs);
  pacer.start();
  FakeNs::stopped = 6 * kNsPerMs;
  pacer.wait_for(1);
  EXPECT_EQ(pacer.late_in_a_row(), 1U);
  FakeNs::stopped = 6 * kNsPerMs;
  pacer.wait_for(2);
  EXPECT_EQ(pacer.late_in_a_row(), 2U);
  pacer.wait_for(3);
  EXPECT_EQ(pacer.late_in_a_row(), 0U);
  FakeNs::now += 90 * kNsPerMs;
  EXPECT_EQ(pacer.late_in_a_row(), 0U) << "an action has a period";
}

TEST(Pacer, TimeThatStoodStillMakesNothingLate) {
  FakePacer pacer(0.1, 1.0, 5 * kNsPerMs);
  pacer.start();
  pacer.wait_for(1);
  FakeNs::now += 5000 * kNsPerMs;
  pacer.pause(5000 * kNsPerMs);
  EXPECT_EQ(pacer.late_in_a_row(), 0U);
  const std::int64_t before = FakeNs::now;
  pacer.wait_for(2);
  EXPECT_EQ(FakeNs::now - before, 100 * kNsPerMs);
  EXPECT_EQ(pacer.overruns(), 0U);
}

TEST(Pacer, KnowsUntilWhenAnActionIsInTime) {
  for (const std::int64_t max_lateness_ms : {5, 250}) {
    FakePacer pacer(0.1, 1.0, max_lateness_ms * kNsPerMs);
    pacer.start();
    pacer.wait_for(1);
    FakeNs::now = pacer.in_time_until_ns();
    EXPECT_EQ(pacer.late_in_a_row(), 0U);
    FakeNs::now += 1;
    EXPECT_EQ(pacer.late_in_a_row(), 1U);
  }
  EXPECT_EQ(FakePacer(0.1, 0.0, kNsPerMs).in_time_until_ns(), 0) << "always";
}

TEST(Pacer, WithoutPaceNothingIsLate) {
  FakePacer pacer(0.1, 0.0, 5 * kNsPerMs);
  pacer.start();
  FakeNs::now += 1000 * kNsPerMs;
  EXPECT_EQ(pacer.late_in_a_row(), 0U);
}

}  // namespace
}  // namespace eagerx::target

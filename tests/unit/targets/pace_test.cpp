// Slots of a board on their deadlines, with a clock that the test moves.
#include <gtest/gtest.h>

#include <cstdint>
#include <eagerx/rate.hpp>
#include <targets/common/pace.hpp>

namespace eagerx::target {
namespace {

struct FakeClock {
  static inline std::uint64_t now = 0;
  static std::uint64_t ticks() { return now; }
  static void wait_for(std::uint64_t deadline) { now = deadline; }
  static constexpr std::uint64_t hz() { return 168'000'000; }
};

constexpr std::int64_t kNsPerMs = 1'000'000;

TEST(PacedTrace, DeadlinesOfAnUnevenRateHoldForYears) {
  using Uneven = Rate<33'333'333, 1'000'000>;
  FakeClock::now = 1000;
  PacedTrace<FakeClock> trace;
  trace.set_pace(Pace::paced, kNsPerMs);
  trace.slot(Uneven{}, 0);
  std::uint64_t before = FakeClock::now;
  constexpr Seq kYear = 33'333'333ULL * 365 * 24 * 36 / 10;
  for (const Seq tick : {Seq{1}, Seq{109'802}, Seq{109'803}, kYear, kYear + 1}) {
    trace.slot(Uneven{}, tick);
    EXPECT_GT(FakeClock::now, before) << tick;
    before = FakeClock::now;
  }
  const auto seconds = static_cast<double>(FakeClock::now - 1000) / FakeClock::hz();
  EXPECT_NEAR(seconds, static_cast<double>(kYear + 1) / 33.333333, 1e-3);
  EXPECT_EQ(trace.timing().late, 0U);
}

TEST(PacedTrace, AnEpisodeBeginsInTime) {
  PacedTrace<FakeClock> trace;
  trace.set_pace(Pace::paced, kNsPerMs);
  trace.slot(Rate<10>{}, 0);
  FakeClock::now += FakeClock::hz();
  trace.slot(Rate<10>{}, 1);
  EXPECT_EQ(trace.timing().late_in_a_row, 1U);
  EXPECT_EQ(trace.timing().too_late_in_a_row, 1U);
  trace.slot(Rate<10>{}, 0);
  EXPECT_EQ(trace.timing().late_in_a_row, 0U);
  EXPECT_EQ(trace.timing().too_late_in_a_row, 0U);
  EXPECT_EQ(trace.timing().late, 1U) << "it is counted";
}

}  // namespace
}  // namespace eagerx::target

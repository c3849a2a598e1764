// eagerx/step_times.hpp: when your own main loop steps.
#include <gtest/gtest.h>

#include <cmath>
#include <eagerx/step_times.hpp>
#include <map>
#include <string>

namespace eagerx {
namespace {

constexpr std::int64_t kPeriodNs = 2'000'000;

template <class Times>
std::map<std::string, std::uint64_t> counts_of(const Times& times) {
  std::map<std::string, std::uint64_t> counts;
  times.for_each_count([&](const char* name, std::uint64_t n) { counts[name] = n; });
  return counts;
}

TEST(StepTimes, ThePeriodIsNotRounded) {
  StepTimes<Rate<30>> times;
  times.start(1000, 33'333'333);
  EXPECT_EQ(times.until_next(1000), 0U);
  for (int i = 0; i < 30; ++i) times.begin(times.next_us());
  EXPECT_EQ(times.next_us(), 1'001'000U) << "30 periods are a second";
  EXPECT_EQ(times.until_next(1'000'900), 100U);
  EXPECT_EQ(counts_of(times)["steps left out"], 0U);
}

TEST(StepTimes, AnyRateKeepsItsInstants) {
  StepTimes<Rate<30000, 1001>> times;
  times.start(0, 33'366'666);
  for (int i = 0; i < 30000; ++i) times.begin(times.next_us());
  EXPECT_EQ(times.next_us(), 1'001'000'000U);
  EXPECT_EQ(counts_of(times)["steps left out"], 0U);
}

TEST(StepTimes, LatenessDoesNotAddUp) {
  StepTimes<Rate<500>> times;
  times.start(0, kPeriodNs);
  for (std::uint64_t n = 0; n < 100; ++n) {
    times.begin(n * 2000 + 700);
    EXPECT_EQ(times.late_in_a_row(n * 2000 + 900), 0U) << "within a period";
  }
  EXPECT_EQ(times.next_us(), 200'000U);
  EXPECT_EQ(counts_of(times)["latest by us"], 700U);
  EXPECT_EQ(counts_of(times)["steps too late"], 0U);
}

TEST(StepTimes, APauseIsNotMadeUpFor) {
  StepTimes<Rate<500>> times;
  times.start(0, kPeriodNs);
  times.begin(0);
  times.begin(2000 + 7000);  // 3.5 periods late
  EXPECT_EQ(times.late_in_a_row(9000), 3U) << "a pause counts as the steps it lasts";
  EXPECT_EQ(times.next_us(), 10'000U) << "on the grid, not at once";
  EXPECT_EQ(counts_of(times)["steps left out"], 3U);
  times.begin(10'000);
  EXPECT_EQ(times.late_in_a_row(10'000), 0U);
}

TEST(StepTimes, SlowMeasurementsAreLateToo) {
  StepTimes<Rate<500>> times;
  times.start(0, kPeriodNs);
  times.begin(0);
  EXPECT_EQ(times.late_in_a_row(2000), 0U);
  EXPECT_EQ(times.late_in_a_row(2001), 1U);
  EXPECT_EQ(times.late_in_a_row(6001), 3U);
}

TEST(StepTimes, AShorterLatenessThanAPeriod) {
  StepTimes<Rate<500>> times;
  times.start(0, 500'000);
  times.begin(400);
  EXPECT_EQ(times.late_in_a_row(400), 0U);
  times.begin(2600);
  EXPECT_EQ(times.late_in_a_row(2600), 1U);
  times.begin(4600);
  EXPECT_EQ(times.late_in_a_row(4600), 2U);
}

TEST(StepTimes, AnHourInADebugger) {
  StepTimes<Rate<4000>> times;
  times.start(0, 250'000);
  times.begin(0);
  times.begin(3'600'000'100);
  EXPECT_EQ(times.until_next(3'600'000'100), 150U);
  EXPECT_GT(times.late_in_a_row(3'600'000'100), 14'000'000U);
}

TEST(WideClock, GoesOnWhere32BitsEnd) {
  WideClock clock;
  EXPECT_EQ(clock(0xffff'fff0U), 0xffff'fff0U);
  EXPECT_EQ(clock(0x10U), 0x1'0000'0010U);
  EXPECT_EQ(clock(0x10U), 0x1'0000'0010U);
}

TEST(NotMeasured, IsNoNumberWhereThereIsOne) {
  EXPECT_TRUE(std::isnan(not_measured<float>()));
  EXPECT_TRUE(std::isnan((not_measured<Array<float, 2>>()[1])));
  EXPECT_EQ((not_measured<Array<std::int32_t, 2>>()[1]), 0);
}

}  // namespace
}  // namespace eagerx

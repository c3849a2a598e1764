// eagerx/rate.hpp: exact rates and the times of ticks.
#include <gtest/gtest.h>

#include <eagerx/rate.hpp>

namespace eagerx {
namespace {

TEST(Rate, PeriodAndFrequency) {
  static_assert(Rate<50>::hz == 50.0);
  static_assert(Rate<50>::period_s == 0.02);
  static_assert(Rate<1, 3>::period_s == 3.0);
  EXPECT_EQ((Rate<1, 3>::hz), 1.0 / 3.0);
}

TEST(Rate, SecondsDoNotDrift) {
  EXPECT_EQ(Rate<30>::seconds<double>(0), 0.0);
  EXPECT_EQ(Rate<30>::seconds<double>(30), 1.0);
  EXPECT_EQ(Rate<30>::seconds<double>(30'000'000'007), 30'000'000'007 / 30.0);
  EXPECT_EQ((Rate<100, 3>::seconds<double>(100)), 3.0);
  EXPECT_EQ(Rate<10>::seconds<float>(1), 0.1F);
}

}  // namespace
}  // namespace eagerx

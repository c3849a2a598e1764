#include <gtest/gtest.h>

#include <eagerx/delay.hpp>
#include <limits>

namespace eagerx {
namespace {

// 20 Hz to 30 Hz: b = 3, so x = ceil(60 · delay); at most 0.25 s.
using Quanta = DelayQuanta<60, 1'000'000'000, 250'000'000>;

TEST(DelayQuanta, RoundsUpToWholeQuanta) {
  EXPECT_EQ(Quanta::of(0.0), 0);
  EXPECT_EQ(Quanta::of(1e-9), 1);
  EXPECT_EQ(Quanta::of(0.1), 6);  // exactly 6, although 0.1 has no double
  EXPECT_EQ(Quanta::of(0.100000001), 7);
  EXPECT_EQ(Quanta::of(0.15), 9);
}

TEST(DelayQuanta, CountsNanosecondsSoThatDecimalsStayExact) {
  for (int ms = 0; ms <= 250; ms += 50) EXPECT_EQ(Quanta::of(ms * 0.001), ms * 60 / 1000);
}

TEST(DelayQuanta, TakesTheNearestDelayThatThereIsMemoryFor) {
  EXPECT_EQ(Quanta::of(0.25), 15);
  EXPECT_EQ(Quanta::of(0.3), 15);
  EXPECT_EQ(Quanta::of(1e300), 15);
  EXPECT_EQ(Quanta::of(-1.0), 0);
  EXPECT_EQ(Quanta::of(std::numeric_limits<double>::quiet_NaN()), 0);
  EXPECT_TRUE(Quanta::accepts(0.25));
  EXPECT_FALSE(Quanta::accepts(0.2500001));
  EXPECT_FALSE(Quanta::accepts(-0.1));
  EXPECT_FALSE(Quanta::accepts(std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace
}  // namespace eagerx

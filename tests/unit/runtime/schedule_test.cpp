#include <gtest/gtest.h>

#include <algorithm>
#include <eagerx/schedule.hpp>

namespace eagerx {
namespace {

/// Against the times themselves.
template <class Periods>
void expect_due(std::uint64_t slots) {
  Countdown<std::uint32_t, Periods> countdown;
  for (int episode = 0; episode < 2; ++episode) {
    countdown.reset();
    std::uint64_t now = 0;
    for (std::uint64_t slot = 0; slot < slots; ++slot) {
      std::uint32_t due = 0;
      std::uint64_t next = ~std::uint64_t{0};
      std::uint32_t bit = 1;
      for (const std::uint64_t period : Periods::kQuanta) {
        if (now % period == 0) due |= bit;
        next = std::min(next, (now / period + 1) * period);
        bit <<= 1U;
      }
      ASSERT_EQ(countdown.next(), due) << "slot " << slot << " at " << now;
      now = next;
    }
  }
}

struct One {
  static constexpr std::uint64_t kQuanta[] = {7};
};
struct Chain {
  static constexpr std::uint64_t kQuanta[] = {3, 6, 18, 36};
};
struct Fork {
  static constexpr std::uint64_t kQuanta[] = {4, 8, 12, 16, 24};
};
struct Strangers {
  static constexpr std::uint64_t kQuanta[] = {5, 7, 9, 11};
};
struct Television {  // 120, 60, 40 and 29.97 Hz
  static constexpr std::uint64_t kQuanta[] = {999, 1998, 2997, 4000};
};
struct Long {
  static constexpr std::uint64_t kQuanta[] = {
      (std::uint64_t{1} << 40U) - 1, std::uint64_t{1} << 40U, ((std::uint64_t{1} << 40U) - 1) * 3};
};

TEST(Countdown, EverySlotIsTheNextTickOfAnyRate) {
  expect_due<One>(100);
  expect_due<Chain>(1000);
  expect_due<Fork>(1000);
  expect_due<Strangers>(10000);
  expect_due<Television>(20000);
  expect_due<Long>(1000);
}

TEST(Countdown, SmallPeriodsTakeFourBytesEach) {
  EXPECT_EQ(sizeof(Countdown<std::uint32_t, Television>), 4 * 4U);
  EXPECT_EQ(sizeof(Countdown<std::uint32_t, Long>), 3 * 8U);
}

}  // namespace
}  // namespace eagerx

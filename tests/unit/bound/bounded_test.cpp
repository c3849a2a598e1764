#include <gtest/gtest.h>

#include <eagerx/bounded.hpp>
#include <limits>

namespace {

template <std::uint32_t Most>
std::uint32_t turns(std::uint32_t count) {
  std::uint32_t result = 0;
  for (const std::uint32_t i : eagerx::bounded<Most>(count)) result += i == result ? 1 : 1000;
  return result;
}

TEST(Bounded, TurnsCountTimesAndNeverMoreThanItsLimit) {
  EXPECT_EQ(turns<5>(0), 0U);
  EXPECT_EQ(turns<5>(3), 3U);
  EXPECT_EQ(turns<5>(5), 5U);
  EXPECT_EQ(turns<5>(6), 5U);
  EXPECT_EQ(turns<5>(std::numeric_limits<std::uint32_t>::max()), 5U);
}

TEST(Bounded, TurnsItsLimitWithoutACount) {
  std::uint32_t result = 0;
  for ([[maybe_unused]] const std::uint32_t i : eagerx::bounded<7>()) ++result;
  EXPECT_EQ(result, 7U);
}

constexpr std::uint32_t at_compile_time() {
  std::uint32_t sum = 0;
  for (const std::uint32_t i : eagerx::bounded<4>(9)) sum += i;
  return sum;
}
static_assert(at_compile_time() == 6);

}  // namespace

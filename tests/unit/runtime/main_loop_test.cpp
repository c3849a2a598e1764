// eagerx/main_loop.hpp: names that a hardware.h has.
#include <gtest/gtest.h>

#include <eagerx/main_loop.hpp>

namespace eagerx {
namespace {

constexpr const char* kNames[] = {"angle", "speed_left"};

static_assert(has_name(kNames, "angle") && has_name(kNames, "speed_left"));
static_assert(!has_name(kNames, "speed") && !has_name(kNames, "angles") && !has_name(kNames, ""));
static_assert(!has_name(no_names::kMeasurements, "angle"));

TEST(MainLoop, NamesAreWhole) {
  EXPECT_TRUE(has_name(kNames, "angle"));
  EXPECT_FALSE(has_name(kNames, "angle_"));
  EXPECT_FALSE(has_name(kNames, "angl"));
}

}  // namespace
}  // namespace eagerx

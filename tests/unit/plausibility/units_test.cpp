#include "generator/analysis/plausibility/units.hpp"

#include <gtest/gtest.h>

namespace eagerx::gen {
namespace {

bool same(const char* a, const char* b) {
  const auto left = unit_of(a), right = unit_of(b);
  EXPECT_TRUE(left && right) << a << ", " << b;
  return left && right && same_quantity(*left, *right) && same_scale(*left, *right);
}

bool comparable(const char* a, const char* b) {
  const auto left = unit_of(a), right = unit_of(b);
  EXPECT_TRUE(left && right) << a << ", " << b;
  return left && right && same_quantity(*left, *right);
}

TEST(Units, AreTheSameHoweverTheyAreWritten) {
  for (const auto& [a, b] : {std::pair{"rad/s", "rad / s"},
                             {"N*m", "J"},
                             {"Nm", "kg*m^2/s^2"},
                             {"m/s^2", "m/s/s"},
                             {"m*s^-2", "m/s2"},
                             {"V", "W/A"},
                             {"ohm", "V/A"},
                             {"Hz", "1/s"},
                             {"deg", "\u00b0"},
                             {"l", "dm^3"},
                             {"V*s/rad", "V/rad*s"}}) {
    EXPECT_TRUE(same(a, b)) << a << ", " << b;
  }
}

TEST(Units, DifferInScale) {
  for (const auto& [a, b] : {std::pair{"rad", "deg"},
                             {"rpm", "rad/s"},
                             {"mV", "V"},
                             {"ms", "s"},
                             {"km/h", "m/s"},
                             {"%", "1"}}) {
    EXPECT_TRUE(comparable(a, b)) << a << ", " << b;
    EXPECT_FALSE(same(a, b)) << a << ", " << b;
  }
  EXPECT_NEAR(unit_of("rpm")->scale, 0.10471975511965977, 1e-15);
  EXPECT_NEAR(unit_of("km/h")->scale, 1.0 / 3.6, 1e-15);
}

TEST(Units, DifferInQuantity) {
  for (const auto& [a, b] :
       {std::pair{"rad/s", "rad"}, {"Hz", "rad/s"}, {"N*m", "N*m/rad"}, {"V", "A"}, {"m", "m^2"}}) {
    EXPECT_FALSE(comparable(a, b)) << a << ", " << b;
  }
}

TEST(Units, OtherUnitsGiveNoWarning) {
  for (const char* text : {"", " ", "furlong", "rad/", "/s", "m**2", "m^", "m^x", "degC", "m^99",
                           "cos(rad)", "m/s^2^2", "*"}) {
    EXPECT_FALSE(unit_of(text)) << text;
  }
}

}  // namespace
}  // namespace eagerx::gen

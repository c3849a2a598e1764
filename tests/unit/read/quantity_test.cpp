#include "generator/frontend/read/quantity.hpp"

#include <gtest/gtest.h>

namespace eagerx::gen {
namespace {

TEST(Quantity, IsReadInItsBaseUnitExactly) {
  EXPECT_EQ(parse_quantity("30", Quantity::rate), Rational(30));
  EXPECT_EQ(parse_quantity("30 Hz", Quantity::rate), Rational(30));
  EXPECT_EQ(parse_quantity("0.5kHz", Quantity::rate), Rational(500));
  EXPECT_EQ(parse_quantity("10ms", Quantity::time), Rational(1, 100));
  EXPECT_EQ(parse_quantity("1/3 s", Quantity::time), Rational(1, 3));
  EXPECT_EQ(parse_quantity("50 us", Quantity::time), Rational(1, 20'000));
  EXPECT_EQ(parse_quantity("50 \u00b5s", Quantity::time), Rational(1, 20'000));
  EXPECT_EQ(parse_quantity("1e3 \u03bcs", Quantity::time), Rational(1, 1'000));
  EXPECT_EQ(parse_quantity("-2 min", Quantity::time), Rational(-120));
  EXPECT_EQ(parse_quantity("80 %", Quantity::share), Rational(4, 5));
  EXPECT_EQ(parse_quantity("12.5%", Quantity::share), Rational(1, 8));
  EXPECT_EQ(parse_quantity("0.8", Quantity::share), Rational(4, 5));
}

TEST(Quantity, OtherTextsAreNone) {
  for (const char* text :
       {"", "Hz", "30 fps", "30 Hz Hz", "30 hz", "3 0 Hz", "10 ms", ".inf", ".nan", "0x10",
        "1e300 Hz", "9223372036854775807 MHz", "30\tHz", "30 Hz "})
    EXPECT_EQ(parse_quantity(text, Quantity::rate), std::nullopt) << text;
}

TEST(Quantity, IsGivenInAnotherUnit) {
  EXPECT_EQ(number_in("10 ms", *find_unit("s")), Rational(1, 100));
  EXPECT_EQ(number_in("1/3 s", *find_unit("ms")), Rational(1000, 3));
  EXPECT_EQ(number_in("10", *find_unit("ms")), std::nullopt);
  EXPECT_EQ(number_in("soon", *find_unit("ms")), std::nullopt);
  EXPECT_EQ(number_in("10 Hz", *find_unit("ms")), std::nullopt);
}

TEST(Quantity, SaysWhatWasMeant) {
  EXPECT_EQ(with_right_unit("10 ms", Quantity::rate), "100 Hz");
  EXPECT_EQ(with_right_unit("30 Hz", Quantity::time), "1/30 s");
  EXPECT_EQ(with_right_unit("30 hz", Quantity::rate), "30 Hz");
  EXPECT_EQ(with_right_unit("0 s", Quantity::rate), "");
  EXPECT_EQ(with_right_unit("30 fps", Quantity::rate), "");
  EXPECT_EQ(with_right_unit("30 %", Quantity::rate), "");  // no inverse of a share
  EXPECT_EQ(with_right_unit("10 ms", Quantity::share), "");
}

}  // namespace
}  // namespace eagerx::gen

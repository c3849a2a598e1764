#include "generator/frontend/read/scalar.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

namespace eagerx::gen {
namespace {

TEST(Scalar, Ints) {
  EXPECT_EQ(parse_int("0"), 0);
  EXPECT_EQ(parse_int("-0"), 0);
  EXPECT_EQ(parse_int("42"), 42);
  EXPECT_EQ(parse_int("+7"), 7);
  EXPECT_EQ(parse_int("-9223372036854775808"), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(parse_int("9223372036854775807"), std::numeric_limits<std::int64_t>::max());
  for (const char* text :
       {"", "+", "-", "--1", "+-1", "010", "-01", "00", "1_000", "0x10", "0o7", "1.0", "1e3", " 1",
        "1 ", "9223372036854775808", "-9223372036854775809", "one"}) {
    EXPECT_EQ(parse_int(text), std::nullopt) << text;
  }
}

TEST(Scalar, WholeNumbersInHexadecimalToo) {
  EXPECT_EQ(parse_whole("0x0403"), 0x0403);
  EXPECT_EQ(parse_whole("0xaF"), 0xaf);
  EXPECT_EQ(parse_whole("-7"), -7);
  EXPECT_EQ(parse_whole("0x7fffffffffffffff"), std::numeric_limits<std::int64_t>::max());
  for (const char* text :
       {"0x", "0x-1", "0x+1", "-0x1", "0X1", "0x1g", "0x 1", "0x8000000000000000", "010"}) {
    EXPECT_EQ(parse_whole(text), std::nullopt) << text;
  }
}

TEST(Scalar, Numbers) {
  EXPECT_EQ(parse_number("1"), 1.0);
  EXPECT_EQ(parse_number("-2.5"), -2.5);
  EXPECT_EQ(parse_number("+.5"), 0.5);
  EXPECT_EQ(parse_number("1."), 1.0);
  EXPECT_EQ(parse_number("6.02e+23"), 6.02e23);
  EXPECT_EQ(parse_number("1E-3"), 1e-3);
  EXPECT_EQ(parse_number("0.1"), 0.1);
  EXPECT_EQ(parse_number("5e-324"), 5e-324);
  EXPECT_TRUE(std::signbit(parse_number("-0.0").value()));
  EXPECT_EQ(parse_number(".inf"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(parse_number("-.Inf"), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(parse_number("+.INF"), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(parse_number(".nan").value()));
  for (const char* text : {"",      ".",     "-",     "e5",    "1e",  "1e+",   "1e5.0",     "010",
                           "-00.5", "1_0.0", "0x1p3", "inf",   "nan", "-.nan", ".infinity", "1,5",
                           "1.0.0", " 1",    "1 ",    "1e999", "1f",  "+-1"}) {
    EXPECT_EQ(parse_number(text), std::nullopt) << text;
  }
}

TEST(Scalar, MultiplesOfPi) {
  EXPECT_EQ(parse_number("pi"), M_PI);
  EXPECT_EQ(parse_number("-pi"), -M_PI);
  EXPECT_EQ(parse_number("+pi/2"), M_PI / 2);
  EXPECT_EQ(parse_number("2*pi"), 2 * M_PI);
  EXPECT_EQ(parse_number("-0.75 * pi"), -0.75 * M_PI);
  EXPECT_EQ(parse_number("3*pi / 4"), 3 * M_PI / 4);
  for (const char* text : {"2pi", "pi*2", "pi/0", "pi/-2", "pi pi", "pie", "1+pi", "*pi", "pi/",
                           "0x2*pi", ".inf*pi", "--pi", "PI", "2**pi", "1e999*pi"}) {
    EXPECT_EQ(parse_number(text), std::nullopt) << text;
  }
}

TEST(Scalar, Bools) {
  EXPECT_EQ(parse_bool("true"), true);
  EXPECT_EQ(parse_bool("false"), false);
  for (const char* text : {"", "True", "FALSE", "yes", "no", "on", "off", "y", "1", "0", "true "}) {
    EXPECT_EQ(parse_bool(text), std::nullopt) << text;
  }
}

TEST(Scalar, Nulls) {
  for (const char* text : {"", "~", "null", "Null", "NULL"})
    EXPECT_TRUE(is_null_text(text)) << text;
  for (const char* text : {"nULL", "none", "0", " "}) EXPECT_FALSE(is_null_text(text)) << text;
}

}  // namespace
}  // namespace eagerx::gen

#include "generator/frontend/read/number.hpp"

#include <gtest/gtest.h>

namespace eagerx::gen {
namespace {

TEST(Number, IsWhatTheTextOfAWrittenValueMeans) {
  EXPECT_EQ(whole_of(made_scalar("-7", {})), -7);
  EXPECT_EQ(whole_of(made_scalar("0x10", {})), std::nullopt);
  EXPECT_EQ(real_of(made_scalar("pi/2", {})), 1.5707963267948966);
  EXPECT_EQ(real_of(made_scalar("1/3", {})), std::nullopt);  // only what is computed is a fraction
  EXPECT_EQ(exact_of(made_scalar("29.97", {})), Rational(2997, 100));
  EXPECT_EQ(exact_of(made_scalar("fast", {})), std::nullopt);
}

TEST(Number, OfWhatWasComputedGoesThroughNoText) {
  YamlValue third = made_number(Rational(1, 3), {});
  EXPECT_EQ(third.text, "1/3");
  EXPECT_EQ(real_of(third), 1.0 / 3.0);
  EXPECT_EQ(whole_of(third), std::nullopt);
  third.text = "what messages show";
  EXPECT_EQ(exact_of(third), Rational(1, 3));
}

TEST(Number, OfEachKindAsTheOthers) {
  struct Row {
    ComputedNumber number;
    std::string text;
    std::optional<std::int64_t> whole;
    double real;
    std::optional<Rational> exact;
  };
  const std::vector<Row> rows = {
      {std::int64_t{5}, "5", 5, 5.0, Rational(5)},
      {5.0, "5", 5, 5.0, Rational(5)},
      {0.1, "0.1", std::nullopt, 0.1, Rational(1, 10)},
      {1e-30, "1e-30", std::nullopt, 1e-30, std::nullopt},  // does not fit into 64 bits
      {1e30, "1e+30", std::nullopt, 1e30, std::nullopt},
      {Rational(6, 3), "2", 2, 2.0, Rational(2)},
      {Rational(-3, 4), "-0.75", std::nullopt, -0.75, Rational(-3, 4)},
  };
  for (const Row& row : rows) {
    const YamlValue value = made_number(row.number, {});
    EXPECT_EQ(value.text, row.text);
    EXPECT_EQ(whole_of(value), row.whole) << row.text;
    EXPECT_EQ(real_of(value), row.real) << row.text;
    EXPECT_EQ(exact_of(value), row.exact) << row.text;
  }
}

}  // namespace
}  // namespace eagerx::gen

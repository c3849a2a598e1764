// targets/linux-sim/expression.hpp: the language of --until and --measure.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <targets/linux-sim/expression.hpp>
#include <targets/linux-sim/state_settings.hpp>

namespace eagerx::linux_sim {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// a.x is 3, a.y[1] is 5, a/b.c is 7, time is 2, a.nan is NaN.
int variable(const std::string& name, std::size_t index, bool indexed, std::string& problem) {
  if (name == "a.x" && !indexed) return 0;
  if (name == "a.y" && index == 1) return 1;
  if (name == "a/b.c") return 2;
  if (name == "time") return 3;
  if (name == "a.nan") return 4;
  problem = "no `" + name + "`";
  return -1;
}

double value(const std::string& text) {
  const double variables[] = {3.0, 5.0, 7.0, 2.0, kNaN};
  Expression expression;
  EXPECT_EQ(expression.parse(text, variable), "") << text;
  return expression.value(variables);
}

std::string problem(const std::string& text) {
  Expression expression;
  return expression.parse(text, variable);
}

TEST(ExpressionTest, Numbers) {
  EXPECT_EQ(value("1 + 2*3"), 7.0);
  EXPECT_EQ(value("(1 + 2)*3"), 9.0);
  EXPECT_EQ(value("10 - 2 - 3"), 5.0);
  EXPECT_EQ(value("8 / 4 / 2"), 1.0);
  EXPECT_EQ(value("-2 - -3"), 1.0);
  EXPECT_EQ(value("--2"), 2.0);
  EXPECT_EQ(value("1e-3 + .5"), 0.501);
  EXPECT_EQ(value("a.x*a.y[1] - a/b.c"), 8.0);
  EXPECT_EQ(value("a.x/time"), 1.5);
  EXPECT_EQ(value("time/a.x"), 2.0 / 3.0);
  EXPECT_EQ(value("abs(a.x - 4) + min(3, 1, 2) + max(time, 1)"), 4.0);
  EXPECT_TRUE(std::isnan(value("min(1, a.nan)")));
  EXPECT_TRUE(std::isnan(value("max(a.nan, 1)")));
}

TEST(ExpressionTest, Conditions) {
  EXPECT_EQ(value("a.x > 2 and not a.x > 4"), 1.0);
  EXPECT_EQ(value("a.x == 3 or a.x / 0 != 1"), 1.0);
  EXPECT_EQ(value("a.x > 5 or a.x < 1 and true"), 0.0);
  EXPECT_EQ(value("(a.x > 2 or false) and a.x >= 3 and a.x <= 3"), 1.0);
  EXPECT_EQ(value("a.nan > 1 or a.nan <= 1"), 0.0);
  EXPECT_EQ(value("not not true"), 1.0);
}

TEST(ExpressionTest, WrongOnesHaveAPlace) {
  EXPECT_EQ(problem("1 +"), "column 4: expected a number or a name");
  EXPECT_EQ(problem("(1"), "column 3: expected `)`");
  EXPECT_EQ(problem("1 2"), "column 3: expected the end");
  EXPECT_EQ(problem("1 < 2 < 3"), "column 8: comparisons cannot be chained: join them with `and`");
  EXPECT_EQ(problem("1 and 2"), "column 1: `and` and `or` join conditions");
  EXPECT_EQ(problem("1 + (2 > 1)"), "column 1: this is arithmetic with a condition");
  EXPECT_EQ(problem("not 1"), "column 1: `not` is for conditions");
  EXPECT_EQ(problem("-(1 > 2)"), "column 1: `-` is for numbers");
  EXPECT_EQ(problem("abs(1, 2)"), "column 10: `abs` takes one number");
  EXPECT_EQ(problem("1 + b.x"), "column 5: no `b.x`");
  EXPECT_EQ(problem("a.x[0]"), "column 1: no `a.x`");
  EXPECT_EQ(problem("a.y[x]"), "column 5: expected the number of an element");
  EXPECT_NE(problem(std::string(10'000, '(')), "");
  EXPECT_NE(problem("1" + std::string(10'000, '+')), "");
  EXPECT_EQ(problem(""), "column 1: expected a number or a name");
}

TEST(ExpressionTest, LongOnesUseNoMoreThanTheStack) {
  std::string text = "1";
  for (int i = 0; i < 10'000; ++i) text += " + 1";
  EXPECT_EQ(value(text), 10'001.0);
  std::string nested = "1";
  for (int i = 0; i < 45; ++i) nested = "1 + (" + nested + ")";
  EXPECT_EQ(value(nested), 46.0);
}

TEST(StateSettingTest, Forms) {
  const auto setting = parse_setting("a.b=uniform:0.1,0.2");
  ASSERT_TRUE(setting);
  EXPECT_EQ(setting->name, "a.b");
  EXPECT_EQ(setting->number(0, 5), 0.1);
  EXPECT_EQ(setting->number(1, 5), 0.2);
  const auto lists = parse_setting("a.b=normal:1,2,3,4");
  ASSERT_TRUE(lists);
  EXPECT_EQ(lists->number(0, 1), 2.0);
  EXPECT_EQ(lists->number(1, 0), 3.0);
  for (const char* wrong : {"", "a.b", "=1", "a.b=", "a.b=x", "a.b=1,", "a.b=uniform:", "a.b=inf",
                            "a.b=1 ", "a.b=nan", "a.b=gauss:1,2"})
    EXPECT_FALSE(parse_setting(wrong)) << wrong;
}

TEST(StateSettingTest, NumbersAreWithinTheSpace) {
  const std::vector<double> low = {0.0, -1.0};
  const std::vector<double> high = {1.0, 1.0};
  const auto said = [&](const char* text) { return problem_of(*parse_setting(text), low, high); };
  EXPECT_EQ(said("a=0.5"), "");
  EXPECT_EQ(said("a=0.5,-0.5"), "");
  EXPECT_NE(said("a=-0.5").find("-0.5 is out of the space"), std::string::npos);
  EXPECT_NE(said("a=1,2,3").find("there are 3 numbers"), std::string::npos);
  EXPECT_EQ(said("a=uniform:0,1"), "");
  EXPECT_EQ(said("a=uniform:0,-1,1,0"), "");
  EXPECT_NE(said("a=uniform:1,0"), "");
  EXPECT_NE(said("a=uniform:0,1,2"), "");
  EXPECT_NE(said("a=log_uniform:0,1"), "");
  EXPECT_EQ(said("a=normal:5,1"), "");
  EXPECT_NE(said("a=normal:5,-1"), "");
  EXPECT_EQ(said("a=choice:0,0.5,1"), "");
  EXPECT_NE(said("a=choice:0,0.5,2"), "");
}

}  // namespace
}  // namespace eagerx::linux_sim

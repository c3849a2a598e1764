// runtime/host/expression: what is calculated, by everybody who calculates it.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "runtime/host/expression/calculation.hpp"
#include "runtime/host/expression/functions.hpp"

namespace eagerx::expression {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

const std::vector<Variable>& variables() {
  static const std::vector<Variable> kVariables = {{"a.x", false, {1}},   {"a.y", false, {2}},
                                                   {"a/b.c", false, {1}}, {"a.nan", false, {1}},
                                                   {"a.on", true, {}},    {"a.big", false, {100}}};
  return kVariables;
}

/// a.x is 3 (before: 2), a.y is 4 and 5, a/b.c is 7, a.on is true, a.big counts from 0, time is 2;
/// before all others were 0.
double number_of(const Read& read) {
  if (read.variable == Read::kTime) return 2.0;
  if (read.is_before) return read.variable == 0 ? 2.0 : 0.0;
  constexpr double kValues[] = {3.0, 4.0, 7.0, kNaN, 1.0, 0.0};
  return kValues[read.variable] + static_cast<double>(read.element);
}

std::string problem_of(const std::string& text, Type type, Calculation& calculation,
                       std::vector<double>& values) {
  Text piece(text);
  const auto typed = read_typed(piece, {variables(), NameForm::port, {}}, type);
  if (!typed) {
    const expression::Problem& problem = *piece.problem();
    return std::to_string(problem.place + 1) + ": " + problem.message +
           (problem.help.empty() ? "" : " (" + problem.help + ")");
  }
  return calculation.prepare(*typed, [&](const Read& read) -> std::optional<std::size_t> {
    if (values.size() == 64) return std::nullopt;
    values.push_back(number_of(read));
    return values.size() - 1;
  });
}
std::string problem(const std::string& text, Type type = Type::number) {
  Calculation calculation;
  std::vector<double> values;
  return problem_of(text, type, calculation, values);
}
double value(const std::string& text, Type type = Type::number) {
  Calculation calculation;
  std::vector<double> values;
  EXPECT_EQ(problem_of(text, type, calculation, values), "") << text;
  return calculation.value(values.data());
}
bool holds(const std::string& text) {
  return value(text, Type::condition) != 0.0;
}

TEST(Calculation, Numbers) {
  EXPECT_EQ(value("1 + 2*3"), 7.0);
  EXPECT_EQ(value("(1 + 2)*3"), 9.0);
  EXPECT_EQ(value("10 - 2 - 3"), 5.0);
  EXPECT_EQ(value("8 / 4 / 2"), 1.0);
  EXPECT_EQ(value("-2 - -3"), 1.0);
  EXPECT_EQ(value("--2"), 2.0);
  EXPECT_EQ(value("-a.x^2 + 2^3"), -1.0);
  EXPECT_EQ(value("1e-3 + .5"), 0.501);
  EXPECT_EQ(value("a.x*a.y[1] - a/b.c"), 8.0);
  EXPECT_EQ(value("a.x/time"), 1.5);
  EXPECT_EQ(value("time/a.x"), 2.0 / 3.0);
  EXPECT_EQ(value("pi"), 3.141592653589793);
  EXPECT_EQ(value("abs(a.x - 4) + min(3, 1, 2) + max(time, 1)"), 4.0);
  EXPECT_EQ(value("clamp(a.x, 0, 2) + where(a.x > 2, 10, 20)"), 12.0);
  EXPECT_EQ(value("a.x - before(a.x)"), 1.0);
  EXPECT_TRUE(std::isnan(value("min(1, a.nan)")));
  EXPECT_TRUE(std::isnan(value("max(a.nan, 1)")));
}

TEST(Calculation, Lists) {
  EXPECT_EQ(value("sum(a.y)"), 9.0);
  EXPECT_EQ(value("mean(a.y)"), 4.5);
  EXPECT_EQ(value("norm(a.y - 1)"), 5.0);
  EXPECT_EQ(value("max(abs(a.y - 10)) - min(a.y)"), 2.0);
  EXPECT_EQ(value("sum(a.y^2 * 2)"), 82.0);
  EXPECT_EQ(value("norm(a.x - 5)"), 2.0);
  EXPECT_EQ(value("sum(a.y - before(a.y))"), 9.0);
}

TEST(Calculation, Conditions) {
  EXPECT_TRUE(holds("a.x > 2 and not a.x > 4"));
  EXPECT_TRUE(holds("a.x == 3 or a.x / 0 != 1"));
  EXPECT_FALSE(holds("a.x > 5 or a.x < 1 and true"));
  EXPECT_TRUE(holds("(a.x > 2 or false) and a.x >= 3 and a.x <= 3"));
  EXPECT_FALSE(holds("a.nan > 1 or a.nan <= 1"));
  EXPECT_TRUE(holds("not not true"));
  EXPECT_TRUE(holds("a.x in (1, 3) and a.on"));
}

TEST(Expression, OtherNamesThatMeanAVariable) {
  const auto read = [](const std::string& written) {
    Text text(written);
    Names names{variables(), NameForm::port};
    names.meant = [](const std::string& name) { return name == "other" ? "a/b.c" : ""; };
    return read_typed(text, names, Type::number).has_value();
  };
  EXPECT_TRUE(read("other + 1"));
  EXPECT_TRUE(read("a/b.c"));
  EXPECT_FALSE(read("b.c"));
  EXPECT_EQ(problem("other").substr(0, 15), "1: unknown name");
}

// Every function of a task can be calculated.
TEST(Calculation, EveryFunctionOfATask) {
  for (const Function& each : functions()) {
    std::string call(each.name);
    call += each.arguments == 1 ? "(0.5)" : each.arguments == 2 ? "(0.5, 2)" : "(0.5, 0, 1)";
    EXPECT_TRUE(std::isfinite(value(call))) << call;
  }
  EXPECT_EQ(value("atan2(0, -1)"), 3.141592653589793);
  EXPECT_EQ(value("angle_of(-1, 0)"), 3.141592653589793);
  EXPECT_EQ(value("pow(2, 10)"), 1024.0);
  EXPECT_EQ(value("fmod(7, 4)"), 3.0);
}

TEST(Calculation, WrongOnesHaveAPlace) {
  EXPECT_EQ(problem("1 +"), "4: expected a value, found the end");
  EXPECT_EQ(problem("(1"), "3: expected `)`, found the end");
  EXPECT_EQ(problem("1 2"), "3: expected the end, found `2`");
  EXPECT_EQ(problem("1 < 2 < 3", Type::condition),
            "7: comparisons cannot be chained (join them: `0 < x and x < 1`)");
  EXPECT_EQ(problem("1 and 2", Type::condition),
            "1: expected true or false, found a number (compare it: `x > 0`)");
  EXPECT_EQ(
      problem("1 + (2 > 1)"),
      "6: expected a number, found true or false (convert it to a number: `where(x < 1, 1, 0)`)");
  EXPECT_EQ(problem("abs(1, 2)"), "1: `abs` takes 1 argument, not 2 (write `abs(x)`)");
  EXPECT_EQ(problem("1 + a.z"), "5: unknown name `a.z` (did you mean `a.x`?)");
  EXPECT_EQ(
      problem("a.y"),
      "1: this is a list of shape [2], not one number (reduce it to one number with sum, norm, "
      "mean, min or max, or take an element: `x[0]`)");
  EXPECT_EQ(problem("a.x[1]"),
            "1: a list of shape [1] has no element 1 (elements are counted from "
            "0, row by row: 0 to 0)");
  EXPECT_EQ(problem("a.y[x]"), "5: expected the number of an element, from 0");
  EXPECT_EQ(problem(""), "1: expected a value, found the end");
  EXPECT_EQ(problem("007"), "1: `007` is not a number");
  EXPECT_EQ(problem("1e999"), "1: `1e999` is not a number");
  EXPECT_NE(problem(std::string(10'000, '(')), "");
  EXPECT_NE(problem("1" + std::string(10'000, '+')), "");
}

TEST(Calculation, LongOnesUseNoMoreThanTheStack) {
  std::string text = "1";
  for (int i = 0; i < 300; ++i) text += "+1";
  EXPECT_EQ(value(text), 301.0);
  std::string nested = "1";
  for (int i = 0; i < 30; ++i) nested = "1 + (" + nested + ")";
  EXPECT_EQ(value(nested), 31.0);
  EXPECT_EQ(problem("sum(a.big)"), "it reads too many different numbers");
}

}  // namespace
}  // namespace eagerx::expression

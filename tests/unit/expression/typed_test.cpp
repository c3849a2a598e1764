// Expressions of tasks: types, and the C++ that they become.
#include <gtest/gtest.h>

#include "generator/backend/emit/expression_text.hpp"
#include "generator/frontend/expression/expression.hpp"

namespace eagerx::gen {
namespace {

YamlValue scalar(const std::string& text) {
  YamlValue yaml;
  yaml.kind = YamlKind::scalar;
  yaml.text = text;
  yaml.span = {FileId::none, 3, 10, static_cast<std::uint32_t>(text.size())};
  return yaml;
}

const std::vector<ExpressionVariable>& variables() {
  static const std::vector<ExpressionVariable> kVariables = {
      {"x", false, {}},  {"y", false, {}},     {"u", false, {1}},
      {"v", false, {3}}, {"m", false, {2, 2}}, {"hit", true, {}}};
  return kVariables;
}

/// A caller's help for a name with a point.
std::string help_with(const std::string& unknown) {
  if (unknown.find('.') == std::string::npos) return {};
  return "give it a name under `inputs:`: `x: " + unknown + "`";
}

/// The C++ of an expression, with the lines before it; or the message, its column and its help.
std::string cpp(const std::string& text, ExpressionType type, double weight = 1.0) {
  Diagnostics diagnostics;
  const auto expression =
      read_typed_expression(scalar(text), variables(), type, help_with, diagnostics);
  if (!expression) {
    EXPECT_EQ(diagnostics.error_count(), 1U) << text;
    const Diagnostic& problem = diagnostics.all().front();
    EXPECT_EQ(problem.code, "E0339");
    return std::to_string(problem.span.column - 10) + ": " + problem.message +
           (problem.help.empty() ? "" : " (" + problem.help.text + ")");
  }
  std::vector<VariableText> names;
  for (const auto& variable : variables())
    names.push_back({variable.name, "before_" + variable.name + "_", variable.name == "m"});
  Names locals;
  ExpressionWriter writer(names, "time", locals);
  std::vector<std::string> lines;
  const std::string value = writer.write_weighted(*expression, weight, lines);
  std::string all;
  for (const auto& line : lines) all += line + "\n";
  return all + value;
}
std::string number(const std::string& text, double weight = 1.0) {
  return cpp(text, ExpressionType::number, weight);
}
std::string condition(const std::string& text) {
  return cpp(text, ExpressionType::condition);
}

TEST(TaskExpression, NumbersAndNames) {
  EXPECT_EQ(number("2"), "Real(2)");
  EXPECT_EQ(number("0.1"), "Real(0.1)");
  EXPECT_EQ(number("1e-3"), "Real(0.001)");
  EXPECT_EQ(number("x"), "x");
  EXPECT_EQ(number("time"), "time");
  EXPECT_EQ(number("pi"), "Real(3.141592653589793)");
  EXPECT_EQ(number("u"), "u[0]");
  EXPECT_EQ(number("u[0]"), "u[0]");
  EXPECT_EQ(number("v[2]"), "v[2]");
  EXPECT_EQ(number("m[3]"), "static_cast<Real>(m[3])");
  EXPECT_EQ(number("before(x)"), "before_x_");
  EXPECT_EQ(number("before(v)[1]"), "before_v_[1]");
  EXPECT_EQ(number("before(u)"), "before_u_[0]");
}

TEST(TaskExpression, OperatorsBindAsInMathematics) {
  EXPECT_EQ(number("x + y * 2"), "x + y * Real(2)");
  EXPECT_EQ(number("(x + y) * 2"), "(x + y) * Real(2)");
  EXPECT_EQ(number("x - y - 1"), "x - y - Real(1)");
  EXPECT_EQ(number("x - (y - 1)"), "x - (y - Real(1))");
  EXPECT_EQ(number("x / y / 2"), "x / y / Real(2)");
  EXPECT_EQ(number("x / (y / 2)"), "x / (y / Real(2))");
  EXPECT_EQ(number("x / (y * 2)"), "x / (y * Real(2))");
  EXPECT_EQ(number("-x^2"), "-eagerx::square(x)");
  EXPECT_EQ(number("(-x)^2"), "eagerx::square(-x)");
  EXPECT_EQ(number("2 * x^2"), "Real(2) * eagerx::square(x)");
  EXPECT_EQ(number("x^3"), "eagerx::cube(x)");
  EXPECT_EQ(number("(x^2)^3"), "eagerx::cube(eagerx::square(x))");
  EXPECT_EQ(number("v[1]^2"), "eagerx::square(v[1])");
  EXPECT_EQ(number("--x"), "-(-x)");
  EXPECT_EQ(number("x - -y"), "x - -y");
  EXPECT_EQ(number("-x * y"), "-x * y");
  EXPECT_EQ(number("-2^2"), "-eagerx::square(Real(2))");
}

TEST(TaskExpression, WeightsAreOfTheWholeTerm) {
  EXPECT_EQ(number("x", 1.0), "x");
  EXPECT_EQ(number("x + y", -1.0), "-(x + y)");
  EXPECT_EQ(number("x * y", -0.1), "Real(-0.1) * (x * y)");
  EXPECT_EQ(number("x^2", 2.0), "Real(2) * eagerx::square(x)");
}

TEST(TaskExpression, Functions) {
  EXPECT_EQ(number("abs(sin(x))"), "eagerx::abs(eagerx::sin(x))");
  EXPECT_EQ(number("angle_of(x, y)"), "eagerx::atan2(y, x)");
  EXPECT_EQ(number("atan2(y, x)"), "eagerx::atan2(y, x)");
  EXPECT_EQ(number("min(x, y, 1)"), "eagerx::min(eagerx::min(x, y), Real(1))");
  EXPECT_EQ(number("clamp(x, -1, 1)"), "eagerx::clamp(x, Real(-1), Real(1))");
  EXPECT_EQ(number("where(hit and x < 1, x, 0)"), "eagerx::select(hit && x < Real(1), x, Real(0))");
}

TEST(TaskExpression, ListsBecomeLoops) {
  EXPECT_EQ(number("sum(v^2)"),
            "Real sum_1{};\n"
            "for (std::size_t i = 0; i < 3; ++i) {\n"
            "  sum_1 += eagerx::square(v[i]);\n"
            "}\n"
            "sum_1");
  EXPECT_EQ(number("sum((v - before(v))^2 * 2)"),
            "Real sum_1{};\n"
            "for (std::size_t i = 0; i < 3; ++i) {\n"
            "  sum_1 += "
            "eagerx::square(v[i] - before_v_[i]) * Real(2);\n"
            "}\n"
            "sum_1");
  EXPECT_EQ(number("norm(m)"),
            "Real squares_1{};\n"
            "for (std::size_t i = 0; i < 4; ++i) {\n"
            "  squares_1 += "
            "eagerx::square(static_cast<Real>(m[i]));\n"
            "}\n"
            "eagerx::sqrt(squares_1)");
  EXPECT_EQ(number("max(abs(v))"),
            "Real most_1 = eagerx::abs(v[0]);\n"
            "for (std::size_t i = 1; i < 3; ++i) {\n"
            "  most_1 = "
            "eagerx::max(most_1, eagerx::abs(v[i]));\n"
            "}\n"
            "most_1");
  EXPECT_EQ(number("sum((v - mean(v))^2)"),
            "Real sum_1{};\n"
            "for (std::size_t i = 0; i < 3; ++i) {\n"
            "  sum_1 += v[i];\n"
            "}\n"
            "Real sum_2{};\n"
            "for (std::size_t i = 0; i < 3; ++i) {\n"
            "  sum_2 += "
            "eagerx::square(v[i] - sum_1 / Real(3));\n"
            "}\n"
            "sum_2");
  // The same sum is added up once.
  EXPECT_EQ(number("sum(v) * sum(v)"),
            "Real sum_1{};\n"
            "for (std::size_t i = 0; i < 3; ++i) {\n"
            "  sum_1 += v[i];\n"
            "}\n"
            "sum_1 * sum_1");
  // Of one number there is nothing to add up.
  EXPECT_EQ(number("sum(u^2)"), "eagerx::square(u[0])");
  EXPECT_EQ(number("norm(u)"), "eagerx::abs(u[0])");
}

TEST(TaskExpression, Conditions) {
  EXPECT_EQ(condition("x < 1"), "x < Real(1)");
  EXPECT_EQ(condition("hit"), "hit");
  EXPECT_EQ(condition("not hit and x >= y or x != 2"), "(!hit && x >= y) || x != Real(2)");
  EXPECT_EQ(condition("hit or x < 1 or x > 2"), "hit || x < Real(1) || x > Real(2)");
  EXPECT_EQ(condition("hit and (hit or x < 1)"), "hit && (hit || x < Real(1))");
  EXPECT_EQ(condition("not (x < 1)"), "!(x < Real(1))");
  EXPECT_EQ(condition("x in (1, 2)"), "x == Real(1) || x == Real(2)");
  EXPECT_EQ(condition("x + 1 < y * 2"), "x + Real(1) < y * Real(2)");
  EXPECT_EQ(condition("true"), "true");
}

/// Each help is an expression that is right, with the variables that it names.
TEST(TaskExpression, WordsOfOtherLanguagesAreTranslated) {
  const auto chosen = std::string("(write `where(x > 0, a, b)`)");
  EXPECT_EQ(number("x if x > 0 else 1"), "2: expected the end, found `if` " + chosen);
  EXPECT_EQ(number("x > 0 ? 1 : 0"), "6: expected the end, found `?` " + chosen);
  EXPECT_EQ(number("square(x)"), "0: unknown function `square` (write `x^2`)");
  EXPECT_EQ(number("np.exp(x)"), "0: unknown function `np.exp` (write `exp`)");
  EXPECT_EQ(number("np.square(x)"), "0: unknown function `np.square` (write `x^2`)");
  EXPECT_EQ(number("torch.clip(x, 0, 1)"),
            "0: unknown function `torch.clip` (write `clamp(x, low, high)`)");
  EXPECT_EQ(number("fabs(x)"), "0: unknown function `fabs` (did you mean `abs`?)");
  for (const char* right :
       {"x^2", "pow(x, y)", "abs(x)", "log(x)", "max(x, y)", "min(x, y)", "fmod(x, y)",
        "atan2(y, x)", "asin(x)", "acos(x)", "atan(x)", "mean(v)", "sqrt(x^2 + y^2)",
        "where(x > 0, 1, -1)", "where(x > 0, x, y)", "clamp(x, 0, 1)", "(x^2)^3"})
    EXPECT_EQ(number(right).find('`'), std::string::npos) << number(right);
}

TEST(TaskExpression, MistakesHaveTheirPlaceAndHelp) {
  EXPECT_EQ(number("x +"), "3: expected a value, found the end");
  EXPECT_EQ(number("(x"), "2: expected `)`, found the end");
  EXPECT_EQ(number("x y"), "2: expected the end, found `y`");
  EXPECT_EQ(number("x^4"), "2: an exponent is 2 or 3 (write others as `pow(x, y)`)");
  EXPECT_EQ(number("x^2^3"), "3: powers cannot be chained (write `(x^2)^3`, or `pow(x, 6)`)");
  EXPECT_EQ(number("2 * xx"), "4: unknown name `xx` (available: x, y, u, v, m, hit, time, pi)");
  EXPECT_EQ(number("tme"), "0: unknown name `tme` (did you mean `time`?)");
  EXPECT_EQ(number("pendulum.theta"),
            "0: unknown name `pendulum.theta` (give it a name under `inputs:`: `x: "
            "pendulum.theta`)");
  EXPECT_EQ(number("sine(x)"), "0: unknown function `sine` (did you mean `sin`?)");
  EXPECT_EQ(
      number("v"),
      "0: this is a list of shape [3], not one number (reduce it to one number with sum, norm, "
      "mean, min or max, or take an element: `x[0]`)");
  EXPECT_EQ(number("sum(v + m)"),
            "8: a list of shape [2, 2] does not go with a list of shape [3] (lists go together "
            "element by element: they need one shape)");
  EXPECT_EQ(number("v[3]"),
            "0: a list of shape [3] has no element 3 (elements are counted from 0, row by row: 0 "
            "to 2)");
  EXPECT_EQ(number("x[0]"),
            "0: this is not a list, so it has no elements (write it without `[0]`)");
  EXPECT_EQ(number("v[x]"), "2: expected the number of an element, from 0");
  EXPECT_EQ(number("hit"),
            "0: expected a number, found true or false (convert it to a number: `where(x < 1, 1, "
            "0)`)");
  EXPECT_EQ(number("1 + (x < y)"),
            "5: expected a number, found true or false (convert it to a number: `where(x < 1, 1, "
            "0)`)");
  EXPECT_EQ(number("before(x + 1)"),
            "7: `before` takes the name of an input (write `before(x)[0]` for an element, "
            "`before(x)^2` for a square)");
  EXPECT_EQ(number("before(hit)"),
            "7: expected a number, found true or false (convert it to a number: `where(x < 1, 1, "
            "0)`)");
  EXPECT_EQ(number("atan2(x)"), "0: `atan2` takes 2 arguments, not 1 (write `atan2(y, x)`)");
  EXPECT_EQ(number("abs(x, y)"), "0: `abs` takes 1 argument, not 2 (write `abs(x)`)");
  EXPECT_EQ(condition("x"), "0: expected true or false, found a number (compare it: `x > 0`)");
  EXPECT_EQ(condition("x < 1 < 2"),
            "6: comparisons cannot be chained (join them: `0 < x and x < 1`)");
  EXPECT_EQ(condition("x and hit"),
            "0: expected true or false, found a number (compare it: `x > 0`)");
  EXPECT_EQ(condition("abs(v) < 1"),
            "0: a list of shape [3] cannot be used in a condition (compare one number of it: "
            "`max(abs(x)) < 1`, `norm(x) < 1`, `x[0] < 1`)");
  EXPECT_EQ(number("1e999"), "0: `1e999` is not a number");
  EXPECT_EQ(number(std::string(200, '(') + "x" + std::string(200, ')')), "33: nested too deeply");
  EXPECT_EQ(number("x" + std::string(1000, ' ')), "0: an expression has at most 1000 characters");
}

TEST(TaskExpression, WhatChangesFromStepToStep) {
  Diagnostics diagnostics;
  const auto changes = [&](const char* text) {
    return varies(
        *read_typed_expression(scalar(text), variables(), ExpressionType::number, {}, diagnostics));
  };
  EXPECT_FALSE(changes("2 * pi + cos(1)"));
  EXPECT_TRUE(changes("time"));
  EXPECT_TRUE(changes("1 + sum(before(v))"));
}

}  // namespace
}  // namespace eagerx::gen

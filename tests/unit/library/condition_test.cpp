#include "generator/frontend/library/condition.hpp"

#include <gtest/gtest.h>

#include <array>

#include "generator/frontend/library/library.hpp"
#include "generator/frontend/spec/reference.hpp"

namespace eagerx::gen {
namespace {

YamlValue scalar(const std::string& text, bool quoted = true) {
  YamlValue yaml;
  yaml.kind = YamlKind::scalar;
  yaml.text = text;
  yaml.quoted = quoted;
  yaml.span = {FileId::none, 3, 10, static_cast<std::uint32_t>(text.size()) + (quoted ? 2U : 0U)};
  return yaml;
}

Parameter parameter(const char* name, Parameter::Type type) {
  Parameter result;
  result.name.value = name;
  result.type = type;
  if (type == Parameter::Type::keyword) result.options = {"low", "band"};
  return result;
}

PortManifest port(const char* name) {
  PortManifest result;
  result.name.value = name;
  return result;
}

Entity entity() {
  Entity result;
  result.config = {
      parameter("n", Parameter::Type::integer),    parameter("gain", Parameter::Type::number),
      parameter("on", Parameter::Type::boolean),   parameter("kind", Parameter::Type::keyword),
      parameter("label", Parameter::Type::text),   parameter("whole", Parameter::Type::integers),
      parameter("list", Parameter::Type::numbers), parameter("none", Parameter::Type::numbers)};
  result.inputs = {port("signal"), port("both")};
  result.outputs = {port("both")};
  return result;
}

Facts facts() {
  return {{"n", std::int64_t{3}},
          {"gain", 2.5},
          {"on", true},
          {"kind", std::string("band")},
          {"label", std::string("m")},
          {"whole", std::vector<ConditionNumber>{std::int64_t{4}, std::int64_t{9007199254740993}}},
          {"list", std::vector<ConditionNumber>{1.5, 0.5}},
          {"none", std::vector<ConditionNumber>{}},
          {"rate", 30.0},
          {"size(inputs.signal)", std::int64_t{4}},
          {"window(inputs.signal)", std::int64_t{2}},
          {"dtype(inputs.signal)", std::string("uint8")},
          {"size(inputs.both)", std::int64_t{5}},
          {"size(outputs.both)", std::int64_t{6}}};
}

std::optional<bool> value_of(const std::string& text) {
  Diagnostics diagnostics;
  const Entity owner = entity();
  const auto condition = read_condition(scalar(text), owner, diagnostics);
  EXPECT_TRUE(condition) << text << ": "
                         << (diagnostics.all().empty() ? "" : diagnostics.all().front().message);
  return condition ? holds(*condition, facts()) : std::nullopt;
}

TEST(Condition, Holds) {
  for (const char* text : {"n == 3",
                           "n != 4",
                           "n < gain * 2",
                           "max(list) < rate / 2",
                           "abs(n - 5) == 2 and abs(gain - 1) == 1.5",
                           "min(list) == 0.5",
                           "max(n, gain, list) == 3",
                           "-n + 4 == 1",
                           "2 + 3 * 4 - 1 == 13",
                           "(2 + 3) * 4 == 20",
                           "7 / 2 == 3.5",
                           "1 - 2 - 3 == -4",
                           "-2^2 == -4",
                           "2 * n^3 / 27 == 2",
                           "(1 / 3)^2 == 1 / 9",
                           "max(n^2, gain) == 9",
                           "1e-3 < .5",
                           "--n == 3",
                           "on",
                           "not not on",
                           "on == true",
                           "on or false and false",
                           "not (on and false)",
                           "kind == band",
                           "band == kind",
                           "kind != low",
                           "kind in (low, band)",
                           "n in (1, 2, 3)",
                           "not (n in (1, 2))",
                           "label == m",
                           "len(list) == 2",
                           "len(none) == 0",
                           "increasing(whole)",
                           "not increasing(list)",
                           "increasing(none)",
                           "size(signal) == 4",
                           "window(signal) == 2",
                           "dtype(signal) == uint8",
                           "dtype(signal) in (float32, uint8)",
                           "size(inputs.both) + 1 == size(outputs.both)",
                           "max(none) < 0",
                           "min(none) > 0",
                           "min(-1, 1 / 0, n) == -1"})
    EXPECT_EQ(value_of(text), std::optional(true)) << text;
}

TEST(Condition, DoesNotHold) {
  for (const char* text : {"n < 3", "n > 3", "not on", "kind == low", "max(list) > rate",
                           "0 / 0 == 0 / 0", "0 / 0 < 1", "max(0 / 0, 1) == 1"})
    EXPECT_EQ(value_of(text), std::optional(false)) << text;
}

TEST(Condition, WholeNumbersAreExact) {
  EXPECT_EQ(value_of("max(whole) == 9007199254740993"), std::optional(true));
  EXPECT_EQ(value_of("max(whole) == 9007199254740992"), std::optional(false));
  EXPECT_EQ(value_of("9223372036854775807 > 9223372036854775806"), std::optional(true));
  // A result that does not fit becomes a double instead of wrapping around.
  EXPECT_EQ(value_of("9223372036854775807 + 1 > 9223372036854770000"), std::optional(true));
  EXPECT_EQ(value_of("9223372036854775807 * 2 > 0"), std::optional(true));
  EXPECT_EQ(value_of("-9223372036854775807 - 2 < 0"), std::optional(true));
}

TEST(Condition, SaysNothingOfWhatIsNotThere) {
  Diagnostics diagnostics;
  const Entity owner = entity();
  const auto condition = read_condition(scalar("n < size(both)"), owner, diagnostics);
  EXPECT_FALSE(condition);  // ambiguous
  const auto size = read_condition(scalar("n < size(inputs.both)"), owner, diagnostics);
  ASSERT_TRUE(size);
  EXPECT_EQ(holds(*size, {}), std::nullopt);
  EXPECT_EQ(holds(*size, {{"n", std::int64_t{1}}}), std::nullopt);
}

struct Wrong {
  const char* text;
  std::uint32_t column;
  const char* message;
};

TEST(Condition, TellsOfAProblemAtItsPlace) {
  // The text begins at column 11, behind its quote.
  for (const auto& [text, column, message] : std::initializer_list<Wrong>{
           {"", 11, "expected a value, found the end"},
           {"n <", 14, "expected a value, found the end"},
           {"n < ) 3", 15, "expected a value, found `)`"},
           {"n < 3 4", 17, "expected the end, found `4`"},
           {"n = 3", 13, "expected the end, found `=`"},
           {"(n < 3", 17, "expected `)`, found the end"},
           {"n < m", 15, "unknown name `m`"},
           {"gian > 0", 11, "unknown name `gian`"},
           {"n", 11, "expected true or false, found a number"},
           {"n and on", 11, "expected true or false, found a number"},
           {"on + 1 == 2", 11, "expected a number, found true or false"},
           {"list < 3", 11, "a list cannot be compared like this"},
           {"on < true", 11, "true or false cannot be compared like this"},
           {"kind < band", 11, "a text cannot be compared like this"},
           {"kind == bnad", 19, "`bnad` is not one of its choices"},
           {"kind in (low, bnad)", 25, "`bnad` is not one of its choices"},
           {"dtype(signal) == float", 28, "`float` is not one of its choices"},
           {"n < 3 < 4", 17, "comparisons cannot be chained"},
           {"len(n) == 1", 15, "expected a list, found a number"},
           {"lne(list) == 1", 11, "unknown function `lne`"},
           {"size(sginal) == 1", 16, "there is no input, output or state `sginal`"},
           {"size(both) == 1", 16, "`both` could be two ports"},
           {"window(outputs.both) == 1", 18, "`outputs.both` is not an input"},
           {"n < 1e999", 15, "`1e999` is not a number"},
           {"n < 0x10", 15, "`0x10` is not a number"},
           {"n < 1..2", 15, "`1..2` is not a number"},
           {"n < $", 15, "expected a value, found `$`"}}) {
    Diagnostics diagnostics;
    const Entity owner = entity();
    EXPECT_FALSE(read_condition(scalar(text), owner, diagnostics)) << text;
    ASSERT_EQ(diagnostics.error_count(), 1U) << text;
    const Diagnostic& problem = diagnostics.all().front();
    EXPECT_EQ(problem.code, "E0207") << text;
    EXPECT_EQ(problem.message, message) << text;
    EXPECT_EQ(problem.span.column, column) << text;
    EXPECT_EQ(problem.span.line, 3U) << text;
  }
}

TEST(Condition, ProcessorsHaveNoRate) {
  Diagnostics diagnostics;
  Entity owner = entity();
  owner.kind = EntityKind::processor;
  EXPECT_FALSE(read_condition(scalar("n < rate"), owner, diagnostics));
  EXPECT_EQ(diagnostics.all().front().message, "unknown name `rate`");
}

TEST(Condition, TextsThatWereWrittenOtherwiseAreMarkedWhole) {
  Diagnostics diagnostics;
  const Entity owner = entity();
  YamlValue escaped = scalar("n < m");
  escaped.span.length += 3;  // written with escapes
  EXPECT_FALSE(read_condition(escaped, owner, diagnostics));
  EXPECT_EQ(diagnostics.all().front().span.column, escaped.span.column);
}

TEST(Condition, NothingHangsOrCrashes) {
  const Entity owner = entity();
  const auto repeated = [](const std::string& text, std::size_t times) {
    std::string result;
    for (std::size_t i = 0; i < times; ++i) result += text;
    return result;
  };
  for (const std::string& text :
       {repeated("(", 900), repeated("-", 900), repeated("not ", 200), repeated("min(", 200),
        repeated("(-", 400), repeated("not(", 200) + "on" + repeated(")", 200), repeated("n", 5000),
        std::string("n < \xf0\x9f\x98\x80"), std::string("\0", 1)}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(read_condition(scalar(text), owner, diagnostics));
    EXPECT_EQ(diagnostics.error_count(), 1U);
  }
  EXPECT_EQ(value_of(repeated("1 + ", 200) + "0 == 200"), std::optional(true));
  EXPECT_EQ(value_of(repeated("(", 20) + "on" + repeated(")", 20)), std::optional(true));
}

/// Every text of a few pieces is either read, and then holds or not, or refused with one problem.
TEST(Condition, RandomTexts) {
  constexpr std::array kPieces = {"n", "on", "list", "kind", "band", "(",           ")",
                                  ",", "<",  "==",   "and",  "or",   "not",         "in",
                                  "+", "-",  "*",    "/",    "min(", "len(",        "size",
                                  "3", "1e", ".",    "true", "rate", "increasing(", "signal"};
  const Entity owner = entity();
  std::uint32_t state = 1;
  std::size_t read = 0;
  for (std::uint32_t i = 0; i < 50'000; ++i) {
    std::string text;
    for (std::uint32_t length = 1U + i % 9U; length > 0; --length) {
      state = state * 1664525U + 1013904223U;
      text += kPieces.at((state >> 8U) % kPieces.size());
      text += ' ';
    }
    Diagnostics diagnostics;
    const auto condition = read_condition(scalar(text), owner, diagnostics);
    EXPECT_EQ(diagnostics.error_count(), condition ? 0U : 1U) << text;
    if (!condition) continue;
    EXPECT_TRUE(holds(*condition, facts()).has_value()) << text;
    ++read;
  }
  EXPECT_GT(read, 200U);
}

KnownReferences references() {
  return {{"config limit", Rational(5, 2)},
          {"config rate", std::int64_t{30}},
          {"config list", std::vector<ConditionNumber>{std::int64_t{4}, Rational(1, 2)}},
          {"config list 0", std::int64_t{4}},
          {"config large", 1e300},
          {"config name", std::string("me")},
          {"config missing", std::nullopt},
          {"size list", std::int64_t{2}},
          {"sensors theta rate", std::int64_t{60}}};
}

/// The number as text, or what is wrong.
std::string computed(const std::string& text) {
  Diagnostics diagnostics;
  const YamlValue yaml = scalar(text, false);
  EXPECT_TRUE(is_expression(yaml)) << text;
  const auto expression = read_expression(yaml, references(), diagnostics);
  if (!expression) return diagnostics.all().front().message;
  Facts known;
  for (const auto& [name, value] : references()) {
    if (value) known[name] = *value;
  }
  const auto value = evaluate(*expression, known);
  return value ? to_string(*value) : "unknown";
}

TEST(Expression, ComputesExactly) {
  for (const auto& [text, expected] : {std::pair{"-$(config limit)", "-2.5"},
                                       {"$(1 / config rate)", "1/30"},
                                       {"$(2 * config limit)", "5"},
                                       {"2 * $(config limit)", "5"},
                                       {"$(config limit) - $(config rate)", "-27.5"},
                                       {"-(2 + $(config rate)) / $(size list)", "-16"},
                                       {"$(0.1 + 0.2)", "0.3"},
                                       {"$(config list 0 * config limit)", "10"},
                                       {"$(max(config list) - min(config list))", "3.5"},
                                       {"$(len(config list))", "2"},
                                       {"$(sensors theta rate / 4)", "15"},
                                       {"$(3 * config large)", "3e+300"},
                                       {"$(9223372036854775807 + 1)", "9.223372036854776e+18"}}) {
    EXPECT_EQ(computed(text), expected) << text;
  }
}

TEST(Expression, SaysWhatIsWrong) {
  for (const auto& [text, expected] :
       {std::pair{"$(config limt * 2)", "`config limt` refers to nothing"},
        {"$(config)", "`config` refers to nothing"},
        {"limit * $(config limit)", nullptr},
        {"2 * (config limit + $(1))", nullptr},
        {"$(config name + 1)", "expected a number, found a text"},
        {"-$(config list)", "expected a number, found a list"},
        {"$(config limit > 1)", "expected `)`, found `>`"},
        {"$(2 *)", "expected a value, found `)`"},
        {"$(size(list))", "unknown function `size`"},
        {"$(1 2)", "expected `)`, found `2`"},
        {"$()", "expected a value, found `)`"},
        {"-$(config missing)", "unknown"}}) {
    if (expected == nullptr) {
      EXPECT_FALSE(is_expression(scalar(text, false))) << text;
    } else {
      EXPECT_EQ(computed(text), expected) << text;
    }
  }
}

TEST(Expression, TextsAreNone) {
  for (const char* text : {"$(config a)/file", "folder/$(config a)", "$(config a", "3", ""})
    EXPECT_FALSE(is_expression(scalar(text, false))) << text;
  EXPECT_FALSE(is_expression(scalar("$(config limit)", true)));
}

// A word of a text is not a reference: `about: "… (at the given rate)"` once asked for a rate.
TEST(Expression, IsAskedWhatItRefersTo) {
  for (const char* text : {"$(rate)", "$(2 * rate)", "1 / $(rate)"})
    EXPECT_TRUE(refers_to(scalar(text, false), {"rate"})) << text;
  for (const char* text : {"at the given rate)", "$(sensors theta rate)", "$(config rate)"})
    EXPECT_FALSE(refers_to(scalar(text, false), {"rate"})) << text;
  EXPECT_FALSE(refers_to(scalar("$(rate)", true), {"rate"}));
  EXPECT_TRUE(refers_to(made_list({scalar("1", false), scalar("$(rate)", false)}, {}), {"rate"}));
}

}  // namespace
}  // namespace eagerx::gen

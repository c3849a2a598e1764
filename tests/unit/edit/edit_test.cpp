#include "generator/edit/edit.hpp"

#include <gtest/gtest.h>

#include "generator/edit/helps.hpp"
#include "generator/outline/lines.hpp"

namespace eagerx::gen {
namespace {

TEST(Edit, SplicesStayWhereTheyWere) {
  EXPECT_EQ(applied("one two three", {{{4, 7}, "2"}, {{0, 3}, "uno"}, {{8, 8}, "<"}}),
            "uno 2 <three");
  EXPECT_EQ(applied("one two", {{{0, 5}, "x"}, {{4, 7}, "y"}, {{6, 99}, "z"}}),
            "xwo");  // overlaps, and past the end
}

TEST(Edit, TakesTheHelpAtItsWord) {
  const std::string text = "a: \xF0\x9F\xA4\x96\nb: thetta\n";
  Diagnostic problem;
  problem.span = {static_cast<FileId>(0), 2, 4, 6};
  EXPECT_FALSE(fix_of(problem, text));
  problem.help = "did you mean `theta`?";
  const auto fix = fix_of(problem, text);
  ASSERT_TRUE(fix);
  EXPECT_EQ(fix->reason, "Change to `theta`");
  EXPECT_EQ(applied(text, fix->splices), "a: \xF0\x9F\xA4\x96\nb: theta\n");
  problem.span.length = 0;
  EXPECT_FALSE(fix_of(problem, text));
}

TEST(Edit, LinesAreCountedInCodePoints) {
  const std::string text =
      "a\xF0\x9F\xA4\x96"
      "b\nc\n";
  const Bytes word = bytes_of(text, {static_cast<FileId>(0), 1, 2, 2});
  EXPECT_EQ(text.substr(word.begin, word.end - word.begin),
            "\xF0\x9F\xA4\x96"
            "b");
  EXPECT_EQ(bytes_of("ab\ncd", {}).end, 2U);
  EXPECT_EQ(bytes_of("\xEF\xBB\xBF"
                     "ab\ncd",
                     {static_cast<FileId>(0), 1, 1, 2})
                .begin,
            3U);  // a byte order mark
  EXPECT_EQ(bytes_of("ab", {static_cast<FileId>(0), 9, 9, 9}).begin, 2U);
}

constexpr const char* kGraph = R"(name: arm # the arm
objects:
  arm: {type: Arm}
  arm2: {type: Arm}
nodes:
  pid: {type: PidController, config: {text: arm}}
actions: {arm: {space: {like: arm.u}}}
connections:
  - {from: actions.arm, to: pid.arm}
  - {from: pid.u, to: "arm.u"}
  - {from: "arm[0].q", to: observations.arm}
  - {from: arm2.q, to: pid.q}
safety:
  outputs: {arm.u: {max: 1}}
tunable: [arm]
variants:
  real:
    objects: {arm: {config: {a: 1}}}
)";

TEST(Rename, FindsWhatNamesAnObjectAndNothingElse) {
  EXPECT_EQ(uses_of(kGraph, "arm").size(), 7U);
  EXPECT_TRUE(uses_of(kGraph, "elbow").empty());
  const auto edit = rename(kGraph, "arm", "left");
  ASSERT_TRUE(edit);
  const std::string text = applied(kGraph, edit->splices);
  for (const char* const kept :
       {"name: arm # the arm", "arm2: {type: Arm}", "text: arm",
        "actions: {arm:", "from: actions.arm, to: pid.arm", "to: observations.arm", "from: arm2.q"})
    EXPECT_NE(text.find(kept), std::string::npos) << kept << "\n" << text;
  for (const char* const changed :
       {"  left: {type: Arm}", "like: left.u", "to: \"left.u\"", "from: \"left[0].q",
        "{left.u: {max: 1}}", "tunable: [left]", "objects: {left: {config"})
    EXPECT_NE(text.find(changed), std::string::npos) << changed << "\n" << text;
  // And back.
  const auto back = rename(text, "left", "arm");
  ASSERT_TRUE(back);
  EXPECT_EQ(applied(text, back->splices), kGraph);
}

TEST(Rename, RefusesNamesThatAreNone) {
  for (const char* const name : {"arm2", "pid", "", "a b", "2a", "a.b", "actions", "engine"})
    EXPECT_FALSE(rename(kGraph, "arm", name)) << name;
  EXPECT_FALSE(rename(kGraph, "nobody", "x"));
  EXPECT_EQ(name_at(kGraph, std::string_view(kGraph).find("arm[0]") + 1), "arm");
  EXPECT_EQ(name_at(kGraph, 0), "");
}

}  // namespace
}  // namespace eagerx::gen

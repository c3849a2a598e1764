#include "generator/backend/emit/wrap.hpp"

#include <gtest/gtest.h>

namespace eagerx::gen {
namespace {

const std::string kLong(60, 'a');

TEST(Wrapped, ShortLinesStay) {
  for (const char* text : {"", "\n", "int a;\n\n  // b\nint c;", "\t x\r\n"})
    EXPECT_EQ(wrapped(text), text);
}

TEST(Wrapped, BreaksWhereTheFewestBracketsAreOpen) {
  EXPECT_EQ(wrapped("  f(g(" + kLong + ", 1), h(" + kLong + ", 2));\n"),
            "  f(g(" + kLong + ", 1),\n    h(" + kLong + ", 2));\n");
  EXPECT_EQ(wrapped(kLong + " = Array<float, 3>{" + kLong + "};"),
            kLong + " =\n    Array<float, 3>{" + kLong + "};");
  EXPECT_EQ(wrapped("Array<float, 3> " + kLong + "{.low = {{1}}, .high = {{" + kLong + "}}};"),
            "Array<float, 3> " + kLong + "{\n    .low = {{1}}, .high = {{" + kLong + "}}};");
}

TEST(Wrapped, AnInitializerIsAlignedOrBelow) {
  EXPECT_EQ(wrapped("  const T a[2] = {" + kLong + ", " + kLong + "};"),
            "  const T a[2] = {" + kLong + ",\n                  " + kLong + "};");
  const std::string half = kLong.substr(30), name = kLong.substr(20);
  EXPECT_EQ(wrapped("  A in{.b = {" + half + ", 1}, .c = {" + half + ", 2}, .d = 3};"),
            "  A in{.b = {" + half + ", 1}, .c = {" + half + ", 2}, .d = 3};");
  EXPECT_EQ(wrapped("  const Inputs in{.first = {" + half + ", 1}, .second = {" + half + ", 2}};"),
            "  const Inputs in{.first = {" + half + ", 1},\n                  .second = {" + half +
                ", 2}};");
  EXPECT_EQ(wrapped("  T<U> " + name + "{.low = {{1, 2}}, .high = {{" + kLong + ", 3}}};"),
            "  T<U> " + name + "{\n      .low = {{1, 2}}, .high = {{" + kLong + ", 3}}};");
}

// As clang-format 14 writes them.
TEST(Wrapped, AListIsAsideOfItsMemberUnlessThatTakesAsManyLines) {
  const auto zeros = [](int count) {
    std::string text = "0.0F";
    for (int i = 1; i < count; ++i) text += ", 0.0F";
    return text;
  };
  const std::string twelve = zeros(12), thirteen = zeros(13);
  const std::string aside = ",\n                        ", below = ",\n                    ";
  EXPECT_EQ(wrapped("    return {.target = {{" + zeros(13) + "}}};"),
            "    return {\n        .target = {{" + thirteen + "}}};");
  EXPECT_EQ(wrapped("    return {.target = {{" + zeros(18) + "}}};"),
            "    return {.target = {{" + twelve + aside + zeros(6) + "}}};");
  EXPECT_EQ(wrapped("    return {.target = {{" + zeros(26) + "}}};"),
            "    return {\n        .target = {{" + thirteen + below + thirteen + "}}};");
}

TEST(Wrapped, GroupsAreOneALine) {
  EXPECT_EQ(wrapped("    {1, 2}, {3, 4},  // a\n    {5, 66},  // b\n"),
            "    {1, 2},\n    {3, 4},   // a\n    {5, 66},  // b\n");
}

// As clang-format 14 writes them.
TEST(Wrapped, LongListsAreInColumnsBehindTheirBraceOrBelow) {
  EXPECT_EQ(
      wrapped("  static constexpr std::uint8_t kKindAt[20] = {0, 1, 1, 1, 2, 1, 1, 1, 2, 1, 1, 1, "
              "2, 1, 1, 1, 2, 1, 1, 1};\n"),
      "  static constexpr std::uint8_t kKindAt[20] = {0, 1, 1, 1, 2, 1, 1, 1, 2, 1,\n"
      "                                               1, 1, 2, 1, 1, 1, 2, 1, 1, 1};\n");
  EXPECT_EQ(
      wrapped("    static constexpr std::array<double, 9> a = {0.785352033, -0.000925552165, 0.0, "
              "0.0462776083, 0.999952532, 0.0, 6.01745125e-06, 0.00024999507, 1.0};\n"),
      "    static constexpr std::array<double, 9> a = {0.785352033,    -0.000925552165, 0.0,\n"
      "                                                0.0462776083,   0.999952532,     0.0,\n"
      "                                                6.01745125e-06, 0.00024999507,   1.0};\n");
  EXPECT_EQ(
      wrapped("  static constexpr std::array<const char*, 8> kObservationNames{\"angle\", "
              "\"wound\", \"speed\", \"mean\", \"applied\", \"test\", \"motor\", \"dcsc\"};\n"),
      "  static constexpr std::array<const char*, 8> kObservationNames{\n"
      "      \"angle\", \"wound\", \"speed\", \"mean\", \"applied\", \"test\", \"motor\", "
      "\"dcsc\"};\n");
}

TEST(Wrapped, ACallGoesBelowAsAWhole) {
  EXPECT_EQ(wrapped("    robot_servos_action_cursor_.reset(eagerx::DelayQuanta<1, 5000000, "
                    "20000000>::of(robot_servos_action_delay_s_));\n"),
            "    robot_servos_action_cursor_.reset(\n"
            "        eagerx::DelayQuanta<1, 5000000, "
            "20000000>::of(robot_servos_action_delay_s_));\n");
  EXPECT_EQ(wrapped("        PendulumPendulumActuatorIo::Outputs out{.action_applied = "
                    "pendulum_pendulum_actuator_action_applied_[0]};\n"),
            "        PendulumPendulumActuatorIo::Outputs out{.action_applied =\n"
            "                                                    "
            "pendulum_pendulum_actuator_action_applied_[0]};\n");
}

TEST(Wrapped, AConditionIsAlignedBehindReturn) {
  EXPECT_EQ(wrapped("    return " + kLong + " && " + kLong.substr(20) + " && b;\n"),
            "    return " + kLong + " &&\n           " + kLong.substr(20) + " && b;\n");
}

TEST(Wrapped, NoBlankLineIsBeforeABraceButThatOfANamespace) {
  EXPECT_EQ(wrapped("class A {\n  int b;\n\n};\n"), "class A {\n  int b;\n};\n");
  const std::string text = "int a;\n\n}  // namespace b\n";
  EXPECT_EQ(wrapped(text), text);
}

TEST(Wrapped, ACommentGoesOnInTheNextLine) {
  EXPECT_EQ(wrapped("  // " + kLong + " " + kLong + " b\n  // c d\n  int e;\n"),
            "  // " + kLong + "\n  // " + kLong + " b c d\n  int e;\n");
}

TEST(Wrapped, CommentsBehindCodeAreInOneColumn) {
  EXPECT_EQ(wrapped("int a;  // b\nlong c;  // d\n\nint e;  // f\n"),
            "int a;   // b\nlong c;  // d\n\nint e;  // f\n");
}

TEST(Wrapped, IncludesAreSortedUnlessOneIsOfC) {
  EXPECT_EQ(wrapped("#include <b>\n\n#include \"x\"\n#include <a/c.hpp>\n\nint d;\n"),
            "#include <a/c.hpp>\n#include <b>\n\n#include \"x\"\n\nint d;\n");
  const std::string text = "#include <b.h>\n#include <a>\n";
  EXPECT_EQ(wrapped(text), text);
}

TEST(Wrapped, IncludesThatNothingNeedsAreLeftOut) {
  EXPECT_EQ(wrapped("#include <array>\n#include <cstddef>\n#include <limits>\n#include <span>\n\n"
                    "std::array<int, 2> a;\n"),
            "#include <array>\n#include <span>\n\nstd::array<int, 2> a;\n");
}

TEST(Wrapped, ShortFunctionsOfClassesAreOneLine) {
  EXPECT_EQ(wrapped("class A {\n  int b() const {\n    return 1;\n  }\n  void c() {\n  }\n};\n"),
            "class A {\n  int b() const { return 1; }\n  void c() {}\n};\n");
  for (const std::string text : {"int b() {\n  return 1;\n}\n", "  if (a) {\n    return;\n  }\n",
                                 "  template <class F>\n  void f(F&& f) {\n    f();\n  }\n"})
    EXPECT_EQ(wrapped(text), text);
}

TEST(Wrapped, AllLinesOfAStatementHaveTheSameIndent) {
  std::string list = "  f(0";
  for (int i = 0; i < 20'000; ++i) list += ", 1234567";
  const std::string text = wrapped(list + ");\n");
  for (std::size_t begin = 0, end = 0; begin < text.size(); begin = end + 1) {
    end = text.find('\n', begin);
    const std::string line = text.substr(begin, end - begin);
    ASSERT_LE(line.size(), 100U);
    ASSERT_EQ(line.find_first_not_of(' '), begin == 0 ? 2U : 6U) << line;
  }
}

// As clang-format 14 writes them; the lines are joined before.
TEST(Wrapped, AnExpressionIsAsideOrBelow) {
  for (
      const std::string text : {
          R"(    out.near = -sqrt(square(Real(0.5) * (sin(q[0]) + sin(q[0] + q[1] + q[2])) - goal[0]) +
                     square(Real(0.5) * (sin(q[0]) + sin(q[0] + q[1] + q[2])) - goal[0]));)",
          R"(    out.near = -eagerx::sqrt(
        square(Real(0.5) * (sin(q[0]) + sin(q[0] + q[1] + q[2])) - goal[0] - goals[10]) +
        square(Real(0.5) * (sin(q[0]) + sin(q[0] + q[1] + q[2])) - goal[0] - goals[10]));)",
          R"(    const auto at_goal =
        eagerx::sqrt(
            square(Real(0.5) * (sin(q[0]) + sin(q[0] + q[1] + q[2])) - goal[0] - goals[10]) +
            square(Real(0.5) * (sin(q[0]) + sin(q[0] + q[1] + q[2])) - goal[0] - goals[10])) <
        Real(0.05);)",
          R"(    out.wild = Real(-0.001) *
               exp(Real(200) * max(abs(seen[2]) - Real(7.5), square(seen[3]) + square(seen[4])));)",
          R"(    const auto fallen = pose[2] < Real(0.2) ||
                        eagerx::square(pose[3]) + eagerx::square(pose[4]) > Real(0.5) ||
                        pose[11] > Real(0.777);)"}) {
    std::string line = text;
    for (std::size_t at = line.find('\n'); at != std::string::npos; at = line.find('\n')) {
      const std::size_t end = line.find_first_not_of(' ', at + 1);
      line.replace(at, end - at, line[at - 1] == '(' ? "" : " ");
    }
    EXPECT_EQ(wrapped(line), text);
  }
}

TEST(Wrapped, ComparisonsStayWhole) {
  const std::string word(30, 'a');
  const std::string term = word + ".received() == 0";
  EXPECT_EQ(wrapped("x = " + term + " || " + term + " || " + term + ";"),
            "x = " + term + " ||\n    " + term + " ||\n    " + term + ";");
  const std::string less = kLong + " <= " + kLong;
  EXPECT_EQ(wrapped(less), less);
}

TEST(Wrapped, ABodyGoesBelowItsIf) {
  EXPECT_EQ(wrapped("if (a && (" + kLong + ")) f(" + kLong + ");"),
            "if (a && (" + kLong + "))\n  f(" + kLong + ");");
  EXPECT_EQ(wrapped("if (" + kLong + " || (b && " + std::string(28, 'c') + ")) {"),
            "if (" + kLong + " ||\n    (b && " + std::string(28, 'c') + ")) {");
}

TEST(Wrapped, LiteralsStayWhole) {
  const std::string text = "f(\"" + kLong + ", // " + kLong + ", (\", ',');";
  EXPECT_EQ(wrapped(text), text);
  EXPECT_EQ(wrapped("f(\"" + kLong + "\\\", (\", '\\'', " + kLong + ");"),
            "f(\"" + kLong + "\\\", (\", '\\'',\n  " + kLong + ");");
  const std::string include = "#include <" + kLong + ", " + kLong + ">";
  EXPECT_EQ(wrapped(include), include);
}

// As clang-format 14 writes it.
TEST(Wrapped, ATextThatIsAStatementBreaksBetweenWords) {
  EXPECT_EQ(wrapped("    static constexpr std::string_view joints = \"front_left_coxa "
                    "front_left_femur front_left_tibia front_right_coxa front_right_femur "
                    "front_right_tibia middle_left_coxa\";\n"),
            "    static constexpr std::string_view joints =\n"
            "        \"front_left_coxa front_left_femur front_left_tibia front_right_coxa "
            "front_right_femur \"\n"
            "        \"front_right_tibia middle_left_coxa\";\n");
}

// As clang-format 14 writes it.
TEST(Wrapped, AChoiceThatIsTooLongIsThreeLines) {
  EXPECT_EQ(wrapped("    refused_delays_ += eagerx::DelayQuanta<1, 5000000, 20000000>::accepts("
                    "robot_position_actuator_action_delay_s_) ? 0U : 1U;\n"),
            "    refused_delays_ +=\n"
            "        eagerx::DelayQuanta<1, 5000000, 20000000>::accepts("
            "robot_position_actuator_action_delay_s_)\n"
            "            ? 0U\n"
            "            : 1U;\n");
}

TEST(Wrapped, ABracketInALiteralIsNoCall) {
  const std::string text = "    \"" + kLong + " in f() " + kLong + "\");";
  EXPECT_EQ(wrapped(text), text);
}

TEST(Wrapped, CommentsBreakBetweenWordsAndMoveAbove) {
  EXPECT_EQ(wrapped("  /// " + kLong + " " + kLong + " b\n"),
            "  /// " + kLong + "\n  /// " + kLong + " b\n");
  EXPECT_EQ(wrapped("  int " + kLong + ";  // " + kLong),
            "  // " + kLong + "\n  int " + kLong + ";");
  EXPECT_EQ(wrapped("// " + kLong + ": " + kLong + ", graph.yaml:3:5"),
            "// " + kLong + ":\n// " + kLong + ", graph.yaml:3:5");
}

TEST(Wrapped, TablesStay) {
  const std::string table = "// clang-format off\n" + kLong + ", " + kLong + "\n";
  EXPECT_EQ(wrapped(table), table);
  EXPECT_EQ(wrapped(table + "// clang-format on\n" + kLong + ", " + kLong),
            table + "// clang-format on\n" + kLong + ",\n    " + kLong);
}

TEST(Wrapped, WhatCannotBeBrokenStays) {
  const std::string word = "// " + kLong + kLong;
  const std::string blanks(200, ' ');
  for (const std::string& text :
       {word, kLong + kLong, blanks, blanks + "x", std::string(300, '('), std::string(300, '"')})
    EXPECT_EQ(wrapped(text), text);
}

}  // namespace
}  // namespace eagerx::gen

// Messages of compilers, and calls in object files.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "generator/backend/compile/forbidden.hpp"
#include "generator/backend/compile/messages.hpp"
#include "generator/support/process/process.hpp"
#include "tests/unit/stages/graphs.hpp"

namespace eagerx::gen {
namespace {

TEST(Compile, MessagesHaveTheirPlaces) {
  const auto found = messages_in(
      "In file included from a.cpp:1:\n"
      "a:b/gain.hpp:12:5: error: 'x' was not declared: in this scope\n"
      "gain.hpp:3:1: warning: unused [-Wunused]\n"
      "gain.hpp:4:2: note: here\n"
      "main.cpp:1:10: fatal error: no.hpp: No such file");
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].file, "a:b/gain.hpp");
  EXPECT_EQ(found[0].line, 12U);
  EXPECT_EQ(found[0].column, 5U);
  EXPECT_EQ(found[0].text, "'x' was not declared: in this scope");
  EXPECT_TRUE(found[0].error && !found[1].error && found[2].error);
}

TEST(Compile, WhatHasNoPlaceIsNoMessage) {
  for (const char* line : {"", "error: no file", ": error: x", ":1: error: x", "a:1: error: x",
                           "a:b:c: error: x", "a:1:99999999999: error: x", "a::: error: "})
    EXPECT_TRUE(messages_in(line).empty()) << line;
}

/// "takes memory from a heap" of each forbidden call of this function.
std::vector<ForbiddenCall> calls_of(const std::string& text) {
  const TestFolder folder;
  const std::string source = folder.file("a.cpp", text), object = folder.path() + "/a.o";
  const auto compiled = run_process({"c++", "-std=c++20", "-g", "-O1", "-c", source, "-o", object});
  EXPECT_TRUE(compiled && compiled->exit_code == 0);
  return forbidden_calls(object);
}

TEST(Compile, AHeapAndAStaticCounterAreFoundWithTheirLines) {
  const auto found = calls_of(
      "int* take(int n) {\n"
      "  static int count = 0;\n"
      "  count += n;\n"
      "  return new int(count);\n"
      "}\n");
  ASSERT_GE(found.size(), 2U);
  EXPECT_NE(found[0].what.find("heap"), std::string::npos) << found[0].what;
  ASSERT_FALSE(found[0].places.empty());
  EXPECT_EQ(found[0].places.front().line, 4U);
  for (std::size_t i = 1; i < found.size(); ++i)
    EXPECT_FALSE(found[i].variable.empty()) << "the counter: " << found[i].what;
}

TEST(Compile, CodeForBoardsCallsNothingForbidden) {
  EXPECT_TRUE(calls_of("float twice(float x) { return 2 * x; }\n").empty());
  EXPECT_TRUE(forbidden_calls("/no/such/object.o").empty());
}

}  // namespace
}  // namespace eagerx::gen

// Nothing that a file holds may take the program down or for ever.
#include <gtest/gtest.h>

#include <string>

#include "tests/unit/read/reading.hpp"

namespace eagerx::gen {
namespace {

std::string repeat(const std::string& text, std::size_t count) {
  std::string result;
  for (std::size_t i = 0; i < count; ++i) result += text;
  return result;
}

TEST(Limits, Bytes) {
  ReadLimits limits;
  limits.max_bytes = 8;
  EXPECT_EQ(Reading("a: 12345", Tags::refuse, limits).report(), "");
  expect_error("a: 123456", "E0102", "0:0+0", "larger than 8 bytes", limits);
}

TEST(Limits, Depth) {
  EXPECT_EQ(Reading(repeat("[", 64) + repeat("]", 64)).report(), "");
  expect_error(repeat("[", 65) + repeat("]", 65), "E0110", "1:65+1", "deeper than 64 levels");
  expect_error("a: " + repeat("{b: ", 64) + repeat("}", 64), "E0110", "1:256+1", "64 levels");
  expect_error(repeat("- ", 65) + "a", "E0110", "1:129+1", "64 levels");
  ReadLimits limits;
  limits.max_depth = 2;
  expect_error("a:\n  b:\n    c: 1\n", "E0110", "3:5+2", "deeper than 2 levels", limits);
}

TEST(Limits, DepthThroughAliases) {
  ReadLimits limits;
  limits.max_depth = 3;
  expect_error("a: &a [1]\nb: [[*a]]\n", "E0110", "2:6+2", "deeper than 3 levels", limits);
  EXPECT_EQ(Reading("a: &a [1]\nb: [*a]\n", Tags::refuse, limits).report(), "");
}

TEST(Limits, HopelessDepth) {
  expect_error(std::string(100'000, '['), "E0110", "1:65+1", "64 levels");
  expect_error(std::string(1'000'000, '['), "E0110", "1:65+1", "64 levels");
  expect_error(repeat("{a: ", 300'000), "E0110", "1:257+1", "64 levels");
  expect_error(repeat("- ", 100'000) + "a", "E0110", "1:129+1", "64 levels");
  expect_error(repeat("? ", 100'000) + "a", "E0110", "1:129+1", "64 levels");
}

TEST(Limits, DepthPastTheParsersOwn) {
  ReadLimits limits;
  limits.max_depth = 1'000'000;  // yaml-cpp stops at 500
  expect_error(std::string(5'000, '[') + std::string(5'000, ']'), "E0110", "1:499+1", "499 levels",
               limits);
}

TEST(Limits, Nodes) {
  ReadLimits limits;
  limits.max_values = 4;  // the map, a key, the list, one item
  EXPECT_EQ(Reading("a:\n- b\n", Tags::refuse, limits).report(), "");
  expect_error("a:\n- b\n- c\n", "E0110", "3:3+1", "more than 4 values", limits);
  expect_error("a: [b, c, d, e]\n", "E0110", "1:8+1", "more than 4 values", limits);
}

TEST(Limits, BillionLaughs) {
  std::string text = "a0: &a0 [x,x,x,x,x,x,x,x,x,x]\n";
  for (int i = 1; i < 20; ++i) {
    const std::string alias = "*a" + std::to_string(i - 1);
    text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + repeat(alias + ",", 10) +
            "]\n";
  }
  ReadLimits limits;
  limits.max_values = 20'000;
  expect_error(text, "E0110", "4:9+1", "more than 20000 values", limits);
}

TEST(Limits, LongTextBehindManyAliases) {
  ReadLimits limits;
  limits.max_bytes = 10'000;
  const std::string text =
      "a: &a " + std::string(5000, 'x') + "\nb: [" + repeat("*a,", 1000) + "]\n";
  expect_error(text, "E0110", "2:20+2", "too much text", limits);
}

TEST(Limits, AnchorsInsideAnchors) {
  ReadLimits limits;
  limits.max_values = 10'000;
  std::string text;
  for (int i = 0; i < 60; ++i) text += "&b" + std::to_string(i) + " [";
  text += repeat("1,", 1000) + std::string(60, ']');
  const Reading reading(text, Tags::refuse, limits);
  ASSERT_EQ(reading.diagnostics.error_count(), 1U);
  EXPECT_EQ(reading.diagnostics.all()[0].code, "E0110");
}

TEST(Limits, LongLinesTakeLinearTime) {
  // 100,000 values on one line: quadratic work would be ten thousand million steps.
  const Reading reading("a: [" + repeat("ä,", 100'000) + "]\n");
  EXPECT_EQ(reading.report(), "");
  ASSERT_NE(reading.root.find("a"), nullptr);
  EXPECT_EQ(place(reading.root.find("a")->items.back().span), "1:200003+1");
}

}  // namespace
}  // namespace eagerx::gen

// Foreign telemetry.json files.
#include "generator/tools/monitor/telemetry_layout.hpp"

#include <gtest/gtest.h>

#include <eagerx/version.hpp>
#include <string>

#include "generator/support/json/json.hpp"

namespace eagerx::gen {
namespace {

const std::string kLayout =
    R"({"format": "eagerx telemetry 1", "graph": "g", "hash": "0x0123456789abcdef", "runtime": "VERSION",
 "baud": 115200, "groups": [{"rate": "125/4", "every": 2, "bytes": 24, "channels": [
 {"name": "a/x", "port": "a.x", "dtype": "float32", "shape": [3], "offset": 8},
 {"name": "a/on", "port": "a.on", "dtype": "bool", "shape": [], "offset": 20}]}]})";

std::string layout(std::string text = kLayout) {
  const std::string version = std::to_string(kVersionMajor) + "." + std::to_string(kVersionMinor);
  if (const auto at = text.find("VERSION"); at != std::string::npos) text.replace(at, 7, version);
  return text;
}

std::string problem_of(const std::string& text) {
  std::string problem;
  const bool good = read_telemetry_layout(text, problem).has_value();
  EXPECT_EQ(good, problem.empty());
  return problem;
}

TEST(TelemetryLayout, IsReadAsItWasWritten) {
  std::string problem;
  const auto found = read_telemetry_layout(layout(), problem);
  ASSERT_TRUE(found) << problem;
  EXPECT_EQ(found->hash, 0x0123456789abcdefU);
  ASSERT_EQ(found->groups.size(), 1U);
  EXPECT_EQ(found->groups[0].rate_num, 125U);
  EXPECT_EQ(found->groups[0].channels[0].size, 3U);
  EXPECT_EQ(found->groups[0].channels[1].dtype, trace_log::Dtype::boolean);
}

TEST(TelemetryLayout, EveryMemberIsNeeded) {
  for (const char* name : {"format", "hash", "runtime", "baud", "groups", "rate", "every", "bytes",
                           "channels", "dtype", "shape", "offset"}) {
    std::string text = layout();
    const std::string quoted = "\"" + std::string(name) + "\"";
    text.replace(text.find(quoted), quoted.size(), "\"gone\"");
    EXPECT_NE(problem_of(text), "") << name;
  }
}

TEST(TelemetryLayout, NothingInItIsTrusted) {
  const std::pair<const char*, const char*> changes[] = {
      {"0x0123456789abcdef", "0x10123456789abcdef"},
      {"0x0123456789abcdef", "123"},
      {"125/4", "125"},
      {"125/4", "0/1"},
      {"125/4", "1/0"},
      {"\"every\": 2", "\"every\": 0"},
      {"\"every\": 2", "\"every\": -1"},
      {"115200", "99999999999"},
      {"[3]", "[-3]"},
      {"[3]", "[4294967296, 4294967296, 2]"},
      {"\"offset\": 20", "\"offset\": 23999"},
      {"\"bytes\": 24", "\"bytes\": 9"},
      {"float32", "float"},
      {"\"offset\": 8", "\"offset\": \"8\""}};
  for (const auto& [from, to] : changes) {
    std::string text = layout();
    text.replace(text.find(from), std::string(from).size(), to);
    EXPECT_NE(problem_of(text), "") << to;
  }
  for (const char* text : {"", "{", "[]", "null", "{\"format\": \"eagerx telemetry 2\"}"})
    EXPECT_NE(problem_of(text), "") << text;
}

}  // namespace
}  // namespace eagerx::gen

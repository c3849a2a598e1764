#include "generator/frontend/compose/port_pattern.hpp"

#include <gtest/gtest.h>

namespace eagerx::gen {
namespace {

PortPattern pattern(const std::string& text) {
  Diagnostics diagnostics;
  const auto parsed = parse_pattern({text, {}}, diagnostics);
  EXPECT_TRUE(parsed) << text;
  return parsed.value_or(PortPattern{});
}

const CountOf kCounts = [](const std::string& name) -> std::optional<std::int64_t> {
  if (name == "leg") return 3;
  if (name == "arm") return 2;
  if (name.ends_with("/joint")) return 2;
  return std::nullopt;
};

std::vector<std::string> connections(const std::string& from, const std::string& to,
                                     std::size_t problems = 0) {
  Diagnostics diagnostics;
  std::vector<std::string> result;
  const auto text = [](const IndexedPort& port) {
    return port.element ? port.port + "#" + std::to_string(*port.element) : port.port;
  };
  for (const auto& one : indexed_connections(pattern(from), pattern(to), kCounts, diagnostics))
    result.push_back(text(one.from) + " " + text(one.to));
  EXPECT_EQ(diagnostics.error_count(), problems) << from << " → " << to;
  return result;
}

using Texts = std::vector<std::string>;

TEST(PortPattern, ConnectsOneByOne) {
  EXPECT_EQ(connections("leg[*].y", "leg[*].x"),
            (Texts{"leg[0].y leg[0].x", "leg[1].y leg[1].x", "leg[2].y leg[2].x"}));
}

TEST(PortPattern, ConnectsEachToTheNextAsFarAsBothGo) {
  EXPECT_EQ(connections("leg[i].y", "leg[i + 1].x"),
            (Texts{"leg[0].y leg[1].x", "leg[1].y leg[2].x"}));
  EXPECT_EQ(connections("leg[i-2].y", "arm[i - 1].x"), (Texts{"leg[0].y arm[1].x"}));
}

TEST(PortPattern, HasSeveralIndices) {
  EXPECT_EQ(connections("a.x", "arm[i]/joint[j].x").size(), 4U);
  EXPECT_EQ(connections("arm[i]/joint[j].y", "arm[j]/joint[i].x"),
            (Texts{"arm[0]/joint[0].y arm[0]/joint[0].x", "arm[0]/joint[1].y arm[1]/joint[0].x",
                   "arm[1]/joint[0].y arm[0]/joint[1].x", "arm[1]/joint[1].y arm[1]/joint[1].x"}));
}

TEST(PortPattern, TakesElementsOfMessages) {
  EXPECT_EQ(connections("robot.q[*]", "arm[*].x"),
            (Texts{"robot.q#0 arm[0].x", "robot.q#1 arm[1].x"}));
  EXPECT_EQ(connections("arm[i].y", "robot.u[i + 3]"),
            (Texts{"arm[0].y robot.u#3", "arm[1].y robot.u#4"}));
}

TEST(PortPattern, RefusesWhatDoesNotFit) {
  EXPECT_TRUE(connections("leg[*].y", "arm[*].x", 1).empty());
  EXPECT_TRUE(connections("leg[*].y", "a.x", 1).empty());
  EXPECT_TRUE(connections("robot.q[*]", "robot.u[*]", 1).empty());
  EXPECT_TRUE(connections("b[*].y", "a.x", 1).empty());
  EXPECT_TRUE(connections("leg[3].y", "a.x", 1).empty());
  EXPECT_TRUE(connections("leg[i + 7].y", "leg[i].x", 1).empty());
}

TEST(PortPattern, RefusesWhatIsNoIndex) {
  for (const char* text : {"a[", "a[].x", "a[x", "a[1 2].x", "a[i*2].x", "a[i + -1].x",
                           "a[i+99999999].x", "a[new].x"}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(parse_pattern({text, {}}, diagnostics)) << text;
    EXPECT_EQ(diagnostics.error_count(), 1U) << text;
  }
}

}  // namespace
}  // namespace eagerx::gen

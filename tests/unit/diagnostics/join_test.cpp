#include "generator/support/diagnostics/join.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace eagerx::gen {
namespace {

TEST(Join, PutsTheSeparatorBetweenItemsOnly) {
  EXPECT_EQ(join(std::vector<std::string>{"a", "b", "c"}, " or "), "a or b or c");
  EXPECT_EQ(join(std::vector<std::string>{"a"}, ", "), "a");
  EXPECT_EQ(join(std::vector<std::string>{}, ", "), "");
  EXPECT_EQ(join(std::vector<std::string>{"", ""}, ","), ",");
}

TEST(Join, TakesItemsOfEveryKindThatStagesHave) {
  EXPECT_EQ(join(std::vector<std::string_view>{"E0101", "E0307"}, ", "), "E0101, E0307");
  EXPECT_EQ(join(std::vector<const char*>{"x", "y"}, "`, `"), "x`, `y");
  EXPECT_EQ(join(std::set<std::string>{"b", "a"}, ", "), "a, b");
  EXPECT_EQ(join(std::vector<std::size_t>{4, 3}, "x"), "4x3");
  EXPECT_EQ(join(std::vector<std::int64_t>{-1, 0}, ", "), "-1, 0");
  EXPECT_EQ(join(std::vector<std::uint32_t>{4294967295U}, "u, "), "4294967295");
}

}  // namespace
}  // namespace eagerx::gen

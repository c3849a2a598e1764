#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "generator/diagnostics/diagnostics.hpp"

namespace eagerx::gen {
namespace {

TEST(Nearest, FindsTypingErrors) {
  const std::vector<std::string> names = {"theta", "theta_dot", "voltage", "ButterworthFilter"};
  EXPECT_EQ(nearest("tehta", names), "theta");          // neighbours swapped
  EXPECT_EQ(nearest("thta", names), "theta");           // left out
  EXPECT_EQ(nearest("voltagee", names), "voltage");     // added
  EXPECT_EQ(nearest("theta-dot", names), "theta_dot");  // replaced
  EXPECT_EQ(nearest("butterworthfilter", names), "ButterworthFilter");
  EXPECT_EQ(nearest("theta", names), "theta");
}

TEST(Nearest, AtMostAThirdOfTheLetters) {
  EXPECT_EQ(nearest("abcxyz", {"abcdef"}), "");
  EXPECT_EQ(nearest("abcdxy", {"abcdef"}), "abcdef");
  EXPECT_EQ(nearest("u", {"v", "w"}), "");
  EXPECT_EQ(nearest("in", {"inn"}), "inn");
  EXPECT_EQ(nearest("motor", {"pendulum"}), "");
}

TEST(Nearest, TheBestOneAndThenTheFirst) {
  EXPECT_EQ(nearest("gain_p", {"gain_x", "gain_q", "gain_pp"}), "gain_x");
  EXPECT_EQ(nearest("gain_pq", {"gain_x", "gain_p"}), "gain_p");
  EXPECT_EQ(nearest("Theta", {"thetA", "theta"}), "theta");  // fewer letters of other case
}

TEST(Nearest, OddInput) {
  EXPECT_EQ(nearest("", {"a", ""}), "");
  EXPECT_EQ(nearest("a", {}), "");
  EXPECT_EQ(nearest("äöü", {"äöu"}), "äöu");  // letters, not bytes
  EXPECT_EQ(nearest(std::string(1000000, 'a'), {std::string(1000000, 'a')}), "");
  EXPECT_EQ(nearest("\xff\xfe\xfd", {"x"}), "");
}

}  // namespace
}  // namespace eagerx::gen

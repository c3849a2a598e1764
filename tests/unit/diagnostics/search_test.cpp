#include "generator/support/diagnostics/search.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace eagerx::gen {
namespace {

struct Port {
  std::string name;
  int size = 0;

  [[nodiscard]] bool is_large() const { return size > 1; }
};

const std::vector<Port> kPorts = {{"angle", 1}, {"speed", 2}, {"speed", 3}};

TEST(Search, FindsTheFirstAndItsPlaceByAProjection) {
  EXPECT_EQ(ranges::find(kPorts, "speed", &Port::name)->size, 2);
  EXPECT_EQ(ranges::find(kPorts, "torque", &Port::name), kPorts.end());
  EXPECT_EQ(ranges::find_if(kPorts, &Port::is_large)->size, 2);
  std::array numbers{3, 1, 2};
  *ranges::find(numbers, 1) = 7;
  EXPECT_EQ(numbers, (std::array{3, 7, 2}));
}

TEST(Search, ContainsWhatIsThereAlone) {
  EXPECT_TRUE(ranges::contains(kPorts, "angle", &Port::name));
  EXPECT_FALSE(ranges::contains(kPorts, "angl", &Port::name));
  EXPECT_FALSE(ranges::contains(std::vector<int>{}, 0));
}

TEST(Search, AnyAllAndNoneOfNothingAreThoseOfLogic) {
  const std::vector<int> nothing;
  const auto is_one = [](int number) { return number == 1; };
  EXPECT_FALSE(ranges::any_of(nothing, is_one));
  EXPECT_TRUE(ranges::all_of(nothing, is_one));
  EXPECT_TRUE(ranges::none_of(nothing, is_one));
}

TEST(Search, AnyAllAndNoneLookAtEachOne) {
  const auto is_named = [](const std::string& name) { return !name.empty(); };
  EXPECT_TRUE(ranges::any_of(kPorts, &Port::is_large));
  EXPECT_FALSE(ranges::all_of(kPorts, &Port::is_large));
  EXPECT_FALSE(ranges::none_of(kPorts, &Port::is_large));
  EXPECT_TRUE(ranges::all_of(kPorts, is_named, &Port::name));
  EXPECT_TRUE(ranges::none_of(std::string("abc"), [](char c) { return c == 'd'; }));
}

}  // namespace
}  // namespace eagerx::gen

#include "runtime/host/base/nearest.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace eagerx::host {
namespace {

TEST(Nearest, FindsTypingErrors) {
  const std::vector<std::string> names = {"theta", "theta_dot", "voltage", "ButterworthFilter"};
  EXPECT_EQ(nearest_name("tehta", names), "theta");          // neighbours swapped
  EXPECT_EQ(nearest_name("thta", names), "theta");           // left out
  EXPECT_EQ(nearest_name("voltagee", names), "voltage");     // added
  EXPECT_EQ(nearest_name("theta-dot", names), "theta_dot");  // replaced
  EXPECT_EQ(nearest_name("butterworthfilter", names), "ButterworthFilter");
  EXPECT_EQ(nearest_name("theta", names), "theta");
}

TEST(Nearest, AtMostAThirdOfTheLetters) {
  EXPECT_EQ(nearest_name("abcxyz", {"abcdef"}), "");
  EXPECT_EQ(nearest_name("abcdxy", {"abcdef"}), "abcdef");
  EXPECT_EQ(nearest_name("u", {"v", "w"}), "");
  EXPECT_EQ(nearest_name("in", {"inn"}), "inn");
  EXPECT_EQ(nearest_name("motor", {"pendulum"}), "");
}

TEST(Nearest, TheBestOneAndThenTheFirst) {
  EXPECT_EQ(nearest_name("gain_p", {"gain_x", "gain_q", "gain_pp"}), "gain_x");
  EXPECT_EQ(nearest_name("gain_pq", {"gain_x", "gain_p"}), "gain_p");
  EXPECT_EQ(nearest_name("Theta", {"thetA", "theta"}), "theta");  // fewer letters of other case
}

TEST(Nearest, OddInput) {
  EXPECT_EQ(nearest_name("", {"a", ""}), "");
  EXPECT_EQ(nearest_name("a", {}), "");
  EXPECT_EQ(nearest_name("äöü", {"äöu"}), "äöu");  // letters, not bytes
  EXPECT_EQ(nearest_name(std::string(1000000, 'a'), {std::string(1000000, 'a')}), "");
  EXPECT_EQ(nearest_name("\xff\xfe\xfd", {"x"}), "");
}

TEST(Nearest, SpelledWithOtherSeparators) {
  const std::vector<std::string> names = {"cart.mass", "robot/body.mass", "robot/a.b", "robot.a/b"};
  ASSERT_NE(spelled_otherwise("robot/body/mass", names), nullptr);
  EXPECT_EQ(*spelled_otherwise("robot/body/mass", names), "robot/body.mass");
  EXPECT_EQ(*spelled_otherwise("robot.body.mass", names), "robot/body.mass");
  EXPECT_EQ(*spelled_otherwise("cart/mass", names), "cart.mass");
  EXPECT_EQ(spelled_otherwise("robot/a/b", names), nullptr);  // two of them
  EXPECT_EQ(spelled_otherwise("mass", names), nullptr);
  EXPECT_EQ(spelled_otherwise("", names), nullptr);
}

TEST(Nearest, MeantByParts) {
  const std::vector<std::string> names = {"robot/gyro/y", "robot/accel/y", "robot/body/gyro/y",
                                          "pendulum/theta/observation", "theta"};
  const auto meant = [&](std::string_view name) {
    const std::string* const found = name_meant(name, names);
    return found == nullptr ? std::string() : *found;
  };
  EXPECT_EQ(meant("theta"), "theta");  // an exact match wins over a partial one
  EXPECT_EQ(meant("robot.gyro.y"), "robot/gyro/y");
  EXPECT_EQ(meant("robot.gyro"), "robot/gyro/y");
  EXPECT_EQ(meant("pendulum.theta"), "pendulum/theta/observation");
  EXPECT_EQ(meant("gyro.y"), "");  // two of them
  EXPECT_EQ(with_parts_of("gyro.y", names).size(), 2U);
  EXPECT_EQ(meant("robot/acc"), "");  // no whole part
  EXPECT_EQ(meant(""), "");
}

TEST(Nearest, WhatHasSeveralNames) {
  const std::vector<Named> known = {{"robot/gyro/y", "robot/gyro/y"},
                                    {"robot.turn", "robot/gyro/y"},
                                    {"robot/gyro", "robot/gyro/y", false},
                                    {"robot/body/accel/y", "robot/body/accel/y"}};
  const auto meant = [&](std::string_view name) {
    const std::string* const found = name_meant(name, known);
    return found == nullptr ? std::string() : *found;
  };
  EXPECT_EQ(meant("robot.turn"), "robot/gyro/y");
  EXPECT_EQ(meant("robot/turn"), "robot/gyro/y");
  EXPECT_EQ(meant("turn"), "robot/gyro/y");
  EXPECT_EQ(meant("gyro"), "robot/gyro/y");
  EXPECT_EQ(meant("robot"), "");  // two of them
  EXPECT_EQ(meant(""), "");
  EXPECT_EQ(suggestion("robot", known), "it may be robot/gyro/y, robot/body/accel/y");
  EXPECT_EQ(suggestion("robot.trn", known), "did you mean `robot/gyro/y`?");
  EXPECT_EQ(suggestion("robot/gyr0", known), "did you mean `robot/gyro/y`?");
  EXPECT_EQ(suggestion("x", known), "available: robot/gyro/y, robot/body/accel/y");
}

TEST(Nearest, AsASentenceForPeople) {
  const std::vector<std::string> names = {"theta", "voltage"};
  EXPECT_EQ(did_you_mean("thta", names), "did you mean `theta`?");
  EXPECT_EQ(did_you_mean("mass", names), "");
  EXPECT_EQ(suggestion("thta", names), "did you mean `theta`?");
  EXPECT_EQ(suggestion("mass", names), "available: theta, voltage");
  EXPECT_EQ(suggestion("mass", std::vector<std::string>{}), "");
}

}  // namespace
}  // namespace eagerx::host

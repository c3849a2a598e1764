// Which observation of the graph is which of the training.

#include <gtest/gtest.h>

#include "generator/policy/agent/order.hpp"

namespace eagerx::gen {
namespace {

using Names = std::vector<std::string>;

std::optional<TrainingOrder> order(const std::vector<NamedPart>& theirs,
                                   const std::vector<NamedPart>& ours) {
  return order_of_training(theirs, ours);
}

TEST(Agent, NamesTellTheOrderOfTheTraining) {
  const auto found = order({{"b", 2}, {"a", 2}, {"c", 1}}, {{"a", 2}, {"b", 2}, {"c", 1}});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->names, (Names{"b", "a", "c"}));
  EXPECT_TRUE(found->renamed.empty());
}

TEST(Agent, AnotherNameIsRecognizedByItsSize) {
  const auto found = order({{"angle", 2}, {"speed", 1}}, {{"speed", 1}, {"tilt", 2}});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->names, (Names{"tilt", "speed"}));
  EXPECT_EQ(found->renamed, (Names{"`tilt`, if it is the `angle` of the training"}));
}

TEST(Agent, WhatIsNotClearIsNotGuessed) {
  EXPECT_FALSE(order({{"x", 1}, {"y", 1}}, {{"p", 1}, {"q", 1}})) << "two of one size";
  EXPECT_FALSE(order({{"x", 3}}, {{"p", 1}})) << "none of its size";
  EXPECT_FALSE(order({{"a", 1}}, {{"a", 1}, {"more", 1}})) << "one that the training had not";
  EXPECT_FALSE(order({{"a", 1}, {"gone", 1}}, {{"a", 1}})) << "one that the graph has not";
  EXPECT_TRUE(order({}, {}));
}

}  // namespace
}  // namespace eagerx::gen

// eagerx/space.hpp: bounds of messages, clipping and sampling.
#include <gtest/gtest.h>

#include <cstdint>
#include <eagerx/space.hpp>
#include <limits>

namespace eagerx {
namespace {

using Message = Array<float, 3>;
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr Space<Message> kSpace = {{{-1, 0, -kInfinity}}, {{1, 0, 5}}};

TEST(Space, ContainsItsBoundsAndWhatIsBetween) {
  static_assert(kSpace.contains({{-1, 0, -3}}));
  static_assert(kSpace.contains({{1, 0, 5}}));
  EXPECT_TRUE(kSpace.contains({{0.5F, -0.0F, -kInfinity}}));
}

TEST(Space, DoesNotContainWhatIsOutsideInAnyElement) {
  EXPECT_FALSE(kSpace.contains({{1.0001F, 0, 0}}));
  EXPECT_FALSE(kSpace.contains({{0, std::numeric_limits<float>::denorm_min(), 0}}));
  EXPECT_FALSE(kSpace.contains({{0, 0, kInfinity}}));
}

TEST(Space, DoesNotContainNaN) {
  EXPECT_FALSE(kSpace.contains({{kNan, 0, 0}}));
  EXPECT_FALSE(kSpace.contains({{0, 0, kNan}}));
}

TEST(Space, ClipsEveryElementToItsOwnBounds) {
  EXPECT_EQ(kSpace.clipped({{-7, 3, 7}}), (Message{{-1, 0, 5}}));
  EXPECT_EQ(kSpace.clipped({{0.25F, 0, -100}}), (Message{{0.25F, 0, -100}}));
  EXPECT_EQ(kSpace.clipped({{kInfinity, -kInfinity, kInfinity}}), (Message{{1, 0, 5}}));
}

TEST(Space, ClipsNaNToTheLowerBound) {
  EXPECT_EQ(kSpace.clipped({{kNan, kNan, 2}}), (Message{{-1, 0, 2}}));
}

TEST(Space, ScalarsHaveSpacesToo) {
  constexpr Space<std::int64_t> kSteps = {-5, 7};
  static_assert(kSteps.contains(7) && !kSteps.contains(8));
  static_assert(kSteps.clipped(100) == 7 && kSteps.clipped(-100) == -5);
}

TEST(Space, SamplesWithinItsBounds) {
  constexpr Space<Message> kBox = {{{-1, 0, 10}}, {{1, 0, 10.5F}}};
  Random random({1, 2, 3}, 4);
  float lowest = 1;
  float highest = -1;
  for (int i = 0; i < 1000; ++i) {
    const Message message = kBox.sample(random);
    ASSERT_TRUE(kBox.contains(message));
    lowest = message[0] < lowest ? message[0] : lowest;
    highest = message[0] > highest ? message[0] : highest;
  }
  EXPECT_LT(lowest, -0.95F);
  EXPECT_GT(highest, 0.95F);
}

TEST(Space, SamplesIntegersAndBools) {
  constexpr Space<Array<std::uint8_t, 2>> kBytes = {{{0, 250}}, {{1, 255}}};
  constexpr Space<bool> kBool = {false, true};
  Random random({1, 2, 3}, 5);
  unsigned seen = 0;
  int heads = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto message = kBytes.sample(random);
    ASSERT_TRUE(kBytes.contains(message));
    seen |= 1U << (message[1] - 250);
    heads += kBool.sample(random) ? 1 : 0;
  }
  EXPECT_EQ(seen, 0x3fU) << "both ends are sampled, and all between";
  EXPECT_NEAR(heads, 500, 100);
}

TEST(Space, SamplesElementsInOrder) {
  constexpr Space<Array<double, 2>> kBox = {{{0, 0}}, {{1, 1}}};
  Random random({1, 2, 3}, 6);
  Random same = random;
  const auto message = kBox.sample(random);
  EXPECT_EQ(message[0], same.uniform(0.0, 1.0));
  EXPECT_EQ(message[1], same.uniform(0.0, 1.0));
}

}  // namespace
}  // namespace eagerx

// eagerx/lane_random.hpp: every lane draws what Random draws for its episode. extra.cmake compiles
// this for the instruction set of this machine, too.
#include <gtest/gtest.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <eagerx/lane_random.hpp>
#include <eagerx/random.hpp>
#include <eagerx/space.hpp>
#include <optional>
#include <vector>

namespace {

constexpr std::size_t kLanes = eagerx::kRegisterBytes / sizeof(float);
constexpr std::uint32_t kEntity = eagerx::entity_id("pendulum/model_state");

std::uint32_t bits(float x) {
  return std::bit_cast<std::uint32_t>(x);
}

/// Keys that differ in every part, in the upper halves of seeds, too.
std::vector<eagerx::EpisodeKey> keys_of(std::uint32_t round, std::size_t count) {
  std::vector<eagerx::EpisodeKey> keys;
  for (std::uint32_t k = 0; k < count; ++k)
    keys.push_back({0x9E3779B97F4A7C15U * (round + 1) + k, round + 5 * k, 0xFFFFFFF0U + k * round});
  return keys;
}

TEST(LaneRandom, DrawsWhatEachEpisodeDrawsAlone) {
  for (std::uint32_t round = 0; round < 500; ++round) {
    const auto keys = keys_of(round, kLanes);
    eagerx::LaneRandom<kLanes> together(keys.data(), keys.size(), kEntity);
    std::vector<eagerx::Random> alone;
    for (const auto& key : keys) alone.emplace_back(key, kEntity);
    for (int i = 0; i < 11; ++i) {  // more than two blocks of four words
      const float low = -0.05F * static_cast<float>(i), high = 0.7F;
      const auto drawn = together.uniform(low, high);
      for (std::size_t k = 0; k < kLanes; ++k)
        ASSERT_EQ(bits(lane(drawn, static_cast<int>(k))), bits(alone[k].uniform(low, high)))
            << "lane " << k << ", number " << i;
    }
  }
}

TEST(LaneRandom, FewerEpisodesThanLanesAndMessages) {
  using Message = eagerx::Array<float, 6>;
  constexpr eagerx::Space<Message> kSpace{.low = {{-1, -2, 0, 3, -0.5F, -9}},
                                          .high = {{1, 2, 0, 4, 1e30F, -8}}};
  for (std::size_t count = 1; count <= kLanes; ++count) {
    const auto keys = keys_of(7, count);
    eagerx::LaneRandom<kLanes> together(keys.data(), count, kEntity);
    std::vector<std::optional<Message>> drawn(count);
    eagerx::sample_lanes(
        together, kSpace, count, [&](std::size_t k) -> auto& { return drawn[k]; });
    for (std::size_t k = 0; k < count; ++k) {
      eagerx::Random alone(keys[k], kEntity);
      const Message message = kSpace.sample(alone);
      ASSERT_TRUE(drawn[k]);
      for (std::size_t i = 0; i < 6; ++i)
        EXPECT_EQ(bits((*drawn[k])[i]), bits(message[i])) << "lane " << k << ", number " << i;
    }
  }
}

TEST(LaneRandom, ANumberAlone) {
  constexpr eagerx::Space<float> kSpace{.low = 1.0F, .high = 2.0F};
  const auto keys = keys_of(3, kLanes);
  eagerx::LaneRandom<kLanes> together(keys.data(), kLanes, kEntity);
  std::optional<float> drawn[kLanes];
  eagerx::sample_lanes(
      together, kSpace, kLanes, [&](std::size_t k) -> auto& { return drawn[k]; });
  for (std::size_t k = 0; k < kLanes; ++k) {
    eagerx::Random alone(keys[k], kEntity);
    EXPECT_EQ(bits(drawn[k].value()), bits(kSpace.sample(alone)));
  }
}

}  // namespace

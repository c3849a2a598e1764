// eagerx/lane_random.hpp: every lane samples what Random samples for its episode. extra.cmake
// compiles this for the instruction set of this machine, too.
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

constexpr std::size_t kEpisodes = eagerx::kRegisterBytes / sizeof(float);
constexpr std::uint32_t kSampledEntity = eagerx::entity_id("pendulum/model_state");

std::uint32_t word_of(float x) {
  return std::bit_cast<std::uint32_t>(x);
}

/// Keys that differ in every part, in the upper halves of seeds, too.
std::vector<eagerx::EpisodeKey> odd_keys(std::uint32_t round, std::size_t count) {
  std::vector<eagerx::EpisodeKey> keys;
  for (std::uint32_t k = 0; k < count; ++k)
    keys.push_back({0x9E3779B97F4A7C15U * (round + 1) + k, round + 5 * k, 0xFFFFFFF0U + k * round});
  return keys;
}

TEST(LaneRandom, SamplesWhatEachEpisodeSamplesAlone) {
  for (std::uint32_t round = 0; round < 500; ++round) {
    const auto keys = odd_keys(round, kEpisodes);
    eagerx::LaneRandom<kEpisodes> together(keys.data(), keys.size(), kSampledEntity);
    std::vector<eagerx::Random> alone;
    for (const auto& key : keys) alone.emplace_back(key, kSampledEntity);
    for (int i = 0; i < 11; ++i) {  // more than two blocks of four words
      const float low = -0.05F * static_cast<float>(i), high = 0.7F;
      const auto sampled = together.uniform(low, high);
      for (std::size_t k = 0; k < kEpisodes; ++k)
        ASSERT_EQ(word_of(lane(sampled, static_cast<int>(k))), word_of(alone[k].uniform(low, high)))
            << "lane " << k << ", number " << i;
    }
  }
}

TEST(LaneRandom, FewerEpisodesThanLanesAndMessages) {
  using Message = eagerx::Array<float, 6>;
  constexpr eagerx::Space<Message> kSpace{.low = {{-1, -2, 0, 3, -0.5F, -9}},
                                          .high = {{1, 2, 0, 4, 1e30F, -8}}};
  for (std::size_t count = 1; count <= kEpisodes; ++count) {
    const auto keys = odd_keys(7, count);
    eagerx::LaneRandom<kEpisodes> together(keys.data(), count, kSampledEntity);
    std::vector<std::optional<Message>> sampled(count);
    eagerx::sample_lanes(
        together, kSpace, count, [&](std::size_t k) -> auto& { return sampled[k]; });
    for (std::size_t k = 0; k < count; ++k) {
      eagerx::Random alone(keys[k], kSampledEntity);
      const Message message = kSpace.sample(alone);
      ASSERT_TRUE(sampled[k]);
      for (std::size_t i = 0; i < 6; ++i)
        EXPECT_EQ(word_of((*sampled[k])[i]), word_of(message[i]))
            << "lane " << k << ", number " << i;
    }
  }
}

TEST(LaneRandom, ANumberAlone) {
  constexpr eagerx::Space<float> kSpace{.low = 1.0F, .high = 2.0F};
  const auto keys = odd_keys(3, kEpisodes);
  eagerx::LaneRandom<kEpisodes> together(keys.data(), kEpisodes, kSampledEntity);
  std::optional<float> sampled[kEpisodes];
  eagerx::sample_lanes(
      together, kSpace, kEpisodes, [&](std::size_t k) -> auto& { return sampled[k]; });
  for (std::size_t k = 0; k < kEpisodes; ++k) {
    eagerx::Random alone(keys[k], kSampledEntity);
    EXPECT_EQ(word_of(sampled[k].value()), word_of(kSpace.sample(alone)));
  }
}

}  // namespace

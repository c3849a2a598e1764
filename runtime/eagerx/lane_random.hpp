// Random numbers of several episodes at once, each the same as from Random.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/random.hpp>
#include <eagerx/simd.hpp>
#include <eagerx/space.hpp>
#include <type_traits>

namespace eagerx {

/// philox4x32() lane by lane. Words are the lower halves of 64-bit numbers. The upper halves are
/// undefined, because multiplications ignore them.
template <std::size_t N>
[[gnu::always_inline]] inline std::array<Simd<std::uint64_t, N>, 4> philox4x32(
    std::array<Simd<std::uint64_t, N>, 4> counter, std::array<Simd<std::uint64_t, N>, 2> key) {
  using Words = Simd<std::uint64_t, N>;
  constexpr int kRounds = 10;
  const Words multiplier0(0xD2511F53U), multiplier1(0xCD9E8D57U);
  const Words weyl0(0x9E3779B9U), weyl1(0xBB67AE85U);
#pragma GCC unroll 10
  for (int round = 0; round < kRounds; ++round) {
    const Words product0 = product_of_lower_halves(counter[0], multiplier0);
    const Words product1 = product_of_lower_halves(counter[2], multiplier1);
    counter = {(product1 >> 32) ^ counter[1] ^ key[0], product1,
               (product0 >> 32) ^ counter[3] ^ key[1], product0};
    key[0] += weyl0;
    key[1] += weyl1;
  }
  return counter;
}

/// The random numbers of one entity in `N` episodes, one per lane, the same as those of Random.
template <std::size_t N>
class LaneRandom {
 public:
  using Words = Simd<std::uint32_t, N>;

  /// `count` keys, at most N; the other lanes are undefined.
  LaneRandom(const EpisodeKey* keys, std::size_t count, std::uint32_t entity) : entity_(entity) {
    for (std::size_t k = 0; k < count; ++k) {
      const int lane = static_cast<int>(k);
      set_lane(seed_[0], lane, keys[k].seed);
      set_lane(seed_[1], lane, keys[k].seed >> 32U);
      set_lane(environment_, lane, keys[k].environment);
      set_lane(episode_, lane, keys[k].episode);
    }
  }

  /// The next 32 random bits of each.
  Words bits32() {
    if (left_ == 0) {
      const auto block = philox4x32<N>({environment_, episode_, entity_, Wide(counter_)}, seed_);
      for (std::size_t i = 0; i < kWords; ++i) block_[i] = Words(block[i]);
      ++counter_;
      left_ = kWords;
    }
    --left_;
    return block_[kWords - 1 - left_];
  }

  /// As Random::uniform().
  Simd<float, N> uniform(float low, float high) {
    using Real = Simd<float, N>;
    // 24 bits: whole numbers below 2^31, for which there are instructions.
    const Real u = Real(Simd<std::int32_t, N>(bits32() >> 8)) * Real(0x1p-24F);
    return clamp((Real(1) - u) * Real(low) + u * Real(high), Real(low), Real(high));
  }

 private:
  using Wide = Simd<std::uint64_t, N>;
  static constexpr std::size_t kWords = 4;

  std::array<Wide, 2> seed_{};
  Wide environment_{}, episode_{};
  Wide entity_;
  std::uint32_t counter_ = 0;  // blocks so far
  std::array<Words, kWords> block_{};
  std::uint32_t left_ = 0;  // words of the block not yet used
};

/// As Space::sample() for each lane: into to(lane), for `count` of them.
template <std::size_t N, class Message, class To>
requires std::is_same_v < ScalarOf<Message>,
float > void sample_lanes(LaneRandom<N>& random, const Space<Message>& space, std::size_t count,
                          To&& to) {
  constexpr std::size_t kSize = size_of<Message>;
  float numbers[kSize][N];
  for (std::size_t i = 0; i < kSize; ++i)
    random.uniform(element(space.low, i), element(space.high, i)).store(numbers[i]);
  for (std::size_t k = 0; k < count; ++k) {
    Message message;
    for (std::size_t i = 0; i < kSize; ++i) element(message, i) = numbers[i][k];
    to(k) = message;
  }
}

}  // namespace eagerx

// Random numbers that depend on names and counts only: Philox4x32-10 on (seed; environment,
// episode, entity, counter). Environment k does not depend on how many others run, and all targets
// sample the same bits.
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <eagerx/math.hpp>
#include <limits>
#include <numbers>
#include <type_traits>

namespace eagerx {

/// One block of Philox4x32-10: four random words from a counter and a key.
/// Salmon, Moraes, Dror, Shaw: Parallel random numbers: as easy as 1, 2, 3 (SC'11).
constexpr std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter,
                                                  std::array<std::uint32_t, 2> key) {
  constexpr int kRounds = 10;
  constexpr std::uint64_t kMultiplier0 = 0xD2511F53U;
  constexpr std::uint64_t kMultiplier1 = 0xCD9E8D57U;
  constexpr std::uint32_t kWeyl0 = 0x9E3779B9U;  // golden ratio
  constexpr std::uint32_t kWeyl1 = 0xBB67AE85U;  // sqrt(3) - 1
  for (int round = 0; round < kRounds; ++round) {
    const std::uint64_t product0 = kMultiplier0 * counter[0];
    const std::uint64_t product1 = kMultiplier1 * counter[2];
    counter = {static_cast<std::uint32_t>(product1 >> 32U) ^ counter[1] ^ key[0],
               static_cast<std::uint32_t>(product1),
               static_cast<std::uint32_t>(product0 >> 32U) ^ counter[3] ^ key[1],
               static_cast<std::uint32_t>(product0)};
    key[0] += kWeyl0;
    key[1] += kWeyl1;
  }
  return counter;
}

/// The key of an episode's random numbers.
struct EpisodeKey {
  std::uint64_t seed;
  std::uint32_t environment;
  std::uint32_t episode;
  friend constexpr bool operator==(const EpisodeKey&, const EpisodeKey&) = default;
};

/// A stable hash of a name such as "pendulum/model_state": FNV-1a, 32 bits.
constexpr std::uint32_t entity_id(const char* name) {
  constexpr std::uint32_t kOffset = 0x811C9DC5U;
  constexpr std::uint32_t kPrime = 0x01000193U;
  std::uint32_t hash = kOffset;
  for (; *name != '\0'; ++name) hash = (hash ^ static_cast<unsigned char>(*name)) * kPrime;
  return hash;
}

/// The random numbers of one entity in one episode. All-zero bytes when default-constructed (the
/// episode 0 of environment 0 under seed 0, entity 0). 2^34 words until it repeats.
class Random {
 public:
  constexpr Random() = default;
  /// `block`: the position in the stream at which to begin, in blocks of four words.
  constexpr Random(EpisodeKey key, std::uint32_t entity, std::uint32_t block = 0)
      : key_(key), entity_(entity), counter_(block) {}

  /// The random numbers of step `step`, which has `blocks` blocks of four words.
  static constexpr Random of_step(EpisodeKey key, std::uint32_t entity, std::uint64_t step,
                                  std::uint32_t blocks) {
    constexpr std::uint32_t kOdd = 0x9E3779B9U;
    const std::uint64_t first = step * blocks;
    // Another stream after 2^32 blocks.
    return {key, entity + static_cast<std::uint32_t>(first >> 32U) * kOdd,
            static_cast<std::uint32_t>(first)};
  }

  /// The next 32 random bits.
  constexpr std::uint32_t bits32() {
    if (left_ == 0) {
      block_ = philox4x32(
          {key_.environment, key_.episode, entity_, counter_},
          {static_cast<std::uint32_t>(key_.seed), static_cast<std::uint32_t>(key_.seed >> 32U)});
      ++counter_;
      left_ = kWords;
    }
    --left_;
    return block_[kWords - 1 - left_];
  }

  /// Uniform in 0 … n - 1 without bias; n = 0 means 2^32. Resamples with a probability below 1/2
  /// (Lemire 2019).
  constexpr std::uint32_t below(std::uint32_t n) {
    if (n == 0) return bits32();
    const std::uint32_t unfair = (0U - n) % n;  // 2^32 mod n
    std::uint64_t product = std::uint64_t{bits32()} * n;
    while (static_cast<std::uint32_t>(product) < unfair) product = std::uint64_t{bits32()} * n;
    return static_cast<std::uint32_t>(product >> 32U);
  }

  /// Uniform in [low, high], low <= high. Floating-point bounds must be finite; 24 (float) or 53
  /// (double) random bits. Integers and bool: every value equally likely, both ends included.
  template <class T>
  requires std::floating_point<T> || std::integral<T>
  constexpr T uniform(T low, std::type_identity_t<T> high) {
    if constexpr (std::floating_point<T>) {
      const T u = unit<T>();
      // Unlike low + u (high - low), this cannot overflow; clamped, because it may round past an
      // end.
      return clamp((T(1) - u) * low + u * high, low, high);
    } else {
      const auto span = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low);
      return static_cast<T>(static_cast<std::uint64_t>(low) + up_to(span));
    }
  }

  /// Normal with the given mean and standard deviation (Box and Muller 1958), at most 5.8 (float)
  /// or 8.6 (double) deviations from the mean. Discards the second value of the method, so that no
  /// state is kept.
  template <std::floating_point T>
  constexpr T normal(T mean, std::type_identity_t<T> standard_deviation) {
    const T radius = sqrt(T(-2) * log(open_unit<T>()));
    return mean + standard_deviation * (radius * cos(T(2) * std::numbers::pi_v<T> * unit<T>()));
  }

  /// Uniform in the logarithm, in [low, high]; 0 < low <= high, finite.
  template <std::floating_point T>
  constexpr T log_uniform(T low, std::type_identity_t<T> high) {
    return clamp(exp(uniform(log(low), log(high))), low, high);
  }

 private:
  static constexpr std::uint32_t kWords = 4;

  constexpr std::uint64_t bits64() {
    const std::uint64_t high = bits32();
    return (high << 32U) | bits32();
  }

  /// Uniform in 0 … last without bias.
  constexpr std::uint64_t up_to(std::uint64_t last) {
    if (last <= std::numeric_limits<std::uint32_t>::max()) {
      return below(static_cast<std::uint32_t>(last + 1));
    }
    const int unused_bits = std::countl_zero(last);
    std::uint64_t value = bits64() >> unused_bits;
    while (value > last) value = bits64() >> unused_bits;
    return value;
  }

  /// Multiples of 2^-24 or 2^-53 in [0, 1).
  template <class T>
  constexpr T unit() {
    if constexpr (sizeof(T) == 4) {
      return static_cast<T>(bits32() >> 8U) * T(0x1p-24);
    } else {
      return static_cast<T>(bits64() >> 11U) * T(0x1p-53);
    }
  }

  /// Odd multiples of 2^-24 or 2^-53: in (0, 1), exactly.
  template <class T>
  constexpr T open_unit() {
    if constexpr (sizeof(T) == 4) {
      return static_cast<T>((bits32() >> 8U) | 1U) * T(0x1p-24);
    } else {
      return static_cast<T>((bits64() >> 11U) | 1U) * T(0x1p-53);
    }
  }

  EpisodeKey key_{};
  std::uint32_t entity_ = 0;
  std::uint32_t counter_ = 0;  // blocks so far
  std::array<std::uint32_t, kWords> block_{};
  std::uint32_t left_ = 0;  // words of the block not yet used
};

}  // namespace eagerx

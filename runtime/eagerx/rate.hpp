// Exact rates and ticks. Run-time code counts integers; seconds appear only when a callback asks.
#pragma once

#include <cstdint>

namespace eagerx {

/// Number of a message in its channel, or of a tick in its node, since the last reset; from 0. At
/// 10 kHz, 64 bits last for 58 million years.
using Seq = std::uint64_t;

/// A rate of Num/Den Hz in lowest terms, known at compile time.
template <std::uint64_t Num, std::uint64_t Den = 1>
struct Rate {
  static_assert(Num > 0 && Den > 0, "a rate is a positive fraction");
  static constexpr std::uint64_t num = Num;
  static constexpr std::uint64_t den = Den;
  static constexpr double hz = static_cast<double>(Num) / static_cast<double>(Den);
  static constexpr double period_s = static_cast<double>(Den) / static_cast<double>(Num);

  /// Time of tick or message `n` in seconds since the reset: n / rate, rounded once if n * Den fits
  /// into the digits of Real, otherwise twice.
  template <class Real>
  static constexpr Real seconds(Seq n) {
    return static_cast<Real>(n * Den) / static_cast<Real>(Num);
  }
};

/// The tick a callback runs at: `n` = 0, 1, 2, … since the last reset. In a SIMD group it is a
/// LaneTick, in which each lane has its own tick: a callback that uses it there takes any type
/// (`AnyTick = Tick`).
struct Tick {
  Seq n;

  /// Whether this is the first tick since the reset.
  [[nodiscard]] constexpr bool is_first() const { return n == 0; }
  /// The tick of lane `lane`.
  [[nodiscard]] constexpr Seq in_lane(int /*lane*/) const { return n; }
};

}  // namespace eagerx

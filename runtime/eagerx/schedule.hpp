// The rates that are due at a slot.
#pragma once

#include <cstdint>
#include <iterator>
#include <type_traits>
#include <utility>

namespace eagerx {

/// A due mask known at compile time: one specialization of the schedule for each distinct mask.
template <auto Mask>
using Constant = std::integral_constant<decltype(Mask), Mask>;

/// For hyperperiods too long for a table: the time until the next tick of every rate.
/// `Periods::kQuanta`: the distinct periods in quanta, shortest first. A rate whose period is a
/// multiple of another's counts the ticks of that rate; the others count quanta.
template <class Mask, class Periods>
class Countdown {
 public:
  constexpr void reset() {
    for (auto& left : left_) left = 0;
  }
  /// The mask of the rates that are due next.
  constexpr Mask next() { return next(std::make_integer_sequence<std::uint32_t, kRates>{}); }

 private:
  static constexpr std::uint32_t kRates = std::size(Periods::kQuanta);

  /// The slowest rate whose ticks rate `i` can count; itself if there is none.
  static constexpr std::uint32_t counts_ticks_of(std::uint32_t i) {
    std::uint32_t result = i;
    for (std::uint32_t other = 0; other < i; ++other) {
      if (Periods::kQuanta[i] % Periods::kQuanta[other] == 0) result = other;
    }
    return result;
  }
  static constexpr std::uint64_t quanta_of(std::uint32_t i) {
    const std::uint32_t other = counts_ticks_of(i);
    return other == i ? Periods::kQuanta[i] : Periods::kQuanta[i] / Periods::kQuanta[other];
  }
  static constexpr bool fits_32_bits() {
    for (std::uint32_t i = 0; i < kRates; ++i) {
      if (quanta_of(i) > 0xffffffffU) return false;
    }
    return true;
  }
  using Count = std::conditional_t<fits_32_bits(), std::uint32_t, std::uint64_t>;

  template <std::uint32_t... I>
  constexpr Mask next(std::integer_sequence<std::uint32_t, I...> /*rates*/) {
    Count step = left_[0];  // the fastest rate counts quanta
    (nearest<I>(step), ...);
    Mask due = 0;
    (advance<I>(step, due), ...);
    return due;
  }
  template <std::uint32_t I>
  constexpr void nearest(Count& step) const {
    if constexpr (I > 0 && counts_ticks_of(I) == I) step = left_[I] < step ? left_[I] : step;
  }
  template <std::uint32_t I>
  constexpr void advance(Count step, Mask& due) {
    constexpr std::uint32_t kOther = counts_ticks_of(I);
    constexpr Count kCount = static_cast<Count>(quanta_of(I));
    Count left = left_[I];
    if constexpr (kOther == I) {
      left -= step;
    } else if ((due & (Mask{1} << kOther)) == 0) {
      return;
    }
    if (left == 0) {
      due = static_cast<Mask>(due | Mask{1} << I);
      left = kCount;
    }
    left_[I] = kOther == I ? left : left - 1;
  }

  Count left_[kRates]{};
};

}  // namespace eagerx

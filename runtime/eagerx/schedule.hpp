// Which rates are due at a slot.
#pragma once

#include <cstdint>
#include <type_traits>

namespace eagerx {

/// A due mask that the compiler knows: one specialisation of the schedule for each distinct one.
template <auto Mask>
using Constant = std::integral_constant<decltype(Mask), Mask>;

/// For hyperperiods too long for a table: how far away the next tick of every rate is, in quanta.
template <class Mask, std::uint32_t Rates>
class Countdown {
 public:
  constexpr void reset() {
    for (auto& left : left_) left = 0;
  }
  /// The rates that are due next, earliest first.
  constexpr Mask next(const std::uint64_t (&period)[Rates]) {
    std::uint64_t step = left_[0];
    for (std::uint32_t i = 1; i < Rates; ++i) step = left_[i] < step ? left_[i] : step;
    Mask due = 0;
    for (std::uint32_t i = 0; i < Rates; ++i) {
      left_[i] -= step;
      if (left_[i] != 0) continue;
      due |= static_cast<Mask>(Mask{1} << i);
      left_[i] = period[i];
    }
    return due;
  }

 private:
  std::uint64_t left_[Rates]{};
};

}  // namespace eagerx

// Loops with a limit, so that `eagerx-gen size --worst` can bound the instructions of an image.
#pragma once

#include <cstdint>

namespace eagerx {

/// In a loop's step or condition: since the loop was entered it was passed at most `Most` times.
/// No instruction: an address and a number in a section of the image that is not loaded.
/// For the runtime and boards, in loops that the compiler cannot unroll because they end when the
/// hardware says so: a copy of the note in a loop around it would be taken for that one's. Nothing
/// checks it. In all other loops take `bounded`.
template <std::uint32_t Most>
[[gnu::always_inline]] inline void note_turns() {
#if defined(__ARM_ARCH_PROFILE) && __ARM_ARCH_PROFILE == 'M'
  // A name with .debug_ is what linkers keep without loading it, with what it points to or not.
  asm inline volatile(
      "0:\n"
      "\t.pushsection .debug_eagerx_loops,\"\",%%progbits\n"
      "\t.4byte 0b\n"
      "\t.4byte %c0\n"
      "\t.popsection" ::"i"(Most));
#endif
}

/// In a loop that waits for a time or for a device: its iterations take no work, and only one is
/// counted.
[[gnu::always_inline]] inline void note_wait() {
  note_turns<0>();
}

/// The numbers 0, 1, … below `count`, and never more than `Most` of them: the comparison with
/// `Most` is what the bound is found by.
template <std::uint32_t Most>
class Bounded {
 public:
  static_assert(Most > 0, "a loop without a turn");

  class Iterator {
   public:
    constexpr explicit Iterator(std::uint32_t at) : at_(at) {}
    constexpr std::uint32_t operator*() const { return at_; }
    constexpr Iterator& operator++() {
      ++at_;
      return *this;
    }
    constexpr bool operator!=(const Iterator& end) const { return at_ != Most && at_ != end.at_; }

   private:
    std::uint32_t at_;
  };

  constexpr explicit Bounded(std::uint32_t count) : end_(count) {}
  [[nodiscard]] constexpr Iterator begin() const { return Iterator(0); }
  [[nodiscard]] constexpr Iterator end() const { return Iterator(end_); }

 private:
  std::uint32_t end_;
};

/// A loop that turns `count` times, but at most `Most` times, whatever `count` is:
///   for (const std::uint32_t i : eagerx::bounded<16>(in.joints)) …
/// Without a count, `Most` times; leave it earlier with `break`:
///   for ([[maybe_unused]] const std::uint32_t i : eagerx::bounded<20>()) { if (close(x)) break; …
///   }
template <std::uint32_t Most>
constexpr Bounded<Most> bounded(std::uint32_t count = Most) {
  return Bounded<Most>(count);
}

}  // namespace eagerx

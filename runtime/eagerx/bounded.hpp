// Loops with a limit, so that `eagerx-gen size --worst` can bound the instructions of an image.
#pragma once

#include <cstdint>

namespace eagerx {

/// Put it into a loop's step or condition: it executes at most `Most` times after the loop is
/// entered. It adds no instruction, only an address and a number in a section of the image that is
/// not loaded. Use it in the runtime and for boards, in loops that the compiler cannot unroll
/// because the hardware ends them: a copy of the note in an outer loop would count for that loop.
/// Nothing checks the bound. In all other loops, use `bounded`.
template <std::uint32_t Most>
[[gnu::always_inline]] inline void note_turns() {
#if defined(__ARM_ARCH_PROFILE) && __ARM_ARCH_PROFILE == 'M'
  // Linkers keep a section named .debug_… without loading it, whether or not they keep the code
  // that it refers to.
  asm inline volatile(
      "0:\n"
      "\t.pushsection .debug_eagerx_loops,\"\",%%progbits\n"
      "\t.4byte 0b\n"
      "\t.4byte %c0\n"
      "\t.popsection" ::"i"(Most));
#endif
}

/// Put it into a loop that waits for a time or a device: its iterations do no work, and only one is
/// counted.
[[gnu::always_inline]] inline void note_wait() {
  note_turns<0>();
}

/// The numbers 0, 1, … below `count`, but at most `Most` of them. The bound is found from the
/// comparison with `Most`.
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

/// A loop with `count` iterations, but at most `Most`, whatever `count` is:
///   for (const std::uint32_t i : eagerx::bounded<16>(in.joints)) …
/// Without a count, `Most` times; leave it earlier with `break`:
///   for ([[maybe_unused]] const std::uint32_t i : eagerx::bounded<20>()) { if (close(x)) break; …
///   }
template <std::uint32_t Most>
constexpr Bounded<Most> bounded(std::uint32_t count = Most) {
  return Bounded<Most>(count);
}

}  // namespace eagerx

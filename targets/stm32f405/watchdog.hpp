// The independent watchdog of the STM32F405. Source: ST RM0090, rev 19, chapter 21.
#pragma once

#include <cstdint>
#include <eagerx/peripheral.hpp>
#include <targets/common/bare-metal/memory.hpp>

namespace eagerx::board::stm32 {

/// Resets the chip if it is not fed. It has its own clock of 32 kHz with a large error (17 to 47
/// kHz, DS8626 table 42): a time-out of T may come after 0.68·T. It cannot be stopped.
template <class Memory = MappedMemory>
class IndependentWatchdog {
 public:
  static constexpr std::uint32_t kLongestMs = 32'768;

  /// Starts it and feeds it once. False if `ms` is 0 or longer than kLongestMs.
  static bool start(std::uint32_t ms) {
    if (ms == 0 || ms > kLongestMs) return false;
    std::uint32_t prescaler = 0;
    while (counts(ms, prescaler) > kMostCounts) ++prescaler;
    Memory::write(kKey, kStartKey);
    Memory::write(kKey, kUnlockKey);
    Memory::write(kPrescaler, prescaler);
    Memory::write(kReload, counts(ms, prescaler) - 1);
    // The new values cross into the slow clock, which takes some of its periods.
    for (std::uint32_t i = 0; i < kPatience && Memory::read(kStatus) != 0; ++i) {
    }
    feed();
    return true;
  }
  static void feed() { Memory::write(kKey, kFeedKey); }

 private:
  static constexpr std::uintptr_t kKey = 0x40003000;
  static constexpr std::uintptr_t kPrescaler = 0x40003004;
  static constexpr std::uintptr_t kReload = 0x40003008;
  static constexpr std::uintptr_t kStatus = 0x4000300C;
  static constexpr std::uint32_t kStartKey = 0xcccc;
  static constexpr std::uint32_t kUnlockKey = 0x5555;
  static constexpr std::uint32_t kFeedKey = 0xaaaa;
  static constexpr std::uint32_t kMostCounts = 4096;
  static constexpr std::uint32_t kPatience = 100'000;

  /// 32 kHz / 4·2^prescaler, rounded up.
  static constexpr std::uint32_t counts(std::uint32_t ms, std::uint32_t prescaler) {
    const std::uint32_t eighths = ms * 8;  // counts at the smallest prescaler
    return (eighths + (1U << prescaler) - 1) >> prescaler;
  }
};

static_assert(Watchdog<IndependentWatchdog<>>);

}  // namespace eagerx::board::stm32

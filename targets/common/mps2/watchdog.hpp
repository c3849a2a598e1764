// The watchdog of Arm's Cortex-M System Design Kit. Source: DDI 0479D, 4.4.
#pragma once

#include <cstdint>
#include <eagerx/peripheral.hpp>
#include <targets/common/bare-metal/memory.hpp>

namespace eagerx::board::mps2 {

/// Counts `ClockHz` down to the non-maskable interrupt, which ends the program with a message, and,
/// should that fail too, once more to the reset. Locked after every access.
template <std::uint32_t ClockHz, class Memory = MappedMemory>
class ApbWatchdog {
 public:
  static constexpr std::uint32_t kLongestMs =
      static_cast<std::uint32_t>(0xffffffffULL * 1'000 / ClockHz);

  static bool start(std::uint32_t ms) {
    if (ms == 0 || ms > kLongestMs) return false;
    Memory::write(kLock, kUnlock);
    Memory::write(kLoad, static_cast<std::uint32_t>(std::uint64_t{ms} * ClockHz / 1'000));
    Memory::write(kControl, kCountAndReset);
    Memory::write(kLock, 0);
    return true;
  }
  /// Takes the interrupt back, which also loads the counter again.
  static void feed() {
    Memory::write(kLock, kUnlock);
    Memory::write(kClear, 1);
    Memory::write(kLock, 0);
  }

 private:
  static constexpr std::uintptr_t kLoad = 0x40008000;
  static constexpr std::uintptr_t kControl = 0x40008008;
  static constexpr std::uintptr_t kClear = 0x4000800C;
  static constexpr std::uintptr_t kLock = 0x40008C00;
  static constexpr std::uint32_t kUnlock = 0x1ACCE551;
  static constexpr std::uint32_t kCountAndReset = 3;
};

static_assert(Watchdog<ApbWatchdog<25'000'000>>);

}  // namespace eagerx::board::mps2

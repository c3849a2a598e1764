// A timer of Arm's Cortex-M System Design Kit as a clock. Source: DDI 0479D, 4.1.
#pragma once

#include <cstdint>
#include <eagerx/peripheral.hpp>
#include <targets/common/bare-metal/memory.hpp>

namespace eagerx::board::mps2 {

inline constexpr std::uintptr_t kTimer0 = 0x40000000;
inline constexpr std::uintptr_t kTimer1 = 0x40001000;

/// Counts down 32 bits at the peripherals' clock; its reader extends them to 64 bits, which must
/// happen at least every 2^32 ticks (171 s at 25 MHz). All bytes are zero until start().
template <class Memory = MappedMemory>
class Timer {
 public:
  void start(std::uintptr_t base, std::uint32_t clock_hz) {
    base_ = base;
    hz_ = clock_hz;
    Memory::write(base + kControl, 0);
    Memory::write(base + kReload, kMost);
    Memory::write(base + kValue, kMost);
    Memory::write(base + kControl, 1);
  }
  std::uint64_t ticks() {
    const std::uint32_t now = kMost - Memory::read(base_ + kValue);
    ticks_ += static_cast<std::uint32_t>(now - static_cast<std::uint32_t>(ticks_));
    return ticks_;
  }
  std::uint64_t hz() const { return hz_; }
  void wait_for(std::uint64_t ticks) {
    while (this->ticks() < ticks) {
    }
  }

 private:
  static constexpr std::uintptr_t kControl = 0x00;
  static constexpr std::uintptr_t kValue = 0x04;
  static constexpr std::uintptr_t kReload = 0x08;
  static constexpr std::uint32_t kMost = 0xffffffff;

  std::uintptr_t base_ = 0;
  std::uint32_t hz_ = 0;
  std::uint64_t ticks_ = 0;
};

static_assert(HardwareTimer<Timer<>>);

}  // namespace eagerx::board::mps2

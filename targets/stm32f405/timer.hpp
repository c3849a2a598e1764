// TIM5 or TIM2 of the STM32F405 as a clock of 84 MHz. Source: ST RM0090, rev 19, chapter 18.
#pragma once

#include <cstdint>
#include <eagerx/peripheral.hpp>
#include <targets/stm32f405/timers.hpp>

namespace eagerx::board::stm32 {

/// A clock without interrupts. Each call that reads it extends its 32 bits to 64, so it must be
/// read at least every 51 s. All bytes are zero until start(). `port` is kTimer2 or kTimer5.
template <class Memory = MappedMemory>
class Timer {
 public:
  /// False for a timer of 16 bits.
  bool start(const TimerPort& port) {
    if (port.base != kTimer2.base && port.base != kTimer5.base) return false;
    port_ = &port;
    open<Memory>(port.gate);
    Memory::write(port.base + timer::kControl1, 0);
    Memory::write(port.base + timer::kPrescaler, 0);
    Memory::write(port.base + timer::kReload, 0xffffffff);
    Memory::write(port.base + timer::kEvent, timer::kUpdate);
    Memory::write(port.base + timer::kCount, 0);
    Memory::write(port.base + timer::kControl1, timer::kOn);
    return true;
  }
  std::uint64_t ticks() {
    const std::uint32_t now = Memory::read(port_->base + timer::kCount);
    ticks_ += static_cast<std::uint32_t>(now - static_cast<std::uint32_t>(ticks_));
    return ticks_;
  }
  std::uint64_t hz() const { return port_->hz; }
  void wait_for(std::uint64_t ticks) {
    while (this->ticks() < ticks) {
    }
  }

 private:
  const TimerPort* port_ = nullptr;
  std::uint64_t ticks_ = 0;
};

static_assert(HardwareTimer<Timer<>>);

}  // namespace eagerx::board::stm32

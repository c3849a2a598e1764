// PWM with a timer of the STM32F405. Source: ST RM0090, rev 19, 17.3.10, 17.4, 18.3.9.
#pragma once

#include <cstdint>
#include <eagerx/bus.hpp>
#include <eagerx/peripheral.hpp>
#include <targets/stm32f405/timers.hpp>

namespace eagerx::board::stm32 {

/// Up to four outputs of one frequency, edge-aligned. A new duty cycle begins with a new period.
/// All bytes are zero until start().
template <class Memory = MappedMemory>
class Pwm {
 public:
  /// All outputs low, at the nearest period that the timer can count (16 bits, after a prescaler).
  /// False for a frequency outside 1 Hz to timer_hz/2.
  bool start(const TimerPort& port, std::uint32_t hz) {
    if (hz == 0 || hz > port.hz / 2) return false;
    const std::uint32_t ticks = (port.hz + hz / 2) / hz;
    const std::uint32_t prescaler = ticks / kMostTicks;
    port_ = &port;
    period_ = ticks / (prescaler + 1);
    open<Memory>(port.gate);
    write(timer::kControl1, timer::kPreloadReload);
    write(timer::kPrescaler, prescaler);
    write(timer::kReload, period_ - 1);
    write(timer::kEvent, timer::kUpdate);
    if (port.advanced) write(timer::kBreak, kMainOutput);
    write(timer::kControl1, timer::kPreloadReload | timer::kOn);
    return true;
  }
  /// Gives channel 0 to 3 its pin. False without start().
  bool add(std::uint8_t channel) const {
    if (port_ == nullptr || channel >= kChannels) return false;
    write(timer::kCompare1 + std::uintptr_t{4} * channel, 0);
    constexpr std::uint32_t kPwm1WithPreload = 0x68;  // OCxM 110, OCxPE
    const std::uintptr_t mode = port_->base + timer::kChannelMode1 + (channel < 2 ? 0U : 4U);
    const unsigned shift = 8U * (channel % 2U);
    change_bits<Memory>(mode, 0xffU << shift, kPwm1WithPreload << shift);
    set_bits<Memory>(port_->base + timer::kChannelEnable, 1U << (4U * channel));
    Gpio<Memory>::make_alternate(port_->pins[channel], port_->function);
    return true;
  }
  /// The output of `channel` is high for this share of each period.
  BusError write_duty(std::uint8_t channel, float duty) const {
    if (port_ == nullptr || channel >= kChannels) return BusError::unsupported;
    write(timer::kCompare1 + std::uintptr_t{4} * channel, counts_of_duty(duty, period_));
    return BusError::none;
  }
  /// Ticks of a period.
  std::uint32_t period() const { return period_; }

 private:
  static constexpr std::uint8_t kChannels = 4;
  // A compare value of a whole period, always high, must fit into 16 bits too.
  static constexpr std::uint32_t kMostTicks = 65'535;
  static constexpr std::uint32_t kMainOutput = 1U << 15U;

  void write(std::uintptr_t offset, std::uint32_t value) const {
    Memory::write(port_->base + offset, value);
  }

  const TimerPort* port_ = nullptr;
  std::uint32_t period_ = 0;
};

/// Disconnects all timers from their pins: outputs of general timers are low, those of advanced
/// ones float (17.4.9, 17.4.18, 18.4.9). For faults of the program that sets duty cycles.
template <class Memory = MappedMemory>
void stop_all_pwm() {
  // Not the ports themselves: their pins would take flash in every image.
  for (const std::uintptr_t base : {kTimer1.base, kTimer8.base}) {
    Memory::write(base + timer::kBreak, 0);
    Memory::write(base + timer::kChannelEnable, 0);
  }
  for (const std::uintptr_t base : {kTimer2.base, kTimer3.base, kTimer4.base, kTimer5.base}) {
    Memory::write(base + timer::kChannelEnable, 0);
  }
}

}  // namespace eagerx::board::stm32

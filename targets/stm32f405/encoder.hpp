// A quadrature encoder on a timer of the STM32F405. Source: ST RM0090, rev 19, 18.3.12.
#pragma once

#include <cstdint>
#include <eagerx/bus.hpp>
#include <eagerx/peripheral.hpp>
#include <targets/stm32f405/timers.hpp>

namespace eagerx::board::stm32 {

/// Lines A and B on channels 1 and 2; every edge of both counts, so four counts a line of the disc.
/// It must be read at least once in 32767 counts. All bytes are zero until start().
template <class Memory = MappedMemory>
class Encoder {
 public:
  /// `filter` 0 to 15: how long a level must last to count (18.4.7, IC1F); 3 is 8 ticks of the
  /// timer's clock, 15 is 8·32.
  void start(const TimerPort& port, std::uint32_t filter = kFilter) {
    port_ = &port;
    open<Memory>(port.gate);
    Gpio<Memory>::make_alternate(port.pins[0], port.function, PinPull::up);
    Gpio<Memory>::make_alternate(port.pins[1], port.function, PinPull::up);
    constexpr std::uint32_t kOwnInput = 1;  // CCxS
    const std::uint32_t channel = kOwnInput | (filter & 0xfU) << 4U;
    Memory::write(port.base + timer::kControl1, 0);
    Memory::write(port.base + timer::kChannelMode1, channel | channel << 8U);
    Memory::write(port.base + timer::kChannelEnable, 0);  // not inverted
    Memory::write(port.base + timer::kSlaveMode, kBothEdges);
    Memory::write(port.base + timer::kPrescaler, 0);
    Memory::write(port.base + timer::kReload, 0xffff);
    Memory::write(port.base + timer::kCount, 0);
    Memory::write(port.base + timer::kControl1, timer::kOn);
  }
  BusError read(std::int32_t& counts) {
    if (port_ == nullptr) return BusError::unsupported;
    counts = count_.update(
        static_cast<std::uint16_t>(Memory::read(port_->base + timer::kCount) & 0xffffU));
    return BusError::none;
  }

 private:
  static constexpr std::uint32_t kBothEdges = 3;  // SMS: encoder mode 3
  static constexpr std::uint32_t kFilter = 3;

  const TimerPort* port_ = nullptr;
  WideCount count_;
};

}  // namespace eagerx::board::stm32

// Pins of the MPS2 boards: AHB GPIO of Arm's Cortex-M System Design Kit. Source: DDI 0479D, 3.2.
// QEMU 7.2 does not emulate it.
#pragma once

#include <cstdint>
#include <eagerx/bus.hpp>
#include <targets/common/bare-metal/memory.hpp>

namespace eagerx::board::mps2 {

/// Pin 0 to 63: 16 on each of the ports 0 to 3 (EXP[0] to EXP[51] are wired). An input until it is
/// written.
template <class Memory = MappedMemory>
class Gpio {
 public:
  static BusError write_pin(std::uint8_t pin, bool level) {
    if (pin >= kPins) return BusError::unsupported;
    const std::uint32_t bit = 1U << (pin % 16U);
    change_bits<Memory>(port(pin) + kOutput, bit, level ? bit : 0);
    Memory::write(port(pin) + kOutputSet, bit);
    return BusError::none;
  }
  static BusError read_pin(std::uint8_t pin, bool& level) {
    if (pin >= kPins) return BusError::unsupported;
    level = (Memory::read(port(pin)) >> (pin % 16U) & 1U) != 0;
    return BusError::none;
  }

 private:
  static constexpr std::uint8_t kPins = 64;
  static constexpr std::uintptr_t kOutput = 0x04;
  static constexpr std::uintptr_t kOutputSet = 0x10;

  static std::uintptr_t port(std::uint8_t pin) { return 0x40010000U + 0x1000U * (pin / 16U); }
};

}  // namespace eagerx::board::mps2

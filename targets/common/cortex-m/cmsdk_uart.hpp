// The APB UART of Arm's Cortex-M System Design Kit. Source: DDI 0479D, 4.3.
#pragma once

#include <cstdint>
#include <eagerx/bus.hpp>
#include <targets/common/bare-metal/memory.hpp>

namespace eagerx::board {

/// A UART at `Address`, clocked with `ClockHz`, without interrupts: the hardware keeps one
/// character that came in.
template <std::uintptr_t Address, std::uint32_t ClockHz, std::uint32_t Baud,
          class Memory = MappedMemory>
class CmsdkUart {
 public:
  static void start() {
    if (has_bits<Memory>(Address + kControl, kOn)) return;
    Memory::write(Address + kDivider, kDivision);
    Memory::write(Address + kControl, kOn);
  }
  /// Sends a byte if there is room for it.
  static bool put(std::uint8_t byte) {
    if (has_bits<Memory>(Address + kState, kTransmitFull)) return false;
    Memory::write(Address + kData, byte);
    return true;
  }
  /// False if nothing has come in. `error`: short_reply (a byte before this one was lost) or none.
  static bool take(std::uint8_t& byte, BusError& error) {
    const std::uint32_t state = Memory::read(Address + kState);
    if ((state & kReceived) == 0) return false;
    byte = static_cast<std::uint8_t>(Memory::read(Address + kData) & 0xffU);
    error = (state & kReceiveOverrun) != 0 ? BusError::short_reply : BusError::none;
    if (error != BusError::none) Memory::write(Address + kState, kReceiveOverrun);  // clears it
    return true;
  }

 private:
  static constexpr std::uintptr_t kData = 0x00;
  static constexpr std::uintptr_t kState = 0x04;
  static constexpr std::uintptr_t kControl = 0x08;
  static constexpr std::uintptr_t kDivider = 0x10;
  static constexpr std::uint32_t kOn = 1U << 0U | 1U << 1U;  // transmits and receives
  static constexpr std::uint32_t kTransmitFull = 1U << 0U;
  static constexpr std::uint32_t kReceived = 1U << 1U;
  static constexpr std::uint32_t kReceiveOverrun = 1U << 3U;
  static constexpr std::uint32_t kDivision = ClockHz / Baud;
  static_assert(kDivision >= 16, "the hardware ignores dividers below 16, and so does QEMU");
};

/// uart_write(), uart_offer() and uart_read() of a board whose port is `Port`.
template <class Port>
void write_to(char character) {
  Port::start();
  while (!Port::put(static_cast<std::uint8_t>(character))) {
  }
}
template <class Port>
bool offer_to(std::uint8_t byte) {
  Port::start();
  return Port::put(byte);
}
template <class Port>
bool read_from(char& character) {
  Port::start();
  std::uint8_t byte = 0;
  BusError error = BusError::none;
  if (!Port::take(byte, error)) return false;
  character = static_cast<char>(byte);
  return true;
}

}  // namespace eagerx::board

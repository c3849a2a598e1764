// The APB UART of Arm's Cortex-M System Design Kit, transmitting only. Source: DDI 0479D, 4.3.
#pragma once

#include <cstdint>

namespace eagerx::board {

/// A UART at `Address`, clocked with `ClockHz`.
template <std::uintptr_t Address, std::uint32_t ClockHz, std::uint32_t Baud>
class CmsdkUart {
 public:
  static void write(char character) {
    if ((reg(kControl) & kTransmit) == 0) {
      reg(kDivider) = kDivision;
      reg(kControl) = kTransmit;
    }
    while ((reg(kState) & kTransmitFull) != 0) {
    }
    reg(kData) = static_cast<unsigned char>(character);
  }

 private:
  static constexpr std::uintptr_t kData = 0x00;
  static constexpr std::uintptr_t kState = 0x04;
  static constexpr std::uintptr_t kControl = 0x08;
  static constexpr std::uintptr_t kDivider = 0x10;
  static constexpr std::uint32_t kTransmit = 1U << 0U;
  static constexpr std::uint32_t kTransmitFull = 1U << 0U;
  static constexpr std::uint32_t kDivision = ClockHz / Baud;
  static_assert(kDivision >= 16, "the hardware ignores dividers below 16, and so does QEMU");

  static volatile std::uint32_t& reg(std::uintptr_t offset) {
    return *reinterpret_cast<volatile std::uint32_t*>(Address + offset);
  }
};

}  // namespace eagerx::board

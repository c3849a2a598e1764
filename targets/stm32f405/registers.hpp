// The registers of the STM32F405 that this board uses. Source: ST RM0090, rev 19.
#pragma once

#include <cstdint>

namespace eagerx::board {

inline volatile std::uint32_t& stm32_register(std::uintptr_t address) {
  return *reinterpret_cast<volatile std::uint32_t*>(address);
}

namespace rcc {  // reset and clock control, 7.3
inline constexpr std::uintptr_t kControl = 0x40023800;
inline constexpr std::uintptr_t kPll = 0x40023804;
inline constexpr std::uintptr_t kConfiguration = 0x40023808;
inline constexpr std::uintptr_t kAhb1Enable = 0x40023830;
inline constexpr std::uintptr_t kApb2Enable = 0x40023844;
}  // namespace rcc

namespace flash {  // 3.9
inline constexpr std::uintptr_t kAccessControl = 0x40023C00;
}

namespace gpio_a {  // 8.4
inline constexpr std::uintptr_t kMode = 0x40020000;
inline constexpr std::uintptr_t kAlternateHigh = 0x40020024;
}  // namespace gpio_a

namespace usart1 {  // 30.6
inline constexpr std::uintptr_t kStatus = 0x40011000;
inline constexpr std::uintptr_t kData = 0x40011004;
inline constexpr std::uintptr_t kBaudRate = 0x40011008;
inline constexpr std::uintptr_t kControl1 = 0x4001100C;
}  // namespace usart1

}  // namespace eagerx::board

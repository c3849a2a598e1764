// Clock tree and flash of the STM32F405; the registers of each peripheral are in its own header.
// Source: ST RM0090, rev 19.
#pragma once

#include <cstdint>
#include <targets/common/bare-metal/memory.hpp>

namespace eagerx::board::stm32 {

namespace rcc {  // reset and clock control, 7.3
inline constexpr std::uintptr_t kControl = 0x40023800;
inline constexpr std::uintptr_t kPll = 0x40023804;
inline constexpr std::uintptr_t kConfiguration = 0x40023808;
inline constexpr std::uintptr_t kAhb1Enable = 0x40023830;
inline constexpr std::uintptr_t kApb1Enable = 0x40023840;
inline constexpr std::uintptr_t kApb2Enable = 0x40023844;
}  // namespace rcc

namespace flash {  // 3.9
inline constexpr std::uintptr_t kAccessControl = 0x40023C00;
}

/// Clocks as clock.cpp makes them. Timers run at twice the clock of their bus (7.2).
inline constexpr std::uint32_t kApb1Hz = 42'000'000;
inline constexpr std::uint32_t kApb2Hz = 84'000'000;
inline constexpr std::uint32_t kApb1TimerHz = 84'000'000;
inline constexpr std::uint32_t kApb2TimerHz = 168'000'000;

/// Where a peripheral gets its clock: a bit of a register of rcc.
struct Gate {
  std::uintptr_t enable;
  std::uint32_t bit;
};
/// Two reads separate this from the first access, as 7.2.14 requires.
template <class Memory>
void open(Gate gate) {
  set_bits<Memory>(gate.enable, 1U << gate.bit);
  static_cast<void>(Memory::read(gate.enable));
  static_cast<void>(Memory::read(gate.enable));
}

}  // namespace eagerx::board::stm32

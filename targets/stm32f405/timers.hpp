// Shared by PWM, encoders and clocks on the STM32F405: its general and advanced timers.
// Source: ST RM0090, rev 19, chapters 17 to 19; pins: DS8626, table 9.
#pragma once

#include <cstdint>
#include <targets/stm32f405/gpio.hpp>

namespace eagerx::board::stm32 {

/// One timer with four channels; `function` is the alternate function of its pins.
struct TimerPort {
  std::uintptr_t base;
  Gate gate;
  std::uint32_t hz;
  std::uint8_t function;
  bool advanced;  // its outputs have a main switch
  Pin pins[4];    // of its channels; each has others too, which nothing here uses
};

inline constexpr TimerPort kTimer1{
    0x40010000,   {rcc::kApb2Enable, 0},
    kApb2TimerHz, 1,
    true,         {pin_of("PA8"), pin_of("PA9"), pin_of("PA10"), pin_of("PA11")}};
inline constexpr TimerPort kTimer2{
    0x40000000,   {rcc::kApb1Enable, 0},
    kApb1TimerHz, 1,
    false,        {pin_of("PA0"), pin_of("PA1"), pin_of("PA2"), pin_of("PA3")}};
inline constexpr TimerPort kTimer3{
    0x40000400,   {rcc::kApb1Enable, 1},
    kApb1TimerHz, 2,
    false,        {pin_of("PA6"), pin_of("PA7"), pin_of("PB0"), pin_of("PB1")}};
inline constexpr TimerPort kTimer4{
    0x40000800,   {rcc::kApb1Enable, 2},
    kApb1TimerHz, 2,
    false,        {pin_of("PB6"), pin_of("PB7"), pin_of("PB8"), pin_of("PB9")}};
inline constexpr TimerPort kTimer5{
    0x40000C00,   {rcc::kApb1Enable, 3},
    kApb1TimerHz, 2,
    false,        {pin_of("PA0"), pin_of("PA1"), pin_of("PA2"), pin_of("PA3")}};
inline constexpr TimerPort kTimer8{
    0x40010400,   {rcc::kApb2Enable, 1},
    kApb2TimerHz, 3,
    true,         {pin_of("PC6"), pin_of("PC7"), pin_of("PC8"), pin_of("PC9")}};

/// Offsets of registers, 18.4.
namespace timer {
inline constexpr std::uintptr_t kControl1 = 0x00;
inline constexpr std::uintptr_t kSlaveMode = 0x08;
inline constexpr std::uintptr_t kEvent = 0x14;
inline constexpr std::uintptr_t kChannelMode1 = 0x18;
inline constexpr std::uintptr_t kChannelEnable = 0x20;
inline constexpr std::uintptr_t kCount = 0x24;
inline constexpr std::uintptr_t kPrescaler = 0x28;
inline constexpr std::uintptr_t kReload = 0x2c;
inline constexpr std::uintptr_t kCompare1 = 0x34;
inline constexpr std::uintptr_t kBreak = 0x44;

inline constexpr std::uint32_t kOn = 1U << 0U;
inline constexpr std::uint32_t kPreloadReload = 1U << 7U;
inline constexpr std::uint32_t kUpdate = 1U << 0U;  // of kEvent: takes prescaler and reload over
}  // namespace timer

/// TIM1 to TIM5 and TIM8 have four channels.
constexpr bool is_timer(int number) {
  return (number >= 1 && number <= 5) || number == 8;
}
/// The timer of that number; TIM1 for one that is_timer() does not know.
constexpr const TimerPort& timer_of(int number) {
  constexpr const TimerPort* kTimers[] = {&kTimer1, &kTimer1, &kTimer2, &kTimer3, &kTimer4,
                                          &kTimer5, &kTimer1, &kTimer1, &kTimer8};
  return *kTimers[is_timer(number) ? number : 0];
}

}  // namespace eagerx::board::stm32

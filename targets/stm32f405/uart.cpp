// USART1: PA9 transmits, 115200 baud. QEMU emulates the USART, but neither its clock nor the pins.
#include <targets/common/bare-metal/console.hpp>
#include <targets/stm32f405/registers.hpp>

namespace eagerx::board {
namespace {

constexpr std::uint32_t kOn = 1U << 13U | 1U << 3U;  // the USART, its transmitter

void start() {
  constexpr std::uint32_t kPortA = 1U << 0U;
  constexpr std::uint32_t kUsart1 = 1U << 4U;
  stm32_register(rcc::kAhb1Enable) = stm32_register(rcc::kAhb1Enable) | kPortA;
  stm32_register(rcc::kApb2Enable) = stm32_register(rcc::kApb2Enable) | kUsart1;

  constexpr std::uint32_t kPin9Mode = 3U << 18U;
  constexpr std::uint32_t kPin9Alternate = 2U << 18U;
  constexpr std::uint32_t kPin9Function = 0xfU << 4U;
  constexpr std::uint32_t kPin9Usart1 = 7U << 4U;
  stm32_register(gpio_a::kAlternateHigh) =
      (stm32_register(gpio_a::kAlternateHigh) & ~kPin9Function) | kPin9Usart1;
  stm32_register(gpio_a::kMode) = (stm32_register(gpio_a::kMode) & ~kPin9Mode) | kPin9Alternate;

  constexpr std::uint32_t kBusClockHz = EAGERX_CLOCK_HZ / 2;  // APB2, see clock.cpp
  constexpr std::uint32_t kBaud = 115'200;
  stm32_register(usart1::kBaudRate) = (kBusClockHz + kBaud / 2) / kBaud;
  stm32_register(usart1::kControl1) = kOn;
}

}  // namespace

void uart_write(char character) {
  if ((stm32_register(usart1::kControl1) & kOn) != kOn) start();
  constexpr std::uint32_t kTransmitEmpty = 1U << 7U;
  while ((stm32_register(usart1::kStatus) & kTransmitEmpty) == 0) {
  }
  stm32_register(usart1::kData) = static_cast<unsigned char>(character);
}

}  // namespace eagerx::board

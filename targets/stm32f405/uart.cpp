// The board's serial port is USART1: PA9 transmits, PA10 receives, at the `baud` of manifest.yaml.
// QEMU emulates the USART, but neither its clock nor the pins.
#include <targets/common/bare-metal/console.hpp>
#include <targets/stm32f405/uart.hpp>

namespace eagerx::board {
namespace {

constexpr stm32::Uart<> kPort(stm32::kUsart1);

void start() {
  if (!kPort.is_on()) kPort.start(stm32::pin_of("PA9"), stm32::pin_of("PA10"), EAGERX_BAUD);
}

}  // namespace

void uart_write(char character) {
  start();
  while (!kPort.put(static_cast<std::uint8_t>(character))) {
  }
}

bool uart_offer(std::uint8_t byte) {
  start();
  return kPort.put(byte);
}

bool uart_read(char& character) {
  start();
  std::uint8_t byte = 0;
  BusError error = BusError::none;
  if (!kPort.take(byte, error)) return false;
  character = static_cast<char>(byte);
  return true;
}

}  // namespace eagerx::board

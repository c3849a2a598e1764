// The 16550 of QEMU's board virt, which sends immediately, without a baud rate. Source: TI
// PC16550D, 8.
#include <cstdint>
#include <targets/common/bare-metal/console.hpp>

namespace eagerx::board {
namespace {

constexpr std::uintptr_t kData = 0x10000000;
constexpr std::uintptr_t kLineStatus = 0x10000005;

volatile std::uint8_t& reg(std::uintptr_t address) {
  return *reinterpret_cast<volatile std::uint8_t*>(address);
}

}  // namespace

bool uart_offer(std::uint8_t byte) {
  constexpr std::uint8_t kTransmitEmpty = 1U << 5U;
  if ((reg(kLineStatus) & kTransmitEmpty) == 0) return false;
  reg(kData) = byte;
  return true;
}

void uart_write(char character) {
  while (!uart_offer(static_cast<std::uint8_t>(character))) {
  }
}

bool uart_read(char& character) {
  constexpr std::uint8_t kReceived = 1U << 0U;
  if ((reg(kLineStatus) & kReceived) == 0) return false;
  character = static_cast<char>(reg(kData));
  return true;
}

}  // namespace eagerx::board

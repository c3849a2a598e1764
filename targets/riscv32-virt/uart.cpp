// The 16550 of QEMU's board virt; it sends at once, at no particular rate. Source: TI PC16550D, 8.
#include <cstdint>
#include <targets/common/bare-metal/console.hpp>

namespace eagerx::board {

void uart_write(char character) {
  constexpr std::uintptr_t kData = 0x10000000;
  constexpr std::uintptr_t kLineStatus = 0x10000005;
  constexpr std::uint8_t kTransmitEmpty = 1U << 5U;
  while ((*reinterpret_cast<volatile std::uint8_t*>(kLineStatus) & kTransmitEmpty) == 0) {
  }
  *reinterpret_cast<volatile std::uint8_t*>(kData) = static_cast<std::uint8_t>(character);
}

}  // namespace eagerx::board

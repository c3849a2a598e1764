// UART0 of the MPS2 boards, AN385, AN386 and AN500 (DAI 0385, 0386, 0500).
#include <targets/common/bare-metal/console.hpp>
#include <targets/common/cortex-m/cmsdk_uart.hpp>

namespace eagerx::board {
namespace {

using Port = CmsdkUart<0x40004000, EAGERX_CLOCK_HZ, EAGERX_BAUD>;

}  // namespace

void uart_write(char character) {
  write_to<Port>(character);
}
bool uart_offer(std::uint8_t byte) {
  return offer_to<Port>(byte);
}
bool uart_read(char& character) {
  return read_from<Port>(character);
}

}  // namespace eagerx::board

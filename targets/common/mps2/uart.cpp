// UART0 of the MPS2 boards, AN385, AN386 and AN500 (DAI 0385, 0386, 0500).
#include <targets/common/bare-metal/console.hpp>
#include <targets/common/cortex-m/cmsdk_uart.hpp>

namespace eagerx::board {

void uart_write(char character) {
  CmsdkUart<0x40004000, EAGERX_CLOCK_HZ, 115'200>::write(character);
}

}  // namespace eagerx::board

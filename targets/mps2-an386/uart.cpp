// UART0 of the MPS2 boards.
#include <targets/common/cortex-m/cmsdk_uart.hpp>
#include <targets/common/cortex-m/console.hpp>

namespace eagerx::board {

void uart_write(char character) {
  CmsdkUart<0x40004000, 25'000'000, 115'200>::write(character);
}

}  // namespace eagerx::board

// UART0 of the AN547 image, in secure memory (DAI 0547, table 3-2), on its 25 MHz peripheral clock.
#include <targets/common/bare-metal/console.hpp>
#include <targets/common/cortex-m/cmsdk_uart.hpp>

namespace eagerx::board {
namespace {

using Port = CmsdkUart<0x59303000, 25'000'000, EAGERX_BAUD>;

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

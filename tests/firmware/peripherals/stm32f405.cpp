// The peripherals of the STM32F405 that QEMU emulates, through this board's drivers.
#include <models/drivers/dynamixel/dynamixel.hpp>
#include <targets/common/bare-metal/board_time.hpp>
#include <targets/common/bare-metal/start.hpp>
#include <targets/common/bare-metal/uart_line.hpp>
#include <targets/stm32f405/adc.hpp>
#include <targets/stm32f405/pwm.hpp>
#include <targets/stm32f405/spi.hpp>
#include <targets/stm32f405/timer.hpp>
#include <targets/stm32f405/uart.hpp>

#include "peripherals/words.hpp"

namespace {

using namespace eagerx::board;
using eagerx::BusError;
using stm32::pin_of;

/// A servo on USART1: the same driver as on Linux.
int servo() {
  const stm32::Uart<> uart(stm32::kUsart1);
  if (!uart.start(pin_of("PA9"), pin_of("PA10"), 1'000'000)) return 1;
  UartLine<stm32::Uart<>, BoardTime> line(uart, 2'000'000'000);
  std::int32_t counts = 0;
  const BusError error = eagerx::drivers::DynamixelX(1).position(line, counts);
  say(error);
  say(" position", counts);
  return 0;
}

int timer() {
  stm32::Timer<> timer;
  if (timer.start(stm32::kTimer3) || !timer.start(stm32::kTimer2)) return 1;
  say("ticks in 10 ms:", ticks_in<stm32::Timer<>, BoardTime>(timer, 10'000'000));
  return 0;
}

/// Channel 3 of TIM3 drives its pin, until a fault switches it off.
int pwm() {
  constexpr std::uintptr_t kChannelEnable = stm32::kTimer3.base + stm32::timer::kChannelEnable;
  stm32::Pwm<> pwm;
  if (!pwm.start(stm32::kTimer3, 20'000) || !pwm.add(2)) return 1;
  say("enabled", static_cast<std::int32_t>(MappedMemory::read(kChannelEnable)));
  eagerx_outputs_off();
  say("after a fault", static_cast<std::int32_t>(MappedMemory::read(kChannelEnable)));
  return 0;
}

int adc() {
  stm32::Adc<> adc;
  adc.start(3.3F);
  std::uint16_t counts = 0;
  say(adc.sample(0, counts));
  say(" counts", counts);
  return 0;
}

int spi() {
  stm32::Spi<BoardTime> spi;
  if (!spi.start(stm32::kSpi1, {pin_of("PA5"), pin_of("PA6"), pin_of("PA7")}, 10'000'000)) return 1;
  spi.add_select(pin_of("PA4"));
  const std::uint8_t out[2] = {0xff, 0xff};
  std::uint8_t in[2] = {1, 1};
  say_bytes(spi.transfer({0, 1, 10'000'000}, pin_of("PA4"), out, in, 2), in, 2);
  return 0;
}

}  // namespace

int main() {
  const std::string_view word = last_word();
  start_clock();
  const int code = word == "servo"   ? servo()
                   : word == "timer" ? timer()
                   : word == "adc"   ? adc()
                   : word == "pwm"   ? pwm()
                   : word == "spi"   ? spi()
                                     : 1;
  console.flush();
  return code;
}

// The peripherals of the MPS2 boards that QEMU emulates, through these boards' drivers.
#include <models/links/immediate_link.hpp>
#include <targets/common/bare-metal/board_time.hpp>
#include <targets/common/bare-metal/start.hpp>
#include <targets/common/mps2/gpio.hpp>
#include <targets/common/mps2/i2c.hpp>
#include <targets/common/mps2/spi.hpp>
#include <targets/common/mps2/timer.hpp>
#include <targets/common/mps2/watchdog.hpp>

#include "peripherals/words.hpp"

namespace {

using namespace eagerx::board;
using eagerx::BusError;
constexpr std::uint32_t kClockHz = 25'000'000;

/// A TMP105: its register 3 takes 16 bits, of which the upper 12 count; no device is at 0x20.
int i2c() {
  mps2::I2c<BoardTime> bus;
  bus.start(mps2::kI2cShield1, 400'000);
  const std::uint8_t out[3] = {3, 0x12, 0x30};
  std::uint8_t in[2]{};
  say(bus.transfer({0x48, 400'000}, out, 3, nullptr, 0));
  console.text(" ");
  say_bytes(bus.transfer({0x48, 100'000}, out, 1, in, 2), in, 2);
  say(bus.transfer({0x20, 400'000}, out, 1, in, 2));
  console.text("\n");
  return 0;
}

/// The identity of a flash memory.
int spi() {
  mps2::Spi<BoardTime> spi;
  spi.start(mps2::kSpiShield1, kClockHz, 10'000'000);
  const std::uint8_t out[4] = {0x9f};
  std::uint8_t in[4]{};
  say_bytes(spi.transfer({0, 0, 1'000'000}, mps2::kSelectShield1, out, in, 4), in + 1, 3);
  return 0;
}

int timer() {
  mps2::Timer<> timer;
  timer.start(mps2::kTimer0, kClockHz);
  say("ticks in 10 ms:", ticks_in<mps2::Timer<>, BoardTime>(timer, 10'000'000));
  return 0;
}

/// Fed for 200 ms, then not: after 100 ms comes the interrupt that nothing masks.
int watchdog() {
  using Dog = mps2::ApbWatchdog<kClockHz>;
  if (!Dog::start(100)) return 1;
  const auto wait = [](std::int64_t ms) {
    BoardTime::sleep_until(BoardTime::now_ns() + ms * 1'000'000);
  };
  for (int i = 0; i < 10; ++i) {
    wait(20);
    Dog::feed();
  }
  console.text("fed\n");
  wait(90);
  console.text("hungry\n");
  wait(20);
  console.text("not interrupted\n");
  return 1;
}

}  // namespace

/// These boards have nothing to switch off: that a fault asks is what is tried.
void eagerx_outputs_off() {
  console.text("outputs off\n");
}

int main() {
  const std::string_view word = last_word();
  start_clock();
  const int code = word == "i2c"        ? i2c()
                   : word == "spi"      ? spi()
                   : word == "timer"    ? timer()
                   : word == "watchdog" ? watchdog()
                                        : 1;
  console.flush();
  return code;
}

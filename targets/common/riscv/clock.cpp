// The timer of the core-local interruptor (CLINT) as a clock. Source: SiFive E31 core complex
// manual 9.2; QEMU's board virt has it at 0x2000000, at 10 MHz.
#include <targets/common/bare-metal/clock.hpp>

namespace eagerx::board {
namespace {

std::uint32_t word(std::uintptr_t address) {
  return *reinterpret_cast<const volatile std::uint32_t*>(address);
}

std::uint64_t time_now() {
  constexpr std::uintptr_t kTime = 0x0200bff8;
  while (true) {
    const std::uint32_t high = word(kTime + 4);
    const std::uint32_t low = word(kTime);
    if (word(kTime + 4) == high) return std::uint64_t{high} << 32U | low;
  }
}

std::uint64_t started = 0;

}  // namespace

void start_clock() {
  if (started == 0) started = time_now();
}

std::uint64_t clock_ticks() {
  return time_now() - started;
}

void wait_for_clock(std::uint64_t ticks) {
  while (clock_ticks() < ticks) {
  }
}

std::uint64_t clock_hz() {
  return EAGERX_CLOCK_HZ;
}

}  // namespace eagerx::board

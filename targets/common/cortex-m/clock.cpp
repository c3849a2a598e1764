// SysTick as a clock: it counts the core's cycles down from 2^24 - 1, and its exception counts the
// rounds. Source: ARMv7-M Architecture Reference Manual (DDI 0403E) B3.3.
#include <eagerx/bounded.hpp>
#include <targets/common/bare-metal/clock.hpp>

extern "C" void SysTick_Handler();

namespace eagerx::board {
namespace {

constexpr std::uint32_t kRound = 1U << 24U;
volatile std::uint32_t rounds = 0;

volatile std::uint32_t& reg(std::uintptr_t address) {
  return *reinterpret_cast<volatile std::uint32_t*>(address);
}

}  // namespace

void start_clock() {
  constexpr std::uint32_t kOnWithExceptionFromCore = 7;
  if ((reg(0xE000E010) & 1U) != 0) return;
  reg(0xE000E014) = kRound - 1;  // reload
  reg(0xE000E018) = 0;           // value: any write makes it 0, and the next tick reloads it
  reg(0xE000E010) = kOnWithExceptionFromCore;
}

std::uint64_t clock_ticks() {
  constexpr std::uint32_t kPending = 1U << 26U;  // PENDSTSET of ICSR, B3.2.4
  while (true) {
    eagerx::note_turns<2>();  // again only where a round ends meanwhile, once in 2^24 cycles
    const std::uint32_t round = rounds;
    const std::uint32_t left = reg(0xE000E018);
    // Where exceptions wait (in another handler, with interrupts off), a round that is over is not
    // counted yet. A counter near 0 was read before it was over.
    const bool uncounted = left > kRound / 2 && (reg(0xE000ED04) & kPending) != 0;
    if (round != rounds) continue;
    return (std::uint64_t{round} + (uncounted ? 1 : 0)) * kRound + (kRound - 1 - left);
  }
}

void wait_for_clock(std::uint64_t ticks) {
  constexpr std::uint64_t kNear = kRound / 2;
  while (clock_ticks() + kNear < ticks) {
    eagerx::note_wait();
  }
  // The counter's value at `ticks`: near the end nothing else is read, five instructions a turn.
  const std::uint32_t end = kRound - 1 - static_cast<std::uint32_t>(ticks % kRound);
  if (clock_ticks() >= ticks) return;
  while ((reg(0xE000E018) - end - 1) % kRound < kNear) {
    eagerx::note_wait();
  }
}

std::uint64_t clock_hz() {
  return EAGERX_CLOCK_HZ;
}

}  // namespace eagerx::board

void SysTick_Handler() {
  eagerx::board::rounds = eagerx::board::rounds + 1;
}

// Counts instructions on an emulated board: with `-icount shift=0` an instruction takes a
// nanosecond, and SysTick counts in steps of 40 of them.
#pragma once

#include <cstdint>
#include <targets/common/bare-metal/semihosting.hpp>
#include <type_traits>

namespace bench {

using eagerx::board::semihosting_write;

inline constexpr std::uint32_t kInstructionsATick = 40;  // 25 MHz

inline volatile std::uint32_t& system_tick(std::uintptr_t offset) {
  return *reinterpret_cast<volatile std::uint32_t*>(0xE000E010U + offset);
}

inline void print(std::uint32_t number) {
  char text[12];
  char* at = text + sizeof text;
  *--at = '\0';
  do {
    *--at = static_cast<char>('0' + number % 10);
    number /= 10;
  } while (number != 0);
  semihosting_write(at);
}

/// Instructions of one of `times` runs, in hundredths. `run` gets the number of the run if
/// it takes one.
template <class Run>
[[gnu::noinline]] std::uint32_t hundredths(std::uint32_t times, Run&& run) {
  constexpr std::uint32_t kMost = 0xffffff;
  system_tick(4) = kMost;
  system_tick(8) = 0;
  system_tick(0) = 5;  // processor clock, no interrupt
  const std::uint32_t start = system_tick(8);
  for (std::uint32_t i = 0; i < times; ++i) {
    if constexpr (std::is_invocable_v<Run, std::uint32_t>) {
      run(i);
    } else {
      run();
    }
  }
  const std::uint32_t end = system_tick(8);
  return static_cast<std::uint32_t>(std::uint64_t{(start - end) & kMost} * kInstructionsATick *
                                    100 / times);
}

/// Instructions of a run.
template <class Run>
std::uint32_t instructions(Run&& run) {
  constexpr std::uint32_t kTimes = 200;
  return hundredths(
             kTimes, [&](std::uint32_t) __attribute__((always_inline)) { run(); }) /
         100;
}

}  // namespace bench

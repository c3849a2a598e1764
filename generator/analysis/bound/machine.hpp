// The board of an image, as far as time depends on it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace eagerx::gen {

struct Machine {
  struct Interrupt {
    std::string handler;  // the function's name: `SysTick_Handler`
    double most_hz = 0;
  };
  std::string board;  // "stm32f405"
  std::string cpu;    // "Cortex-M4F"
  std::uint64_t clock_hz = 0;
  std::optional<unsigned> wait_states;  // of the memory for code; nullopt: not stated
  std::vector<Interrupt> interrupts;
};

}  // namespace eagerx::gen

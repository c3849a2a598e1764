// Start-up code of all cores, which needs a stack.
#pragma once

#include <cstddef>
#include <cstdint>
#include <targets/common/bare-metal/stack.hpp>

extern "C" {

// From the linker script: the initial values in flash and their addresses in RAM, the memory that
// starts as zero, and the functions that run before main.
extern const std::uint32_t eagerx_data_load[];
extern std::uint32_t eagerx_data_begin[];
extern std::uint32_t eagerx_data_end[];
extern std::uint32_t eagerx_bss_begin[];
extern std::uint32_t eagerx_bss_end[];
extern void (*const eagerx_constructors_begin[])();
extern void (*const eagerx_constructors_end[])();

/// Clocks and pins, before the constructors. A board that needs it defines it.
[[gnu::weak]] void eagerx_board_start();

/// A fault calls this first, in any state of the program. It switches off outputs that would
/// continue to drive actuators without the program. A board with such outputs defines it. It must
/// use little of the stack and must not wait.
[[gnu::weak]] void eagerx_outputs_off();
}

namespace eagerx::board {

/// Below the frame of the function that this is inlined into. It keeps a distance, for that frame
/// may grow.
[[gnu::always_inline]] inline void paint_stack() {
  constexpr std::size_t kDistanceWords = 32;
  const auto* const end =
      static_cast<const std::uint32_t*>(__builtin_frame_address(0)) - kDistanceWords;
  for (std::uint32_t* word = eagerx_stack_bottom; word < end; ++word) {
    *static_cast<volatile std::uint32_t*>(word) = kStackPaint;
  }
}

/// Loops that the compiler must not turn into calls of memcpy and memset.
inline void initialise_memory() {
  const volatile std::uint32_t* from = eagerx_data_load;
  for (volatile std::uint32_t* to = eagerx_data_begin; to < eagerx_data_end; ++to) *to = *from++;
  for (volatile std::uint32_t* to = eagerx_bss_begin; to < eagerx_bss_end; ++to) *to = 0;
}

inline void run_constructors() {
  if (eagerx_board_start != nullptr) eagerx_board_start();
  for (auto* constructor = eagerx_constructors_begin; constructor < eagerx_constructors_end;
       ++constructor) {
    (*constructor)();
  }
}

}  // namespace eagerx::board

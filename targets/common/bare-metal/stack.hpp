// Maximum stack depth: the stack is painted before main and inspected afterwards.
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" {
// Ends of the stack, from the linker script. It grows down from the top.
extern std::uint32_t eagerx_stack_bottom[];
extern std::uint32_t eagerx_stack_top[];
}

namespace eagerx::board {

inline constexpr std::uint32_t kStackPaint = 0xc5c5c5c5U;

/// Bytes of stack used so far; a lower bound if the deepest words happened to hold the paint.
inline std::size_t stack_used_bytes() {
  const std::uint32_t* word = eagerx_stack_bottom;
  while (word < eagerx_stack_top && *word == kStackPaint) ++word;
  return static_cast<std::size_t>(eagerx_stack_top - word) * sizeof(std::uint32_t);
}

}  // namespace eagerx::board

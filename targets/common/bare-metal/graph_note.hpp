// Note in an image about its graph and its board, for programs that start or measure it.
#pragma once

#include <cstdint>

namespace eagerx::board {

/// `eagerx graph ` and the graph's hash, the lowest byte first, and `eagerx board NAME`, in a
/// section that is in the file and not on the board. It is never called: naming it is enough.
template <class Graph>
[[gnu::used]] void note_graph() {
  constexpr unsigned kWordBits = 32;
// How a number is written without the mark of a constant. RISC-V has none.
#ifdef __riscv
#define EAGERX_NUMBERS "%0, %1"
#else
#define EAGERX_NUMBERS "%c0, %c1"
#endif
  asm volatile(
      ".pushsection .eagerx.graph,\"\",%%progbits\n"
      ".ascii \"eagerx graph \"\n"
      ".4byte " EAGERX_NUMBERS
      "\n"
      ".popsection"
      :
      : "i"(static_cast<std::uint32_t>(Graph::kGraphHash)),
        "i"(static_cast<std::uint32_t>(Graph::kGraphHash >> kWordBits)));
#undef EAGERX_NUMBERS
#ifdef EAGERX_BOARD
  asm volatile(
      ".pushsection .eagerx.graph,\"\",%progbits\n"
      ".asciz \"eagerx board " EAGERX_BOARD
      "\"\n"
      ".popsection");
#endif
}

}  // namespace eagerx::board

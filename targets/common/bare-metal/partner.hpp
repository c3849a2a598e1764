// The main program of a board that runs a part of a graph, linked through its serial port to the
// rest on Linux.
#pragma once

#include <cstdint>
#include <targets/common/bare-metal/console.hpp>
#include <targets/common/bare-metal/graph_note.hpp>
#include <targets/common/bare-metal/stack.hpp>
#include <targets/common/partner.hpp>

namespace eagerx::board {

struct SerialPort {
  static void put(std::uint8_t byte) { uart_write(static_cast<char>(byte)); }
  static void flush() {}
  static int get() {
    char character = 0;
    if (uart_read(character)) return static_cast<std::uint8_t>(character);
    // A fifth of a byte's time at 25 MHz and 115200 baud. QEMU brings bytes in between two looks at
    // the UART only.
    constexpr int kRounds = 100;
    for (int i = 0; i < kRounds; ++i) asm volatile("");
    return link::kNothing;
  }
};

/// The main function; it does not return.
template <class Graph>
int serve() {
  static_assert(note_graph<Graph> != nullptr);
  constinit static target::BoardProgramOf<Graph, SerialPort> program{};
  constinit static target::BoardLinkOf<Graph, SerialPort> link{};
  target::serve<Graph, SerialPort>(program, link,
                                   [] { return static_cast<std::uint32_t>(stack_used_bytes()); });
  return kDone;
}

}  // namespace eagerx::board

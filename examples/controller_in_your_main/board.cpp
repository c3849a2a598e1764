// The program for a board without an operating system; it prints through the debugger.
#include <targets/common/bare-metal/console.hpp>

#include "loop.hpp"

using eagerx::board::console;

static constinit Controller program{};  // in .bss

int main() {
  if (!controller::Graph::self_test()) {
    console.text("bits differ on this board: does its start-up code set FPSCR.FZ?\n");
    console.flush();
    return 1;
  }
  Motor motor;
  run(program, motor, 2000);
  program.guard.for_each_count([](const char* name, unsigned long long count) {
    if (count == 0) return;
    console.text(name);
    console.text(" ");
    console.number(count);
    console.text("\n");
  });
  console.text("angle in millirad ");
  console.number(static_cast<unsigned long long>(motor.angle() * 1000.0F));
  console.text("\ntrace hash 0x");
  console.hex(program.hooks.hash());
  console.text("\n");
  console.flush();
  return 0;
}

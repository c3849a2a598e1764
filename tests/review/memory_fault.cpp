// A place in the schedule that is none: compiled with -fno-access-control, and with GRAPH as the
// namespace. SLOTS is how many there are.
#include <cstdint>
#include <cstdio>

#define EAGERX_WORD(x) #x
#define EAGERX_TEXT(x) EAGERX_WORD(x)
#include GRAPH_HEADER

using graphs::GRAPH::Graph;
static graphs::GRAPH::Program<> program;

#ifdef EAGERX_ON_BOARD
int main() {
  static_cast<void>(program.reset({}));
  program.slot_ = SLOTS;
  static_cast<void>(program.step(Graph::zero()));
  return 0;  // not reached
}
#else
static int calls = 0;
extern "C" void eagerx_memory_fault() {
  ++calls;
}

int main() {
  int expected = 0;
  for (const std::uint32_t wrong : {std::uint32_t{SLOTS}, SLOTS + 1U, 0x80000000U, 0xffffffffU}) {
    static_cast<void>(program.reset({}));
    for (int i = 0; i < 50; ++i) static_cast<void>(program.step(Graph::zero()));
    program.slot_ = wrong;
    static_cast<void>(program.step(Graph::zero()));
    ++expected;
    if (program.memory_faults() != static_cast<std::uint32_t>(expected) || calls != expected) {
      std::printf("%u is a place in the schedule\n", wrong);
      return 1;
    }
    // Nothing runs until the next reset.
    const std::uint32_t before = program.steps_before_reset();
    for (int i = 0; i < 50; ++i) static_cast<void>(program.step(Graph::zero()));
    if (calls != expected || program.steps_before_reset() != before + 50) return 2;
  }
  return 0;
}
#endif

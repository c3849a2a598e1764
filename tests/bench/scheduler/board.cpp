// Instructions of a slot besides the callbacks, on an emulated board. GRAPH is the graph, the other
// macros say how often its callbacks run in STEPS of its steps.
#include <cstdint>
#include <eagerx/window.hpp>
#include <models/mix/mix.hpp>

#include "tests/bench/instructions.hpp"

#define EAGERX_WORD(x) #x
#define EAGERX_TEXT(x) EAGERX_WORD(x)
#include GRAPH_HEADER

namespace {

using bench::hundredths;
using bench::print;
using eagerx::board::semihosting_write;
using graphs::GRAPH::Graph;

constexpr std::uint32_t kMostWindow = 8;
constexpr int kNodes = 12;
std::uint32_t messages[kNodes + 1][kMostWindow];
eagerx::Seq received = 1000;  // by every node

template <std::uint32_t Size>
struct Io {
  struct Inputs {
    // As the programs have them: of one message, or in a ring that is not full yet at first.
    eagerx::Window<std::uint32_t, eagerx::Rate<1>, Size == 1 ? 1 : kMostWindow, Size, Size == 1> a;
  };
  struct Outputs {
    std::uint32_t& mixed;
  };
  struct States {};
};
template <std::uint32_t Size>
constinit eagerx::bench::Mix<Io<Size>> nodes[kNodes]{};

template <std::uint32_t Size, int Node = 0>
void call() {
  if constexpr (Node < kNodes) {
    typename Io<Size>::Outputs out{messages[Node + 1][0]};
    nodes<Size>[Node].callback(eagerx::Tick{0}, {{messages[Node], received}}, out);
    asm volatile("" ::: "memory");  // the next one reads it as a message
    call<Size, Node + 1>();
  }
}

/// A callback with a window of Size messages, called in a straight line.
template <std::uint32_t Size>
[[gnu::noinline]] std::uint32_t bare() {
  return hundredths(500, [](std::uint32_t) { call<Size>(); }) / kNodes;
}

graphs::GRAPH::Program<eagerx::NoHooks> program;

/// The schedule alone: the guard of an action takes 2 to 3 instructions more.
[[gnu::noinline]] void step(std::uint32_t drive) {
  asm volatile("" ::"r"(program.step_unguarded({drive}).seen.back()));
}

}  // namespace

int main() {
  program.reset({});
  const std::uint32_t whole = hundredths(2000, step);
  const std::uint32_t one = bare<1>();
  const std::uint32_t five = bare<5>();
  const auto callbacks =
      static_cast<std::uint32_t>((std::uint64_t{ONES} * one + std::uint64_t{FIVES} * five) / STEPS);
  semihosting_write(EAGERX_TEXT(GRAPH));
  for (const std::uint32_t number :
       {whole, callbacks,
        static_cast<std::uint32_t>((std::uint64_t{whole} - callbacks) * STEPS / SLOTS)}) {
    semihosting_write(" ");
    print(number / 100);
    semihosting_write(number % 100 < 10 ? ".0" : ".");
    print(number % 100);
  }
  semihosting_write("\n");
  return 0;
}

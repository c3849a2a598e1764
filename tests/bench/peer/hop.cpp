// Runs the generated program of a chain of nodes for a number of steps (rows.py: chain()).
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <targets/common/run.hpp>

#include "chain/graph.hpp"

int main(int count, char** words) {
  using graphs::chain::Graph;
  if (count != 2) return 2;
  const long steps = std::atol(words[1]);
  constinit static Graph::Program<eagerx::NoHooks> program{};
  std::uint32_t seen = program.reset({}).seen.back();
  for (long i = 0; i < steps; ++i) seen = program.step({static_cast<std::uint32_t>(i)}).seen.back();
  std::printf("%u\n", seen);
}

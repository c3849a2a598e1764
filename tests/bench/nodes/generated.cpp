// The program that eagerx-gen makes, run as the targets run it.
#include <targets/common/run.hpp>

#include "loops.hpp"
#include "many_nodes/graph.hpp"

namespace eagerx::bench {

std::uint32_t run_generated(std::uint64_t steps) {
  using graphs::many_nodes::Graph;
  constinit static Graph::Program<NoHooks> program{};
  std::uint32_t seen = program.reset({}).seen_0.back();
  for (std::uint64_t step = 0; step < steps; ++step) {
    seen = program.step({static_cast<std::uint32_t>(step)}).seen_0.back();
  }
  return seen;
}

}  // namespace eagerx::bench

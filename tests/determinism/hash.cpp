// Prints the trace hash of the swing-up example: the loop of every target, and nothing that takes
// long to compile.
#include <cinttypes>
#include <cstdio>
#include <eagerx/trace.hpp>
#include <targets/common/run.hpp>

#include "pendulum_swing_up/graph.hpp"

namespace {

using graphs::pendulum_swing_up::Graph;

}  // namespace

int main() {
  const eagerx::target::RunPlan plan{.episodes = 2, .steps = 450, .seed = 1};
  constinit static Graph::Program<eagerx::HashTrace> program{};
  const auto agent = [](eagerx::EpisodeKey /*key*/, eagerx::Seq /*step*/,
                        const Graph::Observation& observation) {
    return Graph::policy(observation);
  };
  eagerx::target::Watch<Graph> watch;
  eagerx::target::run_episodes<Graph>(plan, program, agent, watch);
  std::printf("0x%016" PRIx64 "\n", program.hooks.hash());
}

// Prints the trace hash of the swing-up's first 100 steps with its policy. other.cpp includes the
// policy as well: its tables are one variable of the program.
#include <cstdio>
#include <eagerx/trace.hpp>
#include <targets/common/run.hpp>

#include "pendulum_swing_up/graph.hpp"

using graphs::pendulum_swing_up::Graph;

const void* table_of_other_file();
bool other_file_answers();

int main() {
  constinit static Graph::Program<eagerx::HashTrace> program{};
  const auto agent = [](eagerx::EpisodeKey /*key*/, eagerx::Seq /*step*/,
                        const Graph::Observation& observation) {
    return Graph::policy(observation);
  };
  eagerx::target::Watch<Graph> watch;
  const eagerx::target::RunPlan plan{.episodes = 1, .steps = 100, .seed = 1};
  eagerx::target::run_episodes<Graph>(plan, program, agent, watch);
  const bool once = table_of_other_file() == &graphs::pendulum_swing_up::policy::kLayer2;
  std::printf("0x%016llx %s %s\n", static_cast<unsigned long long>(program.hooks.hash()),
              Graph::self_test() && other_file_answers() ? "answers" : "answers otherwise",
              once ? "once" : "twice");
}

// The hash of 200 steps with random actions.
#include <cstdio>
#include <eagerx/trace.hpp>
#include <twelve_joints/graph.hpp>

using graphs::twelve_joints::Graph;
static graphs::twelve_joints::Program<eagerx::HashTrace> program;

int main() {
  program.hooks.on_episode(0);
  static_cast<void>(program.reset({}));
  for (eagerx::Seq i = 0; i < 200; ++i) {
    static_cast<void>(
        program.step_unguarded(Graph::random({.seed = 1, .environment = 0, .episode = 0}, i)));
  }
  std::printf("%016llx\n", static_cast<unsigned long long>(program.hooks.hash()));
}

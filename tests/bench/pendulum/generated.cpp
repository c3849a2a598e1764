// The program that eagerx-gen makes, run as the targets run it.
#include <targets/common/run.hpp>

#include "loops.hpp"
#include "pendulum_swing_up/graph.hpp"

namespace eagerx::bench {

Seen run_generated(bool policy, std::uint64_t steps) {
  using graphs::pendulum_swing_up::Graph;
  constinit static Graph::Program<NoHooks> program{};
  const auto agent = policy ? target::Agent::policy : target::Agent::zero;
  Graph::States states;
  states.pendulum_model_state = Array<float, 2>{{kTheta, kThetaDot}};
  Graph::Observation observation = program.reset(states);
  for (std::uint64_t step = 0; step < steps; ++step) {
    observation = program.step(target::act<Graph>(agent, EpisodeKey{}, step, observation, program));
  }
  const auto& angle = observation.angle.back();
  return {angle[0], angle[1], observation.theta_dot.back()};
}

}  // namespace eagerx::bench

// The programs that eagerx-gen makes.
#include <targets/common/run.hpp>

#include "loops.hpp"
#include "rigid_box/graph.hpp"
#include "rigid_pendulum/graph.hpp"

namespace eagerx::bench {

Seen pendulum_generated(std::uint64_t steps) {
  using graphs::rigid_pendulum::Graph;
  constinit static Graph::Program<NoHooks> program{};
  Graph::States states;
  states.pendulum_model_state = Array<float, 2>{{kTheta, kThetaDot}};
  Graph::Observation observation = program.reset(states);
  for (std::uint64_t step = 0; step < steps; ++step)
    observation = program.step({.voltage = {{voltage_at(step)}}});
  return observation.theta.back();
}

Seen box_generated(std::uint64_t steps) {
  using graphs::rigid_box::Graph;
  constinit static Graph::Program<NoHooks> program{};
  Graph::States states;
  states.box_pose = Array<float, 7>{{0.0F, 0.0F, 0.05F, 1.0F}};
  states.box_twist = Array<float, 6>{};
  Graph::Observation observation = program.reset(states);
  for (std::uint64_t step = 0; step < steps; ++step)
    observation = program.step({.force = {{force_at(step), 0.0F, 0.0F}}});
  return observation.pose.back()[0];
}

}  // namespace eagerx::bench

// The controller of the swing-up puts out what is applied in the simulation, given its
// measurements.
#include <bit>
#include <cstdint>
#include <cstdio>

#include "pendulum_swing_up.hpp"
#include "swing_up_controller.hpp"

namespace simulation = graphs::pendulum_swing_up;
namespace controller = graphs::swing_up_controller;

/// The latest measurements, and what the filter sent.
struct Watch {
  float theta = 0.0F, theta_dot = 0.0F, voltage = 0.0F;

  void on_episode(std::uint32_t /*index*/) {}
  template <class Message>
  void on_message(std::uint32_t channel, eagerx::Seq /*seq*/, const Message& message) {
    const float value = static_cast<float>(eagerx::element(message, 0));
    if (channel == simulation::channel::pendulum_theta_observation) theta = value;
    if (channel == simulation::channel::pendulum_theta_dot_observation) theta_dot = value;
    if (channel == simulation::channel::smooth_filtered) voltage = value;
  }
};

int main() {
  static simulation::Program<Watch> plant;
  static controller::Program<> program;
  simulation::Observation seen = plant.reset(simulation::Graph::sample({1, 0, 0}));
  program.reset({});
  for (int step = 0; step < 450; ++step) {
    const controller::Action measured{plant.hooks.theta, plant.hooks.theta_dot};
    const float out = program.step(measured).voltage.back()[0];
    seen = plant.step(simulation::Graph::policy(seen));
    if (std::bit_cast<std::uint32_t>(out) == std::bit_cast<std::uint32_t>(plant.hooks.voltage))
      continue;
    std::printf("step %d: %a instead of %a\n", step, static_cast<double>(out),
                static_cast<double>(plant.hooks.voltage));
    return 1;
  }
  std::printf("theta %.3f rad at the end\n", static_cast<double>(plant.hooks.theta));
}

// The controller of an example in a loop of its own, with the motor, and in the simulation.
#include <gtest/gtest.h>

#include <eagerx/trace.hpp>

#include "examples/controller_in_your_main/motor.hpp"
#include "motor.hpp"
#include "motor_control.hpp"

namespace {

namespace whole = graphs::motor;
namespace cut = graphs::motor_control;

/// The hash of the controller's messages, by what they are in both graphs.
template <std::uint32_t Smooth, std::uint32_t Position, std::uint32_t Ramp>
struct ControllerHooks {
  eagerx::HashTrace hash;
  std::uint64_t messages = 0;

  void on_episode(std::uint32_t /*index*/) {}
  template <class Message>
  void on_message(std::uint32_t channel, eagerx::Seq seq, const Message& message) {
    const std::uint32_t number = channel == Smooth ? 1 : channel == Position ? 2 : 3;
    if (number == 3 && channel != Ramp) return;
    ++messages;
    hash.on_message(number, seq, message);
  }
};
using TraceOfWhole =
    ControllerHooks<whole::channel::control_smooth_filtered, whole::channel::control_position_u,
                    whole::channel::control_ramp_limited>;
using TraceOfCut =
    ControllerHooks<cut::channel::control_smooth_filtered, cut::channel::control_position_u,
                    cut::channel::control_ramp_limited>;

TEST(CutTest, InALoopWithTheMotorItsMessagesAreThoseOfTheSimulation) {
  constexpr int kSteps = 2000;
  whole::Program<TraceOfWhole> simulation;
  simulation.reset(whole::Graph::sample({.seed = 1, .environment = 0, .episode = 0}));
  for (int i = 1; i < kSteps; ++i) simulation.step({});

  cut::Program<TraceOfCut> program;
  program.reset({});
  Motor motor;
  for (int i = 0; i < kSteps; ++i)
    motor.apply(program.step({.angle = {motor.angle()}}).voltage.back()[0]);

  EXPECT_GT(motor.angle(), 0.9F);
  EXPECT_EQ(program.hooks.messages, 2U * kSteps + kSteps / 5U);
  EXPECT_EQ(program.hooks.messages, simulation.hooks.messages);
  EXPECT_EQ(program.hooks.hash.hash(), simulation.hooks.hash.hash());
}

}  // namespace

// The main loop: passes the sensor's value to the controller, and its output to the motor.
#pragma once

#include <eagerx/trace.hpp>

#include "motor.hpp"
#include "motor_control.hpp"

namespace controller = graphs::motor_control;

/// With the hash of all messages, to compare machines; without it: controller::Program<>.
using Controller = controller::Program<eagerx::HashTrace>;

/// `steps` periods of 2 ms. In firmware this is the body of a timer's interrupt.
inline void run(Controller& program, Motor& motor, int steps) {
  program.reset({});
  for (int i = 0; i < steps; ++i) {
    const controller::Action action{.angle = {motor.read_encoder()}};
    const controller::Observation seen = program.step(action);
    motor.apply(seen.voltage.back()[0]);
  }
}

// The motor of examples/controller_in_your_main does not move when its controller begins anew.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "motor_control.hpp"

namespace {

using Controller = graphs::motor_control::Program<>;

/// The largest voltage in `steps` steps of an encoder that says `angle`.
float largest_voltage(Controller& program, float angle, int steps) {
  float largest = 0.0F;
  for (int n = 0; n < steps; ++n)
    largest = std::max(largest, std::abs(program.step({.angle = {angle}}).voltage.back()[0]));
  return largest;
}

TEST(MotorTest, AShaftAtItsGoalGetsNoKickAtPowerOnAndAfterADropout) {
  constexpr float kGoal = 1.0F;  // rad, the setpoint
  Controller program;
  program.reset({});
  EXPECT_LT(largest_voltage(program, kGoal, 100), 0.01F) << "at power-on";
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  EXPECT_LT(largest_voltage(program, kNaN, 9), 0.01F) << "held";
  EXPECT_LT(largest_voltage(program, kGoal, 100), 0.01F) << "after a hold";
  EXPECT_EQ(largest_voltage(program, kNaN, 30) > 0.01F, false) << "safe";
  EXPECT_LT(largest_voltage(program, kGoal, 100), 0.01F) << "after a dropout";
}

TEST(MotorTest, AShaftElsewhereGetsTheVoltageOfItsErrorAlone) {
  Controller program;
  program.reset({});
  // kp 8 V/rad, ki 4 V/(rad·s), each 10 ms, and at most 200 V/s.
  EXPECT_NEAR(largest_voltage(program, 0.9F, 26), 8.0F * 0.1F + 4.0F * 0.1F * 0.06F, 0.01F);
}

}  // namespace

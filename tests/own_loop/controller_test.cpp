// Controllers without an engine: what leaves while a measurement is missing, wrong, late or frozen.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "arm.hpp"
#include "faults.hpp"
#include "poisoned.hpp"
#include "servo.hpp"
#include "wide.hpp"

namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr std::uint32_t kFaults = 10'000;

template <class Program>
std::map<std::string, std::uint64_t> counts_of(const Program& program) {
  std::map<std::string, std::uint64_t> counts;
  program.guard.for_each_count([&](const char* name, std::uint64_t n) { counts[name] = n; });
  return counts;
}

using Servo = graphs::servo::Program<own_loop::CountingHooks>;
using Arm = graphs::arm::Program<own_loop::CountingHooks>;

TEST(ControllerTest, AServoIsSafeInTimeAtTenThousandFaults) {
  Servo program;
  const auto report = own_loop::Trial<graphs::servo::Limits, Servo>(program, 6).run(kFaults);
  EXPECT_EQ(report.violations, 0U) << "rule " << report.first_violation;
  EXPECT_GT(report.steps, 20U * kFaults);
  for (const char* name : {"safe: action not finite: angle", "safe: action missing",
                           "safe: action frozen: angle", "safe: overrun"})
    EXPECT_GT(counts_of(program)[name], kFaults / 2) << name;
}

TEST(ControllerTest, AnArmIsSafeInTimeAtTenThousandFaults) {
  Arm program;
  const auto report = own_loop::Trial<graphs::arm::Limits, Arm>(program, 5).run(kFaults);
  EXPECT_EQ(report.violations, 0U) << "rule " << report.first_violation;
  EXPECT_GT(counts_of(program)["safe: action not finite: joints"], kFaults);
  EXPECT_EQ(counts_of(program)["safe: action not finite: rates"], 0U);
}

TEST(ControllerTest, AMeasurementThatIsGoneForEverLeadsToTheSafeOutput) {
  Servo program;
  program.reset({});
  for (int i = 0; i < 1000; ++i)
    program.step({.angle = {1.0F + 0.001F * static_cast<float>(i % 7)}});
  float voltage = 0.0F;
  for (int i = 0; i < 1000; ++i) voltage = program.step({.angle = {kNaN}}).voltage.back()[0];
  EXPECT_EQ(voltage, -0.5F);
}

TEST(ControllerTest, UnmeasuredOutputsAreNotZero) {
  const graphs::arm::Action nothing = graphs::arm::not_measured();
  std::size_t numbers = 0;
  nothing.for_each([&](const char* name, const auto& message) {
    for (std::size_t i = 0; i < eagerx::size_of<std::remove_cvref_t<decltype(message)>>; ++i) {
      EXPECT_TRUE(std::isnan(eagerx::element(message, i))) << name;
      ++numbers;
    }
  });
  EXPECT_GT(numbers, 2U);
  Servo program;
  program.reset({});
  for (int i = 0; i < 20; ++i) program.step(graphs::servo::not_measured());
  EXPECT_FALSE(program.guard.acts());
  EXPECT_EQ(program.step(graphs::servo::not_measured()).voltage.back()[0], -0.5F);
}

TEST(ControllerTest, HeldNodesGoOnFromWhereTheyStood) {
  Arm with_fault, without;
  with_fault.reset({});
  without.reset({});
  const auto action = [](int i) {
    const float x = 0.01F * static_cast<float>(i);
    return graphs::arm::Action{.joints = {x, -x}, .rates = {x, x}};
  };
  float wanted = 0.0F;
  for (int i = 0; i < 50; ++i) {
    wanted = with_fault.step(action(i)).wanted.back()[0];
    without.step(action(i));
  }
  for (int i = 0; i < 20; ++i) {
    const auto seen = with_fault.step({.joints = {kNaN, 0.0F}, .rates = {0.0F, 0.0F}});
    EXPECT_EQ(seen.torque.back()[0], 2.0F);
    EXPECT_EQ(seen.torque.back()[1], -1.0F);
    EXPECT_EQ(seen.wanted.back()[0], wanted) << "what is not an output is what the nodes sent last";
  }
  for (int i = 0; i < 2; ++i) with_fault.step(action(100 + i));  // recovering: two of three
  for (int i = 60; i < 80; ++i) {
    EXPECT_EQ(with_fault.step(action(i)).torque.back()[0],
              without.step(action(i)).torque.back()[0]);
  }
}

TEST(ControllerTest, AnOutputThatIsNotFiniteNeverLeavesAndResetsTheNodes) {
  graphs::poisoned::Program<> program;
  program.reset({});
  const auto left = [&] { return program.step({.speed = {1.0F}}).position.back()[0]; };
  left();
  program.step_unguarded({.speed = {kNaN}});  // the guard would not let it in
  EXPECT_EQ(left(), 0.25F);
  EXPECT_EQ(counts_of(program)["safe: output not finite: position"], 1U);
  EXPECT_EQ(left(), 0.25F) << "the first of two right ones";
  EXPECT_LT(std::abs(left()), 0.02F) << "the sum begins anew";
}

TEST(ControllerTest, AnOutputOutOfItsLimitsMakesSafeIfTheGraphSaysSo) {
  graphs::poisoned::Program<> program;
  program.reset({});
  float last = 0.0F;
  for (int i = 0; i < 100; ++i) last = program.step({.speed = {2.0F}}).position.back()[0];
  EXPECT_EQ(last, 0.25F);
  EXPECT_GT(counts_of(program)["safe: output out of limits: position"], 0U);
}

TEST(ControllerTest, TheSafeOutputEndsARun) {
  Arm program;
  EXPECT_EQ(program.step_safely().torque.back()[0], 2.0F) << "even before the first reset";
  program.reset({});
  program.step({.joints = {0.1F, 0.1F}, .rates = {0.0F, 0.0F}});
  EXPECT_EQ(program.step_safely().torque.back()[1], -1.0F);
  EXPECT_EQ(counts_of(program)["safe: stopped"], 1U);
}

TEST(ControllerTest, NothingRunsBeforeTheFirstResetOfAGraphWithAnEngine) {
  graphs::wide::Program<own_loop::CountingHooks> program;
  for (int i = 0; i < 100; ++i) program.step({.voltage = {3.0F}});
  program.step_safely();
  program.step_unguarded({.voltage = {3.0F}});
  EXPECT_EQ(program.hooks.messages, 0U);
  EXPECT_EQ(program.steps_before_reset(), 102U);
  program.reset({});
  program.step({.voltage = {1.0F}});
  EXPECT_EQ(program.steps_before_reset(), 102U);
}

TEST(ControllerTest, WhatTheGuardDoesNotSeeLeavesAsItIs) {
  Servo program;
  program.reset({});
  program.step_unguarded({.angle = {0.5F}});
  EXPECT_EQ(counts_of(program)["safe: steps"], 0U);
}

}  // namespace

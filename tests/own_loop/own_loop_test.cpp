// Messages that reach an actuator from main loops without code for safety.
#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <cstdint>
#include <eagerx/random.hpp>
#include <limits>
#include <map>
#include <string>

#include "converted.hpp"
#include "skipped.hpp"
#include "taken_over.hpp"
#include "wide.hpp"

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr eagerx::EpisodeKey kKey{.seed = 1, .environment = 0, .episode = 0};

/// Sees what is sent to the motor.
struct MotorHooks {
  std::uint32_t channel = 0;  // of what the actuator has applied
  float least = kInfinity;
  float most = -kInfinity;
  float last = 0.0F;
  std::uint64_t not_finite = 0;

  void on_episode(std::uint32_t /*index*/) {}
  template <class Message>
  void on_message(std::uint32_t of, eagerx::Seq /*seq*/, const Message& message) {
    if (of != channel) return;
    last = static_cast<float>(eagerx::element(message, 0));
    not_finite += std::isfinite(last) ? 0 : 1;
    least = std::fmin(least, last);
    most = std::fmax(most, last);
  }
};

/// NaN, infinities, 1e38 and the like, and numbers as they should be.
float any_action(std::uint32_t word) {
  const float share = static_cast<float>(word >> 8U) / 16777216.0F;
  switch (word & 7U) {
    case 0:
      return kNaN;
    case 1:
      return kInfinity;
    case 2:
      return -kInfinity;
    case 3:
      return share < 0.5F ? 1e38F : -1e38F;
    case 4:
      return 100.0F * (share - 0.5F);
    case 5:
      return std::numeric_limits<float>::denorm_min();
    default:
      return 4.0F * (share - 0.5F);
  }
}

template <class Program>
std::map<std::string, std::uint64_t> counts_of(const Program& program) {
  std::map<std::string, std::uint64_t> counts;
  program.guard.for_each_count([&](const char* name, std::uint64_t n) { counts[name] = n; });
  return counts;
}

/// The ten lines: a loop that steps with whatever it has.
template <class Program, class Graph>
void run_loop(Program& program, int steps) {
  program.reset(Graph::sample(kKey));
  std::uint32_t word = 1;
  for (int i = 0; i < steps; ++i) {
    word = word * 1664525U + 1013904223U;
    typename Graph::Action action = Graph::zero();
    action.voltage[0] = any_action(word ^ (word >> 16U));
    program.step(action);
  }
}

constexpr int kMillion = 1'000'000;

TEST(OwnLoopTest, NothingLeavesTheActuatorsSpace) {
  graphs::wide::Program<MotorHooks> program;
  program.hooks.channel = graphs::wide::channel::pendulum_u_action_applied;
  run_loop<decltype(program), graphs::wide::Graph>(program, kMillion);
  EXPECT_EQ(program.hooks.not_finite, 0U);
  EXPECT_EQ(program.hooks.least, -2.0F);
  EXPECT_EQ(program.hooks.most, 2.0F);
  auto counts = counts_of(program);
  EXPECT_GT(counts["safe: action not finite: voltage"], kMillion / 4U);
  EXPECT_GT(counts["safe: action out of limits: voltage"], kMillion / 10U);
  EXPECT_GT(counts["safe: action beyond its actuator: voltage"], kMillion / 10U);
}

TEST(OwnLoopTest, NorThroughAProcessor) {
  graphs::converted::Program<MotorHooks> program;
  program.hooks.channel = graphs::converted::channel::pendulum_u_action_applied;
  run_loop<decltype(program), graphs::converted::Graph>(program, kMillion);
  EXPECT_EQ(program.hooks.not_finite, 0U);
  EXPECT_EQ(program.hooks.least, -2.0F);
  EXPECT_EQ(program.hooks.most, 2.0F);
}

TEST(OwnLoopTest, NorWithSafety) {
  graphs::taken_over::Program<MotorHooks> program;
  program.hooks.channel = graphs::taken_over::channel::pendulum_u_action_applied;
  run_loop<decltype(program), graphs::taken_over::Graph>(program, kMillion);
  EXPECT_EQ(program.hooks.not_finite, 0U);
  EXPECT_GE(program.hooks.least, -2.0F);
  EXPECT_LE(program.hooks.most, 2.0F);
  EXPECT_GT(counts_of(program)["safe: times"], kMillion / 20U);
}

TEST(OwnLoopTest, SafetyTakesOverAfterLateStepsAndGivesBack) {
  graphs::taken_over::Program<MotorHooks> program;
  program.hooks.channel = graphs::taken_over::channel::pendulum_u_action_applied;
  program.reset(graphs::taken_over::Graph::sample(kKey));
  const auto applied = [&](float voltage, std::uint64_t late = 0) {
    program.step({.voltage = {voltage}}, late);
    return program.hooks.last;
  };
  EXPECT_EQ(applied(1.0F), 1.0F);
  EXPECT_EQ(applied(1.0F, 1), 1.0F) << "one late step is not yet two";
  EXPECT_EQ(applied(1.0F, 2), 0.5F);
  EXPECT_EQ(applied(1.0F), 0.5F) << "the first of two right ones";
  EXPECT_EQ(applied(1.0F), 1.0F);
  EXPECT_EQ(applied(kNaN), 0.5F);
  program.reset({});
  EXPECT_EQ(applied(1.0F), 1.0F) << "another episode";
  EXPECT_EQ(applied(3.0F), 2.0F) << "within its space, beyond the actuator's";
}

TEST(OwnLoopTest, WhatHasNotComeYetBecauseTheGraphSaysSoIsNoFault) {
  graphs::skipped::Program<MotorHooks> program;
  for (int episode = 0; episode < 3; ++episode) {
    program.reset(graphs::skipped::Graph::sample(kKey));
    for (int i = 0; i < 5; ++i) program.step({.target = {0.1F}});
  }
  for (const auto& [name, count] : counts_of(program)) EXPECT_EQ(count, 0U) << name;
  program.step({.target = {kNaN}});
  EXPECT_EQ(counts_of(program)["safe: action not finite: target"], 1U);
}

TEST(OwnLoopTest, TheSafeActionEndsARun) {
  graphs::taken_over::Program<MotorHooks> program;
  program.hooks.channel = graphs::taken_over::channel::pendulum_u_action_applied;
  program.reset({});
  program.step_safely();
  EXPECT_EQ(program.hooks.last, 0.5F);
  EXPECT_EQ(counts_of(program)["safe: stopped"], 1U);
}

TEST(OwnLoopTest, TheGuardIsOffForWhoSaysSo) {
  graphs::wide::Program<MotorHooks> program;
  program.hooks.channel = graphs::wide::channel::pendulum_u_action_applied;
  program.reset({});
  program.step_unguarded({.voltage = {3.0F}});
  EXPECT_EQ(program.hooks.last, 3.0F);
  for (const auto& [name, count] : counts_of(program)) EXPECT_EQ(count, 0U) << name;
}

TEST(OwnLoopTest, ALoopThatRoundsOtherwiseIsReported) {
  EXPECT_TRUE(graphs::wide::Graph::self_test());
  std::fesetround(FE_UPWARD);
  const bool upward = graphs::wide::Graph::self_test();
  std::fesetround(FE_TONEAREST);
  EXPECT_FALSE(upward);
  EXPECT_TRUE(graphs::wide::Graph::self_test());
}

}  // namespace

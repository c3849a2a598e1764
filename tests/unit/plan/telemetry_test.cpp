// Telemetry of a board: the channels of each record, and how many of their messages fit.
#include "generator/graph/plan/telemetry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <eagerx/link/telemetry.hpp>
#include <memory>

#include "tests/unit/graph_of_text.hpp"

namespace eagerx::gen {
namespace {

/// A graph whose plan is of telemetry.
struct Planned {
  std::unique_ptr<GraphOfText> made;

  const TelemetryPlan& telemetry() const { return *made->plan->telemetry; }
  /// By group: "60 Hz/2: a b"
  std::vector<std::string> groups() const {
    std::vector<std::string> result;
    for (const auto& group : telemetry().groups) {
      std::string text = made->plan->rates[group.rate].rate_hz.to_string() + " Hz/" +
                         std::to_string(group.every) + ":";
      for (const auto& place : group.channels)
        text += " " + place.port + "@" + std::to_string(place.offset);
      result.push_back(text);
    }
    return result;
  }
};

/// Sensors at 600 and 60 Hz, a filter at 300 Hz, an agent at 30 Hz.
Planned with_telemetry(const std::string& telemetry) {
  const std::string text =
      "name: tested\nrate: 30\nengine: {type: OdeEngine, rate: 600}\n"
      "objects:\n  arm: {type: Pendulum, sensors: {theta: {rate: 600}, theta_dot: {rate: 60}}}\n"
      "nodes:\n  smooth: {type: ButterworthFilter, rate: 300, config: {cutoff_hz: 5}}\n"
      "actions: {voltage: {space: {like: arm.u}}}\nobservations: [angle, speed]\n"
      "connections:\n  - {from: actions.voltage, to: smooth.signal}\n"
      "  - {from: smooth.filtered, to: arm.u}\n  - {from: arm.theta, to: observations.angle}\n"
      "  - {from: arm.theta_dot, to: observations.speed}\n"
      "telemetry: {" +
      telemetry + "}\n";
  return {read_graph_text(text)};
}

using Texts = std::vector<std::string>;

TEST(PlanTelemetry, WhatFitsIsSentInFull) {
  const auto made = with_telemetry(
      "channels: [actions.voltage, arm.theta, engine.tick], share: 1, baud: 1000000");
  ASSERT_TRUE(made.made->plan) << render_text(made.made->diagnostics, made.made->sources, false);
  EXPECT_EQ(made.groups(),
            (Texts{"600 Hz/1: arm.theta@8 engine.tick@12", "30 Hz/1: actions.voltage@8"}));
  EXPECT_EQ(made.telemetry().groups.front().bytes, 20U);
  EXPECT_FALSE(made.telemetry().wanted_bytes_per_s);
  // Frames of 20 + 12 and 12 + 12 bytes, and a greeting of 28 + 12 once a second.
  EXPECT_DOUBLE_EQ(made.telemetry().bytes_per_s, 600 * 32 + 30 * 24 + 40);
  EXPECT_EQ(made.telemetry().greet_every, 630U);
  EXPECT_EQ(made.telemetry().cells, 8U);
}

TEST(PlanTelemetry, TheFastestGiveWayFirst) {
  const auto made = with_telemetry(
      "channels: [arm.theta, smooth.filtered, arm.theta_dot, actions.voltage], baud: 76800");
  ASSERT_TRUE(made.made->plan) << render_text(made.made->diagnostics, made.made->sources, false);
  // All 990 messages of 24 bytes would be 23,760; 3,840 are allowed.
  EXPECT_EQ(made.groups(), (Texts{"600 Hz/13: arm.theta@8", "300 Hz/7: smooth.filtered@8",
                                  "60 Hz/2: arm.theta_dot@8", "30 Hz/1: actions.voltage@8"}));
  EXPECT_LE(made.telemetry().bytes_per_s, 3840);
  EXPECT_DOUBLE_EQ(*made.telemetry().wanted_bytes_per_s, 990 * 24 + 40);
}

TEST(PlanTelemetry, ThereIsNoFasterRateThatFits) {
  for (const int baud : {4800, 9600, 19200, 38400, 57600, 115200, 230400}) {
    const auto made = with_telemetry(
        "channels: [arm.theta, smooth.filtered, arm.theta_dot, actions.voltage], baud: " +
        std::to_string(baud));
    ASSERT_TRUE(made.made->plan) << baud;
    const double allowed = baud / 20.0;
    EXPECT_LE(made.telemetry().bytes_per_s, allowed) << baud;
    const auto of_first = [&](std::uint32_t n) {
      double bytes = 40;
      for (const double hz : {600.0, 300.0, 60.0, 30.0}) {
        const double every = std::max(1.0, std::ceil(hz * n / 600.0 - 1e-9));
        bytes += 24 * hz / every;
      }
      return bytes;
    };
    const std::uint32_t every = made.telemetry().groups.front().every;
    EXPECT_NEAR(of_first(every), made.telemetry().bytes_per_s, 1e-6) << baud;
    if (every > 1) {
      EXPECT_GT(of_first(every - 1), allowed) << baud;
    }
  }
}

TEST(PlanTelemetry, AMostRateIsKept) {
  const auto made =
      with_telemetry("channels: [arm.theta, actions.voltage], rate: 45, baud: 1000000");
  ASSERT_TRUE(made.made->plan);
  // 600 / 45 is 13.3.
  EXPECT_EQ(made.groups(), (Texts{"600 Hz/14: arm.theta@8", "30 Hz/1: actions.voltage@8"}));
}

TEST(PlanTelemetry, WhatIsSlowerThanAHertzIsSentInFull) {
  const auto made = with_telemetry("channels: [arm.theta], rate: 1/10, baud: 1200");
  ASSERT_TRUE(made.made->plan) << render_text(made.made->diagnostics, made.made->sources, false);
  EXPECT_EQ(made.groups(), (Texts{"600 Hz/6000: arm.theta@8"}));
}

TEST(PlanTelemetry, TooMuchIsRefusedWithItsPlace) {
  const auto made =
      with_telemetry("channels: [arm.theta, actions.voltage], baud: 1200, share: 0.5");
  EXPECT_FALSE(made.made->plan);
  ASSERT_EQ(made.made->diagnostics.error_count(), 1U);
  EXPECT_EQ(made.made->diagnostics.all().front().code, "E0426");
  EXPECT_EQ(made.made->diagnostics.all().front().span.line, 15U);
}

TEST(PlanTelemetry, WhereInputsGoByTheClockEachChannelIsOnItsOwn) {
  // Their nodes may leave out messages, each its own.
  const auto made = with_telemetry("channels: [arm.theta, engine.tick], baud: 1000000");
  ASSERT_TRUE(made.made->graph);
  made.made->graph->asynchronous = true;
  made.made->plan = make_plan(*made.made->graph, made.made->diagnostics);
  ASSERT_TRUE(made.made->plan);
  EXPECT_EQ(made.groups(), (Texts{"600 Hz/1: arm.theta@8", "600 Hz/1: engine.tick@8"}));
}

TEST(PlanTelemetry, FramesAreAsLongAsThoseOfTheRuntime) {
  for (const std::size_t size : {0U, 8U, 28U, 244U, 245U, 246U, 1000U, 2048U}) {
    const auto frame = std::make_unique<link::ByteFrame<link::kMostRecordBytes>>();
    frame->begin(0);
    // No zeros: the longest that it can become.
    for (std::size_t i = 0; i < link::kHeaderBytes + size; ++i) frame->add(1);
    frame->finish();
    std::size_t bytes = 1;
    while (!frame->offer([](std::uint8_t) { return true; })) ++bytes;
    EXPECT_LE(bytes, telemetry_frame_bytes(size)) << size;
    EXPECT_GE(bytes + 1, telemetry_frame_bytes(size)) << size;
  }
  EXPECT_EQ(telemetry_frame_bytes(link::kTelemetryGreetingBytes), 40U);
}

}  // namespace
}  // namespace eagerx::gen

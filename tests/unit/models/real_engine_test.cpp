// models/engines/real_engine over a link that a test holds in its hands: time, order, safety.
#include <gtest/gtest.h>

#include <limits>

#include "tests/unit/models/real_engine_io.hpp"

namespace eagerx::models::testing {
namespace {

TEST_F(RealEngineTest, OneRoundTripAndOneOneWayTransferAnInstant) {
  begin();
  EXPECT_EQ(observation, 1.0F);
  EXPECT_EQ(instant(), (Lines{"post act10", "run measure"}));
  action = 1.5F;
  FakeLink::measured = 2.0F;
  EXPECT_EQ(instant(), (Lines{"post act10", "run measure"}));
  EXPECT_EQ(observation, 2.0F);
  EXPECT_EQ(instant(), (Lines{"post act15", "run measure"}));
}

TEST_F(RealEngineTest, InstantsAreAbsolute) {
  begin();
  const std::int64_t start = FakeClock::now;
  for (int i = 1; i <= 100; ++i) {
    instant();
    EXPECT_EQ(FakeClock::now, start + i * 20 * kMs + 200'000);
  }
  EXPECT_EQ(count("late by less than 10 us"), 100U);
  EXPECT_EQ(count("instants too late"), 0U);
}

// From the beginning of an instant: 0.2 ms for its round trip, 3 ms of calculation, 0.2 ms to send.
TEST_F(RealEngineTest, TheTimeToItsActionsIsCounted) {
  begin();
  FakeClock::now += 3 * kMs;
  instant();
  instant();
  EXPECT_EQ(count("acted after 1 to 10 ms"), 1U);
  EXPECT_EQ(count("acted after 200 to 500 us"), 1U);
  EXPECT_EQ(count("slowest action after us"), 3400U);
}

TEST_F(RealEngineTest, LateWakeUpMakesSafeAtOnceAndIsReleased) {
  begin();
  instant();
  FakeClock::late = 6 * kMs;
  EXPECT_EQ(instant(), (Lines{"post act10", "run measure", "post act5"}));
  EXPECT_TRUE(engine.is_safe());
  EXPECT_EQ(applied[0], 0.5F);
  FakeClock::late = 0;
  EXPECT_EQ(instant(), (Lines{"post act5", "run measure"}));
  EXPECT_EQ(applied[0], 0.5F);
  EXPECT_EQ(instant(), (Lines{"post act5", "run measure"}));
  EXPECT_FALSE(engine.is_safe()) << "two instants were right";
  EXPECT_EQ(instant(), (Lines{"post act10", "run measure"}));
  EXPECT_EQ(count("instants too late"), 1U);
  EXPECT_EQ(count("safe actions"), 1U);
  EXPECT_EQ(count("late by 1 to 10 ms"), 1U);
}

TEST_F(RealEngineTest, ALongStopMovesTheInstants) {
  begin();
  instant();
  FakeClock::now += 1000 * kMs;
  instant();
  const std::int64_t before = FakeClock::now;
  instant();
  EXPECT_GT(FakeClock::now - before, 15 * kMs) << "no burst";
  EXPECT_EQ(count("instants moved"), 1U);
}

// The program was stopped while it decided (SIGSTOP, a debugger): what it decided is a second old.
TEST_F(RealEngineTest, TheFirstActionAfterAPauseIsTheSafeOne) {
  begin();
  action = 1.5F;
  instant();
  FakeClock::now += 1000 * kMs;
  EXPECT_EQ(instant().front(), "post act5");
  EXPECT_TRUE(engine.is_safe());
  EXPECT_EQ(count("instants with an action too old"), 1U);
  EXPECT_EQ(count("instants moved"), 1U);
}

TEST_F(RealEngineTest, AnActionWithinAPeriodOfItsInstantIsApplied) {
  begin();
  action = 1.5F;
  instant();
  FakeClock::now += 19 * kMs;  // of 20
  EXPECT_EQ(instant().front(), "post act15");
}

TEST_F(RealEngineTest, LinkErrorsMakeSafe) {
  for (const BusError error : {BusError::link_lost, BusError::timeout, BusError::short_reply}) {
    begin();
    instant();
    FakeLink::results = {error};
    EXPECT_EQ(instant().back(), "post act5");
    EXPECT_EQ(observation, 1.0F) << "the last value stays";
  }
  EXPECT_EQ(count("safe actions"), 3U);
}

TEST_F(RealEngineTest, OneMissingValueIsBorneTwoAreNot) {
  begin();
  instant();
  FakeLink::sensor = BusError::parity;
  EXPECT_EQ(instant().back(), "run measure");
  EXPECT_EQ(instant().back(), "post act5");
  EXPECT_EQ(count("sensor parity"), 2U);
  EXPECT_EQ(count("instants with a sensor stale"), 1U);
}

TEST_F(RealEngineTest, ValuesOutsideTheLimitsAndNaNAreNotTaken) {
  begin();
  instant();
  FakeLink::measured = 5.5F;
  instant();
  EXPECT_EQ(observation, 1.0F);
  FakeLink::measured = std::numeric_limits<float>::quiet_NaN();
  instant();
  EXPECT_EQ(observation, 1.0F);
  EXPECT_EQ(count("sensor out of range"), 2U);
  EXPECT_TRUE(engine.is_safe());
}

TEST_F(RealEngineTest, ActionsAreLimitedAndNaNIsSafe) {
  begin();
  action = 7.0F;
  instant();
  EXPECT_EQ(applied[0], 2.0F);
  EXPECT_EQ(instant()[0], "post act20");
  EXPECT_GE(count("actions out of limits"), 2U);
  action = std::numeric_limits<float>::quiet_NaN();
  instant();
  action = 1.0F;
  const Lines lines = instant();
  EXPECT_EQ(lines.front(), "post act5") << "the NaN of the instant before";
  EXPECT_EQ(count("actions not finite"), 1U);
}

struct StrictIo : ActuatorIo {
  struct Config : ActuatorIo::Config {
    static constexpr auto limits = OutOfLimits::safe;
  };
};

TEST_F(RealEngineTest, AnActionOutOfLimitsCanMakeSafe) {
  begin();
  instant();
  RealActuator<StrictIo> strict;
  const Array<float, 1> ring[1] = {{{7.0F}}};
  const std::int64_t ticks[1] = {0};
  StrictIo::Outputs out{applied};
  strict.callback({n}, {{ticks, 1}, {ring, 1}}, out, simulator);
  EXPECT_EQ(applied[0], 0.5F);
  EXPECT_EQ(instant().front(), "post act5");
  EXPECT_TRUE(engine.is_safe());
  EXPECT_EQ(count("instants with a bad action"), 1U);
}

struct PatientIo : RealEngineIo {
  struct Config : EngineConfig {
    static constexpr int late = 2;
    static constexpr int recover = 0;
  };
};

TEST_F(RealEngineTest, SeveralLateInstantsMakeSafeUntilTheNextEpisode) {
  HardwareEngine<PatientIo, FakeLink, FakePlatform> patient;
  patient.start(simulator);
  patient.reset({}, simulator);
  FakeClock::late = 6 * kMs;
  patient.callback({1}, simulator);
  EXPECT_FALSE(patient.is_safe()) << "one is borne";
  patient.callback({2}, simulator);
  EXPECT_TRUE(patient.is_safe());
  FakeClock::late = 0;
  for (Seq tick = 3; tick < 100; ++tick) patient.callback({tick}, simulator);
  EXPECT_TRUE(patient.is_safe());
  patient.reset({}, simulator);
  EXPECT_FALSE(patient.is_safe());
}

// A pause of 50 periods is not a single late instant.
TEST_F(RealEngineTest, APauseCountsAsManyLateInstants) {
  HardwareEngine<PatientIo, FakeLink, FakePlatform> patient;
  patient.start(simulator);
  patient.reset({}, simulator);
  patient.callback({1}, simulator);
  FakeClock::now += 1000 * kMs;
  patient.callback({2}, simulator);
  EXPECT_TRUE(patient.is_safe());
  patient.reset({}, simulator);
  FakeClock::late = 1000 * kMs;
  patient.callback({1}, simulator);
  EXPECT_TRUE(patient.is_safe()) << "in its sleep";
}

TEST_F(RealEngineTest, NothingIsSentBeforeTheFirstActuatorIsReset) {
  engine.reset({}, simulator);
  EXPECT_EQ(FakeLink::sent, (Lines{"run measure"}));
}

TEST_F(RealEngineTest, EndsSafe) {
  begin();
  instant();
  FakeLink::sent.clear();
  engine.stop(simulator);
  EXPECT_EQ(FakeLink::sent, (Lines{"post act5", "close"}));
  EXPECT_EQ(count("ends without a safe action"), 0U);
  FakeLink::post_result = BusError::link_lost;
  engine.stop(simulator);
  EXPECT_EQ(count("ends without a safe action"), 1U);
}

TEST_F(RealEngineTest, EndsSafeWhenTheLinkComesBack) {
  begin();
  instant();
  FakeLink::sent.clear();
  FakeLink::post_errors = 20;
  engine.stop(simulator);
  EXPECT_EQ(FakeLink::sent.size(), 22U);
  EXPECT_EQ(FakeLink::sent.back(), "close");
  EXPECT_EQ(count("ends without a safe action"), 0U);
}

TEST_F(RealEngineTest, SilenceBetweenTwoInstantsMakesSafe) {
  begin();
  instant();
  FakeLink::sent.clear();
  engine.make_safe(simulator);
  EXPECT_EQ(FakeLink::sent, (Lines{"post act5"}));
  EXPECT_TRUE(engine.is_safe());
  EXPECT_EQ(instant(), (Lines{"post act5", "run measure"}));
  EXPECT_EQ(instant(), (Lines{"post act5", "run measure"}));
  EXPECT_FALSE(engine.is_safe()) << "two instants were right";
  EXPECT_EQ(count("safe actions between instants"), 1U);
}

TEST_F(RealEngineTest, NoHardwareAtTheStart) {
  FakePlatform::opens = false;
  engine.start(simulator);
  EXPECT_EQ(count("starts without hardware"), 0U) << "it is started once";
  engine = {};
  engine.start(simulator);
  EXPECT_EQ(count("starts without hardware"), 1U);
}

/// A simulator whose model has three sensors, as far as RealOutput sees it.
struct ThreeSensors {
  using Real = float;
  struct Model {
    static constexpr std::size_t kSensors = 3;
  };
  std::array<std::array<float, 2>, 3> limits{};
  void limit_sensor(std::size_t i, float low, float high) { limits.at(i) = {low, high}; }
  static float value(std::size_t i) { return 10.0F + static_cast<float>(i); }
};
struct OutputIo : SensorIo {
  using Simulator = ThreeSensors;
  struct Config {
    static constexpr int index = 1;
    static constexpr std::array<double, 2> low = {-1.0, -2.0};
    static constexpr std::array<double, 2> high = {3.0, 4.0};
  };
  struct Outputs {
    Array<float, 2>& observation;
  };
};
TEST(RealOutput, HasItsSensorsAndTheirLimits) {
  RealOutput<OutputIo> node;
  ThreeSensors simulator;
  node.reset({}, simulator);
  EXPECT_EQ(simulator.limits[0], (std::array<float, 2>{}));
  EXPECT_EQ(simulator.limits[1], (std::array<float, 2>{-1.0F, 3.0F}));
  EXPECT_EQ(simulator.limits[2], (std::array<float, 2>{-2.0F, 4.0F}));
  const std::int64_t ticks[1] = {0};
  Array<float, 2> observation{};
  OutputIo::Outputs out{observation};
  node.callback({1}, {{ticks, 1}}, out, simulator);
  EXPECT_EQ(observation, (Array<float, 2>{{11.0F, 12.0F}}));
}

}  // namespace
}  // namespace eagerx::models::testing

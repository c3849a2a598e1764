// models/engines/real_engine over a link that a test holds in its hands: time, order, safety.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <models/engine_nodes/real_actuator/real_actuator.hpp>
#include <models/engine_nodes/real_sensor/real_sensor.hpp>
#include <models/engine_states/random_action_and_sleep/random_action_and_sleep.hpp>
#include <models/engines/real_engine/hardware_engine.hpp>
#include <models/engines/real_engine/hardware_simulator.hpp>
#include <string>
#include <vector>

#include "tests/unit/models/io.hpp"

namespace eagerx::models::testing {
namespace {

constexpr std::int64_t kMs = 1'000'000;

struct FakeClock {
  static inline std::int64_t now = 0;
  static inline std::int64_t late = 0;  // every sleep ends so much too late
  static std::int64_t now_ns() { return now; }
  static bool sleep_until(std::int64_t ns) {
    now = std::max(now, ns + late);
    return true;
  }
};

/// Keeps what is queued as words, with the time at which it went out.
struct FakeLink {
  using Clock = FakeClock;
  static inline std::vector<std::string> sent;
  static inline std::vector<BusError> results;  // of the next calls of run()
  static inline BusError post_result = BusError::none;
  static inline int post_errors = 0;  // of the next calls of post()
  static inline float measured = 0.0F;
  static inline BusError sensor = BusError::none;
  std::vector<std::string> queue;

  void add(const std::string& word) { queue.push_back(word); }
  BusError run() { return carry_out("run"); }
  BusError post() {
    const BusError error = carry_out("post");
    if (post_errors > 0) return --post_errors, BusError::link_lost;
    return error == BusError::none ? post_result : error;
  }
  void close() { sent.emplace_back("close"); }
  template <class F>
  void for_each_count(F&& /*f*/) const {}

 private:
  BusError carry_out(const char* how) {
    std::string line = how;
    for (const std::string& word : queue) line += " " + word;
    queue.clear();
    sent.push_back(line);
    FakeClock::now += 200'000;
    if (std::string(how) == "post" || results.empty()) return BusError::none;
    const BusError result = results.front();
    results.erase(results.begin());
    return result;
  }
};

struct FakePlatform {
  static inline bool opens = true;
  static void prepare() {}
  static bool open(FakeLink& /*link*/) { return opens; }
};

struct FakeModel {
  using Real = float;
  static constexpr std::size_t kSensors = 1;
  static constexpr std::size_t kActuators = 1;
  void reset() {}
  template <class Bus>
  void request(Bus& bus) {
    bus.add("measure");
  }
  BusError measure(std::int64_t /*now_ns*/, Array<float, 1>& values) {
    if (FakeLink::sensor == BusError::none) values[0] = FakeLink::measured;
    return FakeLink::sensor;
  }
  template <class Bus>
  void act(Bus& bus, const Array<float, 1>& action) {
    bus.add("act" + std::to_string(static_cast<int>(action[0] * 10)));
  }
};

using Simulator = HardwareSimulator<FakeModel, FakeLink>;

struct EngineConfig {
  static constexpr double max_lateness = 0.005;
  static constexpr int late = 1;
  static constexpr int missed = 2;
  static constexpr int recover = 2;
};
struct RealEngineIo {
  using Real = float;
  using Rate = eagerx::Rate<50>;
  using Config = EngineConfig;
  using States = NoStates;
};
using Engine = HardwareEngine<RealEngineIo, FakeLink, FakePlatform>;

struct SensorIo {
  using Real = float;
  using Rate = eagerx::Rate<50>;
  using Simulator = testing::Simulator;
  using States = NoStates;
  struct Config {
    static constexpr int index = 0;
    static constexpr double low = -5.0;
    static constexpr double high = 5.0;
  };
  struct Inputs {
    Latest<std::int64_t> tick;
  };
  struct Outputs {
    float& observation;
  };
};
struct ActuatorIo : SensorIo {
  struct Config {
    static constexpr std::array<double, 1> safe_action = {0.5};
    static constexpr std::array<double, 1> low = {-2.0};
    static constexpr std::array<double, 1> high = {2.0};
    static constexpr auto limits = OutOfLimits::clip;
  };
  struct Inputs {
    Latest<std::int64_t> tick;
    Latest<Array<float, 1>> action;
  };
  struct Outputs {
    Array<float, 1>& action_applied;
  };
};

class RealEngineTest : public ::testing::Test {
 protected:
  void SetUp() override {
    FakeClock::now = 1000 * kMs;
    FakeClock::late = 0;
    FakeLink::sent.clear();
    FakeLink::results.clear();
    FakeLink::post_result = BusError::none;
    FakeLink::post_errors = 0;
    FakeLink::sensor = BusError::none;
    FakeLink::measured = 1.0F;
    FakePlatform::opens = true;
    engine.start(simulator);
  }

  void begin() {
    engine.reset({}, simulator);
    sensor.reset({}, simulator);
    actuator.reset({}, simulator);
    n = 0;
    nodes();
  }
  /// The next instant; what was sent meanwhile.
  std::vector<std::string> instant() {
    FakeLink::sent.clear();
    engine.callback({++n}, simulator);
    nodes();
    return FakeLink::sent;
  }
  void nodes() {
    const Array<float, 1> ring[1] = {{{action}}};
    const std::int64_t ticks[1] = {0};
    SensorIo::Outputs sensor_out{observation};
    sensor.callback({n}, {{ticks, 1}}, sensor_out, simulator);
    ActuatorIo::Outputs actuator_out{applied};
    actuator.callback({n}, {{ticks, 1}, {ring, 1}}, actuator_out, simulator);
  }
  std::uint64_t count(const std::string& wanted) const {
    std::uint64_t result = 0;
    const auto look = [&](const char* name, std::uint64_t value) {
      if (wanted == name) result = value;
    };
    engine.for_each_count(look);
    simulator.for_each_count(look);
    return result;
  }

  Engine engine;
  Simulator simulator;
  RealSensor<SensorIo> sensor;
  RealActuator<ActuatorIo> actuator;
  Seq n = 0;
  float action = 1.0F;
  float observation = 0.0F;
  Array<float, 1> applied{};
};

using Lines = std::vector<std::string>;

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
  EXPECT_EQ(count("safe actions for want of an answer"), 1U);
}

struct PushIo {
  using Real = float;
  using Simulator = testing::Simulator;
  using State = Array<float, 2>;
  struct Config {
    static constexpr std::array<double, 1> low = {-2.0};
    static constexpr std::array<double, 1> high = {2.0};
    static constexpr std::array<double, 1> rest_action = {0.0};
    static constexpr double action_time = 0.5;
    static constexpr double sleep_time = 1.0;
  };
};

TEST_F(RealEngineTest, RandomActionThenRest) {
  const std::int64_t start = FakeClock::now;
  RandomActionAndSleep<PushIo>::reset({{1.0F, 2.0F}}, simulator);
  EXPECT_EQ(FakeClock::now - start, 1500 * kMs);
  ASSERT_EQ(FakeLink::sent.size(), 150U);
  const std::string push = FakeLink::sent[0];
  EXPECT_EQ(push, FakeLink::sent[49]);
  EXPECT_EQ(FakeLink::sent[50], "run act0 measure");
  FakeLink::sent.clear();
  RandomActionAndSleep<PushIo>::reset({{1.0F, 2.0F}}, simulator);
  EXPECT_EQ(push, FakeLink::sent[0]) << "equal values push equally";
  FakeLink::sent.clear();
  RandomActionAndSleep<PushIo>::reset({{1.0F, 2.1F}}, simulator);
  EXPECT_NE(push, FakeLink::sent[0]);
}

TEST_F(RealEngineTest, ErrorsOfTheLinkEndAPushAtOnce) {
  begin();
  FakeLink::sent.clear();
  FakeLink::results = {BusError::none, BusError::timeout};
  RandomActionAndSleep<PushIo>::reset({{1.0F, 2.0F}}, simulator);
  ASSERT_EQ(FakeLink::sent.size(), 3U);
  EXPECT_EQ(FakeLink::sent[2], "post act5");
  EXPECT_EQ(count("safe actions in resets"), 1U);
}

TEST_F(RealEngineTest, SensorsThatSayNothingEndAPush) {
  begin();
  FakeLink::sent.clear();
  FakeLink::sensor = BusError::parity;
  RandomActionAndSleep<PushIo>::reset({{1.0F, 2.0F}}, simulator);
  ASSERT_EQ(FakeLink::sent.size(), 3U) << "one is borne, the second is the last";
  EXPECT_EQ(FakeLink::sent[2], "post act5");
}

TEST_F(RealEngineTest, NoHardwareAtTheStart) {
  FakePlatform::opens = false;
  engine.start(simulator);
  EXPECT_EQ(count("starts without hardware"), 0U) << "it is started once";
  engine = {};
  engine.start(simulator);
  EXPECT_EQ(count("starts without hardware"), 1U);
}

}  // namespace
}  // namespace eagerx::models::testing

// RealEngine with everything around it in the hands of a test: clock, link, model, nodes.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <models/engine_nodes/real_actuator/real_actuator.hpp>
#include <models/engine_nodes/real_output/real_output.hpp>
#include <models/engine_nodes/real_sensor/real_sensor.hpp>
#include <models/engines/real_engine/hardware_engine.hpp>
#include <models/engines/real_engine/hardware_simulator.hpp>
#include <string>
#include <vector>

#include "tests/unit/models/io.hpp"

namespace eagerx::models::testing {
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

}  // namespace eagerx::models::testing

// Identification of a mass on a rail, with an accelerometer, which reads the input.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "runtime/host/identify/identification.hpp"

namespace eagerx::identification {
namespace {

constexpr double kMass = 1.3, kFriction = 0.4;
constexpr std::uint64_t kEngineHz = 100;
constexpr Seq kTicks = 400;
constexpr std::array<Channel, 4> kChannels{{
    {"cart/acceleration/y", "float64", 1, kEngineHz, 1, Publisher::engine_node},
    {"cart/force/action_applied", "float64", 1, 50, 1, Publisher::engine_node},
    {"cart/speed/y", "float64", 1, kEngineHz, 1, Publisher::engine_node},
    {"engine/tick", "int64", 1, kEngineHz, 1, Publisher::engine},
}};

/// The order of a generated program in a slot: engine, accelerometer, actuator, other sensors.
class Cart {
 public:
  double mass = 0.0, friction = 0.0;

  void run(const std::function<double(Seq)>& force, Experiment* experiment,
           const std::function<void(std::uint32_t, Seq, double&)>& message) {
    input_ = {0.0};
    state_ = {0.0};
    for (Seq tick = 0; tick < kTicks; ++tick) {
      if (tick > 0) {
        if (experiment != nullptr) experiment->engine_runs();
        advance();
      }
      if (experiment != nullptr) {
        const SimulatorView view{{nullptr, state_.data(), 1}, {nullptr, input_.data(), 1}};
        experiment->simulator("cart", tick, view);
      }
      double acceleration = derivative(state_[0]);
      message(0, tick, acceleration);
      if (tick % 2 == 0) {
        double applied = force(tick);
        input_[0] = applied;
        message(1, tick / 2, applied);
      }
      double speed = state_[0];
      message(2, tick, speed);
    }
  }

 private:
  double derivative(double speed) const { return (input_[0] - friction * speed) / mass; }
  void advance() {
    constexpr double kStep_s = 1.0 / static_cast<double>(kEngineHz);
    const double k1 = derivative(state_[0]);
    const double k2 = derivative(state_[0] + kStep_s / 2 * k1);
    const double k3 = derivative(state_[0] + kStep_s / 2 * k2);
    const double k4 = derivative(state_[0] + kStep_s * k3);
    state_[0] += kStep_s / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  std::array<double, 1> state_{}, input_{};
};

double steps_of_force(Seq tick) {
  return static_cast<double>((tick / 2 * 7) % 11) - 4.0;
}

/// Of a cart whose force comes `late` ticks of the engine after what the log says.
trace_log::Log log_of_cart(Seq late) {
  trace_log::Log log;
  log.engine = "OdeEngine";
  log.complete = true;
  for (const Channel& channel : kChannels)
    log.channels.push_back({channel.name,
                            channel.publisher == Publisher::engine ? trace_log::Dtype::int64
                                                                   : trace_log::Dtype::float64,
                            1, channel.rate_num, 1});
  Cart cart;
  cart.mass = kMass;
  cart.friction = kFriction;
  const auto force = [&](Seq tick) { return tick < late ? 0.0 : steps_of_force(tick - late); };
  cart.run(force, nullptr, [&](std::uint32_t channel, Seq seq, double& value) {
    trace_log::Row row;
    row.first = log.values.size();
    row.seq = seq;
    row.channel = channel;
    log.rows.push_back(row);
    const double said = channel == 1 ? steps_of_force(2 * seq) : value;
    log.values.push_back(std::bit_cast<std::uint64_t>(said));
  });
  return log;
}

struct Found {
  double mass = 0.0, friction = 0.0, delay_s = 0.0;
  bool is_inside = false;  // all three within three deviations
};

Found identify(const trace_log::Log& log, const std::string& sensors, double delay_s) {
  Experiment experiment;
  std::string problem;
  EXPECT_TRUE(experiment.prepare(log, {kChannels, "OdeEngine", 50, 1}, sensors, 0.5, problem));
  std::vector<Parameter> parameters{{"cart.mass", 0, 1, true, 0.8, 2.0},
                                    {"cart.friction", 0, 1, true, 0.1, 1.0}};
  Cart cart;
  const auto run = [&](const Trial* trial) -> const std::vector<double>& {
    cart.mass = trial != nullptr ? trial->parameters[0] : 1.4;
    cart.friction = trial != nullptr ? trial->parameters[1] : 0.55;
    experiment.begin(trial);
    experiment.episode(0);
    cart.run(steps_of_force, &experiment, [&](std::uint32_t channel, Seq seq, double& value) {
      experiment.message(channel, seq, &value, 1);
    });
    return experiment.residuals();
  };
  run(nullptr);
  experiment.find_actuators();
  run(nullptr);
  Identification identification(
      experiment, parameters, [&](const Trial& trial) -> const auto& { return run(&trial); });
  EXPECT_TRUE(identification.find(1.0 / kEngineHz, 0.05, problem)) << problem;
  const Delay delay = identification.delays().at(0);
  const auto is_near = [](double value, double truth, double deviation) {
    return std::abs(value - truth) <= 3 * deviation + 1e-9;
  };
  return {parameters[0].value, parameters[1].value, delay.value_s,
          is_near(parameters[0].value, kMass, parameters[0].deviation) &&
              is_near(parameters[1].value, kFriction, parameters[1].deviation) &&
              is_near(delay.value_s, delay_s, delay.deviation_s)};
}

TEST(Identify, ASensorThatReadsTheInput) {
  for (const char* sensors : {"cart/acceleration/y", "cart/speed/y", ""}) {
    const Found found = identify(log_of_cart(0), sensors, 0.0);
    EXPECT_NEAR(found.mass, kMass, 1e-5) << sensors;
    EXPECT_NEAR(found.friction, kFriction, 1e-4) << sensors;
    EXPECT_NEAR(found.delay_s, 0.0, 1e-6) << sensors;
  }
}

TEST(Identify, ASensorThatReadsALateInput) {
  const Found found = identify(log_of_cart(2), "", 0.02);
  EXPECT_NEAR(found.mass, kMass, 1e-4);
  EXPECT_NEAR(found.friction, kFriction, 1e-3);
  EXPECT_NEAR(found.delay_s, 0.02, 1e-5);
}

/// A pendulum with friction, an accelerometer and a gyroscope at 100 Hz: [angle, speed].
class Swing {
 public:
  static constexpr std::uint64_t kHz = 200;
  static constexpr Seq kSwingTicks = 2000;
  double mass = 1.0, friction = 0.5, stiffness = 4.0;
  std::array<double, 2> state{};
  Seq late = 0;  // ticks from a message of the actuator to its force

  void run(const std::vector<double>& force, Experiment* experiment,
           const std::function<void(std::uint32_t, Seq, double&)>& message) {
    input_ = {0.0};
    for (Seq tick = 0; tick < kSwingTicks; ++tick) {
      if (tick > 0) {
        if (experiment != nullptr) experiment->engine_runs();
        advance();
      }
      if (experiment != nullptr) {
        const SimulatorView view{{nullptr, state.data(), 2}, {nullptr, input_.data(), 1}};
        experiment->simulator("cart", tick, view);
      }
      if (tick % 2 == 0) {
        double acceleration = derivative(state)[1];
        message(0, tick / 2, acceleration);
        double speed = state[1];
        message(2, tick / 2, speed);
      }
      if (tick >= late && (tick - late) % 4 == 0) input_[0] = force[(tick - late) / 4];
      if (tick % 4 != 0) continue;
      double applied = force[tick / 4];
      message(1, tick / 4, applied);
    }
  }

 private:
  std::array<double, 2> derivative(std::array<double, 2> x) const {
    return {x[1], (input_[0] - friction * x[1] - stiffness * std::sin(x[0])) / mass};
  }
  void advance() {  // Heun's method
    constexpr double kStep_s = 1.0 / static_cast<double>(kHz);
    const auto a = derivative(state);
    const auto b = derivative({state[0] + kStep_s * a[0], state[1] + kStep_s * a[1]});
    for (std::size_t i = 0; i < 2; ++i) state[i] += kStep_s / 2 * (a[i] + b[i]);
  }
  std::array<double, 1> input_{};
};

struct FoundSwing {
  Swing truth;
  std::vector<Parameter> parameters;
  Delay delay;
};

/// What is found of a swing that is sampled. `noise`: standard deviation of the accelerometer.
FoundSwing identify_swing(unsigned seed, Seq late, double noise, const std::string& sensors) {
  constexpr std::array<Channel, 4> kOfSwing{{
      {"cart/acceleration/y", "float64", 1, 100, 1, Publisher::engine_node},
      {"cart/force/action_applied", "float64", 1, 50, 1, Publisher::engine_node},
      {"cart/speed/y", "float64", 1, 100, 1, Publisher::engine_node},
      {"engine/tick", "int64", 1, Swing::kHz, 1, Publisher::engine},
  }};
  std::mt19937 bits(seed);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(bits()) / 4294967296.0;
  };
  std::vector<double> force(Swing::kSwingTicks / 4);
  FoundSwing found;
  found.truth.stiffness = uniform(3.0, 8.0);
  found.truth.state = {uniform(-0.5, 0.5), uniform(-0.5, 0.5)};
  found.truth.late = late;
  for (double& each : force) each = uniform(-5.0, 5.0);
  trace_log::Log log;
  log.engine = "OdeEngine";
  log.complete = true;
  for (const Channel& channel : kOfSwing)
    log.channels.push_back({channel.name,
                            channel.publisher == Publisher::engine ? trace_log::Dtype::int64
                                                                   : trace_log::Dtype::float64,
                            1, channel.rate_num, 1});
  Swing(found.truth).run(force, nullptr, [&](std::uint32_t channel, Seq seq, double& value) {
    trace_log::Row row;
    row.first = log.values.size();
    row.seq = seq;
    row.channel = channel;
    log.rows.push_back(row);
    double more = -6.0;  // of twelve uniform numbers: nearly normal, with a deviation of 1
    for (int i = 0; i < 12 && channel != 2; ++i) more += uniform(0.0, 1.0);
    log.values.push_back(std::bit_cast<std::uint64_t>(value + (channel == 0 ? noise * more : 0.0)));
  });
  Experiment experiment;
  std::string problem;
  EXPECT_TRUE(experiment.prepare(log, {kOfSwing, "OdeEngine", 50, 1}, sensors, 0.5, problem));
  found.parameters = {{"cart.mass", 0, 1, true, 0.7, 1.7},
                      {"cart.friction", 0, 1, true, 0.1, 1.0},
                      {"cart.stiffness", 0, 1, true, 2.0, 9.0}};
  Swing swing;
  const auto run = [&](const Trial* trial) -> const std::vector<double>& {
    swing.mass = trial != nullptr ? trial->parameters[0] : 1.2;
    swing.friction = trial != nullptr ? trial->parameters[1] : 0.55;
    swing.stiffness = trial != nullptr ? trial->parameters[2] : 5.5;
    swing.state = {0.3, 0.3};
    experiment.begin(trial);
    experiment.episode(0);
    swing.run(force, &experiment, [&](std::uint32_t channel, Seq seq, double& value) {
      experiment.message(channel, seq, &value, 1);
    });
    return experiment.residuals();
  };
  run(nullptr);
  experiment.find_actuators();
  run(nullptr);
  Identification identification(
      experiment, found.parameters, [&](const Trial& trial) -> const auto& { return run(&trial); });
  EXPECT_TRUE(identification.find(1.0 / Swing::kHz, 0.1, problem)) << problem;
  found.delay = identification.delays().at(0);
  return found;
}

/// The angle and its supplement give the same acceleration: each piece of the log has several
/// minima, and a band around a wrong one does not have the truth in it.
TEST(Identify, FirstStatesWithSeveralMinima) {
  for (const unsigned seed : {1U, 3U}) {
    const auto [truth, parameters, delay] = identify_swing(seed, 0, 0.1, "cart/acceleration/y");
    const std::array<double, 3> known{truth.mass, truth.friction, truth.stiffness};
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(parameters[i].value, known[i], 3 * parameters[i].deviation) << seed << " " << i;
      EXPECT_LT(parameters[i].deviation, (parameters[i].high - parameters[i].low) / 4) << seed;
    }
    // The accelerometer sees an input two ticks later, so a delay below that is no other one.
    EXPECT_LE(delay.value_s, 2.5 / Swing::kHz) << seed;
    EXPECT_LE(delay.value_s, 3 * delay.deviation_s) << seed;
  }
}

/// Below two ticks the accelerometer reads a force that it has not read, and above them only the
/// motion differs: a difference over both sides is the slope of neither.
TEST(Identify, ADelayNextToAWall) {
  for (const unsigned seed : {1U, 2U}) {
    const FoundSwing found = identify_swing(seed, 2, 0.0, "");
    EXPECT_NEAR(found.delay.value_s, 2.0 / Swing::kHz, 5e-6) << seed;
    EXPECT_NEAR(found.parameters[2].value, found.truth.stiffness, 1e-3) << seed;
  }
}

/// Without actions the messages say how many steps there were.
TEST(Identify, StepsOfAGraphWithoutActions) {
  Experiment experiment;
  std::string problem;
  const trace_log::Log log = log_of_cart(0);
  ASSERT_TRUE(experiment.prepare(log, {kChannels, "OdeEngine", 50, 1}, "", 0.5, problem));
  EXPECT_EQ(experiment.steps(0), 200U);
}

/// x' = -rate·x, seen by a sensor, without an input.
class Decay {
 public:
  static constexpr std::array<Channel, 2> kDecayChannels{{
      {"cart/speed/y", "float64", 1, kEngineHz, 1, Publisher::engine_node},
      {"engine/tick", "int64", 1, kEngineHz, 1, Publisher::engine},
  }};
  double rate_hz = 0.0;

  void run(double start, Experiment* experiment, const std::function<void(Seq, double&)>& message) {
    state_ = {start};
    for (Seq tick = 0; tick < kTicks; ++tick) {
      if (tick > 0) {
        if (experiment != nullptr) experiment->engine_runs();
        state_[0] *= std::exp(-rate_hz / static_cast<double>(kEngineHz));
      }
      if (experiment != nullptr)
        experiment->simulator("cart", tick, {{nullptr, state_.data(), 1}, {nullptr, nullptr, 0}});
      double speed = state_[0];
      message(tick, speed);
    }
  }

 private:
  std::array<double, 1> state_{};
};

/// From rest no value of the parameter changes anything.
TEST(Identify, AnEquationThatRestsWithoutInput) {
  constexpr double kRate_hz = 0.7;
  trace_log::Log log;
  log.engine = "OdeEngine";
  log.complete = true;
  log.channels = {{"cart/speed/y", trace_log::Dtype::float64, 1, kEngineHz, 1},
                  {"engine/tick", trace_log::Dtype::int64, 1, kEngineHz, 1}};
  Decay decay;
  decay.rate_hz = kRate_hz;
  decay.run(2.0, nullptr, [&](Seq seq, double& value) {
    trace_log::Row row;
    row.first = log.values.size();
    row.seq = seq;
    log.rows.push_back(row);
    log.values.push_back(std::bit_cast<std::uint64_t>(value));
  });

  Experiment experiment;
  std::string problem;
  ASSERT_TRUE(
      experiment.prepare(log, {Decay::kDecayChannels, "OdeEngine", 50, 1}, "", 0.5, problem));
  std::vector<Parameter> parameters{{"cart.rate", 0, 1, true, 0.2, 2.0}};
  const auto run = [&](const Trial* trial) -> const std::vector<double>& {
    decay.rate_hz = trial != nullptr ? trial->parameters[0] : 1.0;
    experiment.begin(trial);
    experiment.episode(0);
    decay.run(0.0, &experiment,
              [&](Seq seq, double& value) { experiment.message(0, seq, &value, 1); });
    return experiment.residuals();
  };
  run(nullptr);
  experiment.find_actuators();
  run(nullptr);
  Identification identification(
      experiment, parameters, [&](const Trial& trial) -> const auto& { return run(&trial); });
  ASSERT_TRUE(identification.find(1.0 / static_cast<double>(kEngineHz), 0.1, problem)) << problem;
  EXPECT_TRUE(parameters[0].matters);
  EXPECT_NEAR(parameters[0].value, kRate_hz, 1e-6);
}

/// The YAML is pasted into a graph, where the states of a composite's objects are `body.mass`
/// below the composite.
TEST(Identify, StatesOfCompositesAreWrittenAsGraphsHaveThem) {
  Experiment experiment;
  std::vector<Parameter> parameters{{"cart.mass", 0, 1, true, 0.8, 2.0, true, 1.3, 0.1},
                                    {"robot/body.mass", 0, 2, false, 1.0, 3.0, true, 2.0, 0.125},
                                    {"robot/body.mass", 1, 2, false, 5.0, 5.0},
                                    {"robot/arm/hand.grip", 0, 1, true, 0.0, 1.0, true, 0.5, 0.25}};
  const Identification identification(
      experiment, parameters, [](const Trial&) -> const std::vector<double>& { std::abort(); });
  trace_log::Log log;
  log.path = "run.log";
  EXPECT_EQ(identification.yaml(log, kChannels),
            "# From run.log by `eagerx-gen identify`: values +- 3 standard deviations.\n"
            "objects:\n"
            "  cart:\n"
            "    states:\n"
            "      mass: {space: {low: 1, high: 1.6}, uniform: space}\n"
            "  robot:\n"
            "    states:\n"
            "      body.mass: {space: {low: [1.625, 5], high: [2.375, 5]}, uniform: space}\n"
            "      arm.hand.grip: {space: {low: 0, high: 1}, uniform: space}\n");
}

}  // namespace
}  // namespace eagerx::identification

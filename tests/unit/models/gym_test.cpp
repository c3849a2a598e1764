#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <models/engine_nodes/action_actuator/action_actuator.hpp>
#include <models/engine_nodes/observation_sensor/observation_sensor.hpp>
#include <models/engine_nodes/reward_sensor/reward_sensor.hpp>
#include <models/engine_nodes/terminated_sensor/terminated_sensor.hpp>
#include <models/engine_nodes/truncated_sensor/truncated_sensor.hpp>
#include <models/engine_states/gym_state/gym_state.hpp>
#include <models/engine_states/set_gym_attribute/set_gym_attribute.hpp>
#include <models/engines/gym_engine/gym_engine.hpp>

#include "tests/unit/models/gym_io.hpp"

namespace eagerx::models::testing {
namespace {

using GymModel = GymPendulum<PendulumModelIo<double>>;

/// One step of Pendulum-v1 as Gymnasium writes it.
struct Reference {
  double th, thdot;
  double step(double u, double m, double l, double max_speed) {
    u = std::clamp(u, -2.0, 2.0);
    const double two_pi = 2.0 * M_PI;
    double wrapped = std::fmod(th + M_PI, two_pi);
    if (wrapped < 0.0) wrapped += two_pi;
    wrapped -= M_PI;
    const double cost = wrapped * wrapped + 0.1 * thdot * thdot + 0.001 * u * u;
    const double faster =
        thdot + (3.0 * 10.0 / (2.0 * l) * std::sin(th) + 3.0 / (m * l * l) * u) * 0.05;
    thdot = std::clamp(faster, -max_speed, max_speed);
    th += thdot * 0.05;
    return -cost;
  }
};

TEST(GymPendulum, StepsAsGymnasiumDoes) {
  auto attributes = GymModel::default_attributes();
  for (const double mass : {1.0, 0.04}) {
    for (const double length : {1.0, 0.12}) {
      attributes[GymModel::kMass] = mass;
      attributes[GymModel::kLength] = length;
      attributes[GymModel::kMaxSpeed] = mass < 1.0 ? 22.0 : 8.0;
      Array<double, 2> state{{3.0, -0.7}};
      Reference expected{3.0, -0.7};
      for (int i = 0; i < 400; ++i) {
        const double u = 3.0 * std::sin(0.11 * i);  // beyond the largest torque, too
        const auto outcome = GymModel::step(state, {{u}}, attributes);
        const double reward = expected.step(u, mass, length, attributes[GymModel::kMaxSpeed]);
        ASSERT_NEAR(outcome.reward, reward, 1e-11 * (1.0 - reward)) << i;
        ASSERT_NEAR(state[0], expected.th, 1e-11) << i;
        ASSERT_NEAR(state[1], expected.thdot, 1e-11) << i;
        EXPECT_FALSE(outcome.terminated || outcome.truncated);
        expected = {state[0], state[1]};  // rounding must not add up
      }
    }
  }
}

TEST(GymPendulum, ObservesAPointOnTheCircle) {
  const auto observation = GymModel::observe({{0.5, -3.0}});
  EXPECT_NEAR(observation[0], std::cos(0.5), 1e-15);
  EXPECT_NEAR(observation[1], std::sin(0.5), 1e-15);
  EXPECT_EQ(observation[2], -3.0);
}

template <class Real>
class GymNodes : public ::testing::Test {
 protected:
  using Simulator = GymPendulumSimulator<Real>;
  GymNodes() { simulator_.reset(); }
  void step() { GymEngine<EngineIo<Real>>().callback({1}, simulator_); }
  Simulator simulator_;
  std::int64_t tick_ = 0;

  float reward() {
    using Io = RewardSensorIo<Simulator>;
    float result = 9.0F;
    typename Io::Outputs out{result};
    RewardSensor<Io>().callback({0}, {{&tick_, 1, 1}}, out, simulator_);
    return result;
  }
  /// Both sensors.
  std::array<std::int64_t, 2> flags() {
    using Io = FlagSensorIo<Simulator>;
    std::int64_t terminated = 9, truncated = 9;
    typename Io::Outputs out{terminated, truncated};
    TerminatedSensor<Io>().callback({0}, {{&tick_, 1, 1}}, out, simulator_);
    TruncatedSensor<Io>().callback({0}, {{&tick_, 1, 1}}, out, simulator_);
    return {terminated, truncated};
  }
};
using Reals = ::testing::Types<float, double>;
TYPED_TEST_SUITE(GymNodes, Reals);

TYPED_TEST(GymNodes, ObservationIsThatOfThePresentState) {
  using Io = ObservationSensorIo<GymPendulumSimulator<TypeParam>>;
  Array<float, 3> observation{};
  typename Io::Outputs out{observation};
  ObservationSensor<Io> node;
  node.callback({0}, {{&this->tick_, 1, 1}}, out, this->simulator_);
  EXPECT_NEAR(observation[0], -1.0F, 1e-6);
  EXPECT_NEAR(observation[1], 0.0F, 1e-6);
  this->simulator_.next_action = {{TypeParam(2)}};
  this->step();
  node.callback({1}, {{&this->tick_, 1, 1}}, out, this->simulator_);
  EXPECT_NEAR(observation[2], 0.3F, 1e-6);  // 3·u·dt
}

TYPED_TEST(GymNodes, RewardIsTheSumSinceTheLastTickOrTheLastOne) {
  EXPECT_EQ(this->reward(), 0.0F);
  std::array<float, 3> single{};
  auto copy = this->simulator_;
  for (float& each : single) {
    copy.step();
    each = static_cast<float>(copy.take_reward());
    EXPECT_LT(each, -9.0F);  // hanging down costs π² a step
  }
  this->step();
  EXPECT_EQ(this->reward(), single[0]);
  EXPECT_EQ(this->reward(), single[0]);
  this->step();
  this->step();
  EXPECT_NEAR(this->reward(), single[1] + single[2], 1e-5);
  EXPECT_EQ(this->reward(), single[2]);
}

TYPED_TEST(GymNodes, IsTruncatedFromStep200OnUntilTheReset) {
  for (int i = 0; i < 199; ++i) this->step();
  EXPECT_EQ(this->flags(), (std::array<std::int64_t, 2>{0, 0}));
  this->step();
  EXPECT_EQ(this->flags(), (std::array<std::int64_t, 2>{0, 1}));
  this->step();
  EXPECT_EQ(this->flags(), (std::array<std::int64_t, 2>{0, 1}));
  using Io = FlagSensorIo<GymPendulumSimulator<TypeParam>>;
  TruncatedSensor<Io>().reset({}, this->simulator_);  // a new episode, the same state
  EXPECT_EQ(this->flags(), (std::array<std::int64_t, 2>{0, 0}));
  EXPECT_NE(this->simulator_.state[0], TypeParam(0));
}

TYPED_TEST(GymNodes, ActuatorSetsTheActionOfTheNextStep) {
  using Io = ActionActuatorIo<GymPendulumSimulator<TypeParam>>;
  ActionActuator<Io> node;
  node.reset({}, this->simulator_);
  EXPECT_EQ(this->simulator_.next_action[0], TypeParam(0.25));
  const Voltage action{{1.5F}};
  Voltage applied{};
  typename Io::Outputs out{applied};
  node.callback({0}, {{&this->tick_, 1, 1}, {&action, 1, 1}}, out, this->simulator_);
  EXPECT_EQ(this->simulator_.next_action[0], TypeParam(1.5));
  EXPECT_EQ(applied, action);
}

TYPED_TEST(GymNodes, ActuatorFallsBackToItsZeroAction) {
  using Io = ActionActuatorIo<GymPendulumSimulator<TypeParam>, Skipped>;
  ActionActuator<Io> node;
  const Voltage unused{{1.5F}};
  Voltage applied{};
  typename Io::Outputs out{applied};
  node.callback({0}, {{&this->tick_, 1, 1}, {&unused, 0, 0}}, out, this->simulator_);
  EXPECT_EQ(this->simulator_.next_action[0], TypeParam(0.25));
  EXPECT_EQ(applied[0], 0.25F);
}

TYPED_TEST(GymNodes, StatesSetAttributesAndTheStateUntilTheNextReset) {
  using Pendulum = GymPendulumSimulator<TypeParam>;
  SetGymAttribute<MassIo<Pendulum>>::reset(0.5F, this->simulator_);
  EXPECT_EQ(this->simulator_.attributes[1], TypeParam(0.5));
  EXPECT_EQ(this->simulator_.attributes[2], TypeParam(1));
  GymState<MirroredStateIo<Pendulum>>::reset({{0.25F, -2.0F}}, this->simulator_);
  EXPECT_EQ(this->simulator_.state, (Array<TypeParam, 2>{{TypeParam(-0.25), TypeParam(2)}}));
  this->simulator_.reset();
  EXPECT_EQ(this->simulator_.attributes[1], TypeParam(1));
}

/// An environment that ends by itself: what GymEngine asks of a model is not the pendulum's alone.
struct Countdown {
  using Real = float;
  static constexpr std::size_t kStates = 1;
  static constexpr std::size_t kActions = 1;
  static constexpr std::size_t kObservations = 1;
  static constexpr std::size_t kAttributes = 1;
  static constexpr std::uint32_t kMaxSteps = 0;
  static constexpr std::array<const char*, 1> kAttributeNames = {"start"};
  static constexpr Array<float, 1> initial_state() { return {{3.0F}}; }
  static constexpr Array<float, 1> default_attributes() { return {{3.0F}}; }
  static constexpr GymOutcome<float> step(Array<float, 1>& state, const Array<float, 1>& action,
                                          const Array<float, 1>& /*attributes*/) {
    state[0] -= action[0];
    return {.reward = 1.0F, .terminated = state[0] == 0.0F};
  }
  static constexpr Array<float, 1> observe(const Array<float, 1>& state) { return state; }
};

TEST(GymSimulator, StaysTerminated) {
  GymSimulator<Countdown> simulator;
  simulator.reset();
  simulator.next_action = {{1.0F}};
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(simulator.terminated, i >= 3);
    simulator.step();
  }
  EXPECT_TRUE(simulator.terminated);
  EXPECT_FALSE(simulator.truncated);
  EXPECT_EQ(simulator.take_reward(), 5.0F);
}

}  // namespace
}  // namespace eagerx::models::testing

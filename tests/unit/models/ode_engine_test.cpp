#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "tests/unit/models/csv.hpp"
#include "tests/unit/models/io.hpp"

namespace eagerx::models::testing {
namespace {

using Double = PendulumSimulator<double>;
using Float = PendulumSimulator<float>;
using Dopri5Io = EngineIo<double>;

template <class Simulator>
Simulator pendulum(double theta, double omega, double voltage) {
  using Real = typename Simulator::Real;
  Simulator simulator;
  simulator.reset();
  simulator.state = {{static_cast<Real>(theta), static_cast<Real>(omega)}};
  simulator.input = {{static_cast<Real>(voltage)}};
  return simulator;
}

/// Starting points [rad, rad/s, V]: at rest, swinging through the friction's kink, fast, upright.
constexpr std::array<std::array<double, 3>, 5> kStarts = {
    {{3.14, 0.0, 0.0}, {2.8, 0.5, 1.7}, {-1.0, 9.0, -2.0}, {0.01, 0.0, 0.3}, {1.5, -0.02, 2.0}}};

/// dx/dt = λ·x + u with λ = parameter, solved exactly below. Without Coefficients.
template <class RealType>
struct Decay {
  using Real = RealType;
  static constexpr std::size_t kStates = 1;
  static constexpr std::size_t kInputs = 1;
  static constexpr std::size_t kParameters = 1;
  using Vector = Array<Real, 1>;
  static constexpr Vector default_parameters() { return {{Real(-3)}}; }
  static constexpr Vector derivative(const Vector& p, const Vector& u, const Vector& x) {
    return {{p[0] * x[0] + u[0]}};
  }
};

TEST(OdeSimulator, IsZeroBytesBeforeAndDefaultsAfterReset) {
  static constinit Double simulator;
  for (const double value : simulator.state) EXPECT_EQ(value, 0.0);
  for (const double value : simulator.parameters) EXPECT_EQ(value, 0.0);
  simulator.state = {{1.0, 2.0}};
  simulator.input = {{3.0}};
  simulator.step_s = 4.0;
  simulator.add_fault_if(true);
  simulator.reset();
  EXPECT_EQ(simulator.state, (Array<double, 2>{}));
  EXPECT_EQ(simulator.input, (Array<double, 1>{}));
  EXPECT_EQ(simulator.step_s, 0.0);
  EXPECT_EQ(simulator.parameters[5], 7.73125142447252);
  EXPECT_EQ(simulator.faults(), 1U);
}

TEST(OdeEngine, Dopri5FollowsRk4WithManySubsteps) {
  double worst = 0.0;
  for (const auto& [theta, omega, voltage] : kStarts) {
    auto adaptive = pendulum<Double>(theta, omega, voltage);
    auto exact = adaptive;
    for (int i = 0; i < 30; ++i) {
      tick<Dopri5Io>(adaptive);
      tick<EngineIo<double, Rk4Config<5000>>>(exact);
      worst = std::max(worst, std::abs(adaptive.state[0] - exact.state[0]));
    }
    EXPECT_EQ(adaptive.faults(), 0U);
  }
  RecordProperty("largest_angle_error_rad", std::to_string(worst * 1e9) + "e-9");
  EXPECT_LT(worst, 1e-6);
}

TEST(OdeEngine, Dopri5FollowsTheRecordedRunOfEagerx) {
  double worst_angle = 0.0;
  double worst_speed = 0.0;
  Double simulator;
  int ticks = 0;
  for (const Row& row : read_csv("p01_sim.csv")) {
    const double theta = std::stod(row[2]);
    const double omega = std::stod(row[3]);
    const double voltage = std::stod(row[4]);
    if (row[1] == "0") {
      simulator = pendulum<Double>(theta, omega, voltage);
      continue;
    }
    simulator.input = {{voltage}};
    tick<Dopri5Io>(simulator);
    worst_angle = std::max(worst_angle, std::abs(simulator.state[0] - theta));
    worst_speed = std::max(worst_speed, std::abs(simulator.state[1] - omega));
    ++ticks;
  }
  EXPECT_EQ(ticks, 160);
  EXPECT_EQ(simulator.faults(), 0U);
  RecordProperty("largest_angle_error_rad", std::to_string(worst_angle * 1e9) + "e-9");
  RecordProperty("largest_speed_error_rad_s", std::to_string(worst_speed * 1e9) + "e-9");
  EXPECT_LT(worst_angle, 1e-6);
  EXPECT_LT(worst_speed, 1e-5);
}

TEST(OdeEngine, Dopri5KeepsTheStepFromTickToTick) {
  auto simulator = pendulum<Double>(1.5, -0.02, 2.0);
  tick<Dopri5Io>(simulator);
  EXPECT_GT(simulator.step_s, 0.0);
  EXPECT_LE(simulator.step_s, 1.0 / 30.0);
}

template <int Substeps>
double decay_error_rk4() {
  using Simulator = OdeSimulator<Decay<double>>;
  Simulator simulator;
  simulator.reset();
  simulator.state = {{2.0}};
  simulator.input = {{1.5}};
  tick<EngineIo<double, Rk4Config<Substeps>, eagerx::Rate<1>>>(simulator);
  const double exact = 0.5 + 1.5 * std::exp(-3.0);
  return std::abs(simulator.state[0] - exact);
}

TEST(OdeEngine, Rk4IsOfFourthOrder) {
  const double coarse = decay_error_rk4<32>();
  const double fine = decay_error_rk4<64>();
  EXPECT_GT(coarse, 1e-8);
  EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.1);
}

template <int Substeps>
double pendulum_error_rk4() {
  auto simulator = pendulum<Double>(-1.0, 9.0, -2.0);  // away from the kink of the friction
  auto exact = simulator;
  tick<EngineIo<double, Rk4Config<Substeps>>>(simulator);
  tick<EngineIo<double, Rk4Config<5000>>>(exact);
  return std::abs(simulator.state[0] - exact.state[0]);
}

TEST(OdeEngine, Rk4IsOfFourthOrderOnThePendulum) {
  EXPECT_NEAR(std::log2(pendulum_error_rk4<8>() / pendulum_error_rk4<16>()), 4.0, 0.2);
}

template <class Real, class Config = OdeConfig>
Real decay(double rate_of_decay) {
  using Simulator = OdeSimulator<Decay<Real>>;
  Simulator simulator;
  simulator.reset();
  simulator.parameters = {{static_cast<Real>(rate_of_decay)}};
  simulator.state = {{Real(1)}};
  tick<EngineIo<Real, Config, eagerx::Rate<1>>>(simulator);
  EXPECT_EQ(simulator.faults(), 0U);
  return simulator.state[0];
}

template <int Exponent>
struct Tolerance : OdeConfig {
  static constexpr double rtol = Exponent == 4 ? 1e-4 : Exponent == 8 ? 1e-8 : 1e-12;
  static constexpr double atol = rtol;
  static constexpr int mxstep = 100000;
};

TEST(OdeEngine, Dopri5ErrorFollowsTheTolerance) {
  const double exact = std::exp(-5.0);
  EXPECT_LT(std::abs(decay<double, Tolerance<4>>(-5.0) - exact), 1e-4);
  EXPECT_GT(std::abs(decay<double, Tolerance<4>>(-5.0) - exact), 1e-9);  // no more work than asked
  EXPECT_LT(std::abs(decay<double, Tolerance<8>>(-5.0) - exact), 1e-8);
  EXPECT_LT(std::abs(decay<double, Tolerance<12>>(-5.0) - exact), 1e-12);
}

struct NoTolerance : OdeConfig {
  static constexpr double rtol = 0.0;
  static constexpr double atol = 0.0;
};

TEST(OdeEngine, TolerancesBelowTheResolutionAreRaised) {
  EXPECT_NEAR((decay<float, NoTolerance>(-5.0)), std::exp(-5.0), 1e-6);
  EXPECT_NEAR(decay<float>(-5.0), std::exp(-5.0), 1e-6);
  auto simulator = pendulum<Float>(2.8, 0.5, 1.7);
  auto exact = pendulum<Double>(2.8, 0.5, 1.7);
  for (int i = 0; i < 300; ++i) {
    tick<EngineIo<float>>(simulator);
    if (i < 10) {
      tick<Dopri5Io>(exact);
      EXPECT_NEAR(simulator.state[0], exact.state[0], 1e-4);
    }
  }
  EXPECT_EQ(simulator.faults(), 0U);
}

struct FewSteps : OdeConfig {
  static constexpr int mxstep = 3;
};

TEST(OdeEngine, TooManyStepsIsAFaultAndTheStateStaysOnItsWay) {
  auto simulator = pendulum<Double>(2.8, 0.5, 1.7);
  auto exact = simulator;
  tick<EngineIo<double, FewSteps>>(simulator);
  tick<Dopri5Io>(exact);
  EXPECT_EQ(simulator.faults(), 1U);
  EXPECT_GT(simulator.state[0], 2.8);
  EXPECT_LT(simulator.state[0], exact.state[0]);
}

struct LongSteps : OdeConfig {
  static constexpr double hmin = 0.02;
};

TEST(OdeEngine, ShortestStepThatMissesTheTolerancesIsAFault) {
  auto simulator = pendulum<Double>(2.8, 0.5, 1.7);
  tick<EngineIo<double, LongSteps>>(simulator);
  EXPECT_EQ(simulator.faults(), 1U);
  EXPECT_EQ(simulator.state[0], 2.8);
}

/// 100 steps of hmax and a remainder too short to be worth a step of its own, which it must get.
struct ShortSteps : OdeConfig {
  static constexpr double hmax = 1.0 / 30.0 / 100.005;
  static constexpr int mxstep = 100;
};
struct ShortStepsAndOneMore : ShortSteps {
  static constexpr int mxstep = 101;
};

TEST(OdeEngine, NoStepIsLongerThanHmax) {
  auto stopped = pendulum<Double>(-1.0, 9.0, -2.0);
  stopped.step_s = 1.0;
  auto finished = stopped;
  tick<EngineIo<double, ShortSteps>>(stopped);
  tick<EngineIo<double, ShortStepsAndOneMore>>(finished);
  EXPECT_EQ(stopped.faults(), 1U);
  EXPECT_EQ(finished.faults(), 0U);
  EXPECT_LE(finished.step_s, ShortSteps::hmax);
}

TEST(OdeEngine, NanInputIsAFaultAndEnds) {
  auto simulator = pendulum<Double>(2.8, 0.5, std::numeric_limits<double>::quiet_NaN());
  tick<Dopri5Io>(simulator);
  EXPECT_EQ(simulator.faults(), 1U);
  EXPECT_EQ(simulator.state[0], 2.8);  // the last state that met the tolerances
  simulator.input = {{1.0}};
  tick<Dopri5Io>(simulator);  // and continues when the input is a number again
  EXPECT_EQ(simulator.faults(), 1U);
  EXPECT_GT(simulator.state[0], 2.8);
}

TEST(OdeEngine, NanStateOfRk4IsAFaultAndIsShown) {
  auto simulator = pendulum<Double>(2.8, 0.5, std::numeric_limits<double>::quiet_NaN());
  tick<EngineIo<double, Rk4Config<30>>>(simulator);
  EXPECT_EQ(simulator.faults(), 1U);
  EXPECT_TRUE(std::isnan(simulator.state[1]));
}

TEST(OdeEngine, AdvancesEverySimulator) {
  auto first = pendulum<Double>(2.8, 0.5, 1.7);
  auto second = pendulum<Double>(1.0, 0.0, 0.0);
  const auto first_alone = first;
  auto check = first_alone;
  OdeEngine<Dopri5Io> engine;
  engine.reset({});
  engine.callback({1}, first, second);
  tick<Dopri5Io>(check);
  EXPECT_EQ(first.state, check.state);
  EXPECT_NE(second.state[0], 1.0);
}

}  // namespace
}  // namespace eagerx::models::testing

// Against solutions that are exact to a millionth: motion and energy, by the length of the steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <models/objects/cart_pole/cart_pole.hpp>
#include <models/objects/pendulum/pendulum_bodies.hpp>
#include <models/objects/two_link_arm/two_link_arm.hpp>

#include "tests/unit/rigid/rigid_io.hpp"

namespace eagerx::models::testing {
namespace {

/// Classical Runge-Kutta with steps of 0.1 ms, which is exact to 1e-9 here.
template <std::size_t N, class F>
std::array<double, N> exact(std::array<double, N> x, double time, const F& f) {
  constexpr double kStep = 1e-4;
  const auto along = [](const std::array<double, N>& a, double h, const std::array<double, N>& b) {
    std::array<double, N> result{};
    for (std::size_t i = 0; i < N; ++i) result[i] = a[i] + h * b[i];
    return result;
  };
  const auto steps = static_cast<int>(std::lround(time / kStep));
  for (int n = 0; n < steps; ++n) {
    const auto k1 = f(x);
    const auto k2 = f(along(x, 0.5 * kStep, k1));
    const auto k3 = f(along(x, 0.5 * kStep, k2));
    const auto k4 = f(along(x, kStep, k3));
    for (std::size_t i = 0; i < N; ++i)
      x[i] += kStep / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
  }
  return x;
}

struct Errors {
  double position = 0.0;  // largest [rad]
  double energy = 0.0;    // largest drift over the scale of the energy
};

// ---- the pendulum without motor and friction

using Pendulum = PendulumBodies<PendulumModelIo<double>>;
using Ode = PendulumOde<PendulumModelIo<double>>;

template <class Simulator>
void take_friction_away(Simulator& simulator) {
  for (const std::size_t i : {Ode::kDamping, Ode::kMotorConstant, Ode::kFriction})
    simulator.parameters[i] = 0.0;
  simulator.reconfigure();
}

template <int Substeps>
Errors swing(double seconds) {
  Scene<Pendulum, RigidConfig<Substeps>> scene;
  take_friction_away(scene.simulator);
  const std::array<double, 2> start = {2.0, 0.0};
  scene.simulator.want_joint(0, {{start[0], 0.0}, {start[1], 0.0}});
  scene.reset();
  const auto& p = scene.simulator.parameters;
  const double weight = p[Ode::kMass] * 9.81 * p[Ode::kLength];  // [N·m]
  const auto energy = [&](double theta, double omega) {
    return 0.5 * p[Ode::kInertia] * omega * omega + weight * std::cos(theta);
  };
  const auto motion = [&](const std::array<double, 2>& x) {
    return std::array<double, 2>{x[1], weight / p[Ode::kInertia] * std::sin(x[0])};
  };
  Errors errors;
  auto expected = start;
  for (double time = 0.0; time < seconds; time += kPeriod) {
    scene.tick();
    expected = exact(expected, kPeriod, motion);
    const double theta = scene.simulator.joint_position(0);
    const double drift = energy(theta, scene.simulator.joint_velocity(0)) - energy(start[0], 0.0);
    errors.position = std::max(errors.position, std::abs(theta - expected[0]));
    errors.energy = std::max(errors.energy, std::abs(drift) / (2.0 * weight));
  }
  return errors;
}

TEST(Accuracy, PendulumIsOfFirstOrderInTheStep) {
  const Errors coarse = swing<20>(2.0), middle = swing<40>(2.0), fine = swing<80>(2.0);
  for (const Errors& errors : {coarse, middle, fine})
    std::printf("pendulum: position %.2e rad, energy %.2e\n", errors.position, errors.energy);
  EXPECT_LT(coarse.position, 0.01);  // 1 ms
  EXPECT_LT(fine.position, 0.0025);  // 0.25 ms
  EXPECT_LT(coarse.energy, 0.003);
  EXPECT_LT(fine.energy, 0.00075);
  EXPECT_NEAR(coarse.position / middle.position, 2.0, 0.3);
  EXPECT_NEAR(middle.position / fine.position, 2.0, 0.3);
}

TEST(Accuracy, PendulumKeepsItsEnergyForAMinute) {
  const Errors errors = swing<20>(60.0);
  std::printf("pendulum: energy after 60 s %.2e\n", errors.energy);
  EXPECT_LT(errors.energy, 0.01);
}

TEST(Accuracy, PendulumOnItsMotorMovesAsOnOdeEngine) {
  Scene<Pendulum, RigidConfig<20>> scene;
  scene.simulator.want_joint(0, {{3.0, 0.0}, {0.5, 0.0}});
  scene.reset();
  std::array<double, 2> expected = {3.0, 0.5};
  double worst = 0.0;
  for (int tick = 0; tick < 100; ++tick) {
    const double voltage = tick % 20 < 10 ? 2.0 : -2.0;
    scene.simulator.input[0] = voltage;
    scene.tick();
    const auto c = Ode::precompute(Ode::default_parameters(), {{voltage}});
    expected = exact(expected, kPeriod, [&](const std::array<double, 2>& x) {
      const auto dx = Ode::derivative(c, {{x[0], x[1]}});
      return std::array<double, 2>{dx[0], dx[1]};
    });
    worst = std::max(worst, std::abs(scene.simulator.joint_position(0) - expected[0]));
  }
  std::printf("pendulum on its motor: position %.2e rad\n", worst);
  EXPECT_LT(worst, 0.015);
}

// ---- the arm

struct ArmIo {
  using Real = double;
  struct Config {
    static constexpr std::array<double, 2> masses = {1.5, 1.0};
    static constexpr std::array<double, 2> lengths = {0.5, 0.4};
  };
};

/// [q1, q2, q1', q2'] by Lagrange's equations, angles from upright, the second relative.
struct Arm {
  static constexpr double m1 = 1.5, m2 = 1.0, l1 = 0.5, l2 = 0.4, g = 9.81;
  static constexpr double c1 = l1 / 2, c2 = l2 / 2;
  static constexpr double i1 = m1 * l1 * l1 / 12, i2 = m2 * l2 * l2 / 12;

  static std::array<double, 4> motion(const std::array<double, 4>& x, double t1, double t2) {
    const double c = std::cos(x[1]), s = std::sin(x[1]);
    const double m11 = i1 + i2 + m1 * c1 * c1 + m2 * (l1 * l1 + c2 * c2 + 2 * l1 * c2 * c);
    const double m12 = i2 + m2 * (c2 * c2 + l1 * c2 * c);
    const double m22 = i2 + m2 * c2 * c2;
    const double h = m2 * l1 * c2 * s;
    const double second = m2 * g * c2 * std::sin(x[0] + x[1]);
    const double b1 =
        t1 + h * x[3] * (2 * x[2] + x[3]) + (m1 * c1 + m2 * l1) * g * std::sin(x[0]) + second;
    const double b2 = t2 - h * x[2] * x[2] + second;
    const double det = m11 * m22 - m12 * m12;
    return {x[2], x[3], (m22 * b1 - m12 * b2) / det, (m11 * b2 - m12 * b1) / det};
  }
  static double energy(const std::array<double, 4>& x) {
    const double c = std::cos(x[1]);
    const double m11 = i1 + i2 + m1 * c1 * c1 + m2 * (l1 * l1 + c2 * c2 + 2 * l1 * c2 * c);
    const double m12 = i2 + m2 * (c2 * c2 + l1 * c2 * c);
    const double m22 = i2 + m2 * c2 * c2;
    const double kinetic = 0.5 * m11 * x[2] * x[2] + m12 * x[2] * x[3] + 0.5 * m22 * x[3] * x[3];
    return kinetic + g * ((m1 * c1 + m2 * l1) * std::cos(x[0]) + m2 * c2 * std::cos(x[0] + x[1]));
  }
  static constexpr double kScale = 2 * g * ((m1 * c1 + m2 * l1) + m2 * c2);
};

template <int Substeps>
Errors move_arm(double seconds, double torque) {
  Scene<TwoLinkArm<ArmIo>, RigidConfig<Substeps>> scene;
  std::array<double, 4> expected = {2.5, 0.6, 0.0, 0.0};
  for (std::size_t j = 0; j < 2; ++j) scene.simulator.want_joint(j, {{expected[j], 0.0}, {}});
  scene.reset();
  const double before = Arm::energy(expected);
  Errors errors;
  for (double time = 0.0; time < seconds - 1e-9; time += kPeriod) {
    const double t1 = torque * std::sin(3.0 * time), t2 = -0.5 * t1;
    scene.simulator.set_joint_torque(0, t1);
    scene.simulator.set_joint_torque(1, t2);
    scene.tick();
    expected = exact(expected, kPeriod, [&](const auto& x) { return Arm::motion(x, t1, t2); });
    const std::array<double, 4> now = {
        scene.simulator.joint_position(0), scene.simulator.joint_position(1),
        scene.simulator.joint_velocity(0), scene.simulator.joint_velocity(1)};
    for (std::size_t j = 0; j < 2; ++j)
      errors.position = std::max(errors.position, std::abs(now[j] - expected[j]));
    errors.energy = std::max(errors.energy, std::abs(Arm::energy(now) - before) / Arm::kScale);
  }
  return errors;
}

TEST(Accuracy, ArmIsOfFirstOrderInTheStep) {
  const Errors coarse = move_arm<20>(2.0, 0.0), middle = move_arm<40>(2.0, 0.0),
               fine = move_arm<80>(2.0, 0.0);
  for (const Errors& errors : {coarse, middle, fine})
    std::printf("arm: position %.2e rad, energy %.2e\n", errors.position, errors.energy);
  EXPECT_LT(coarse.position, 0.008);
  EXPECT_LT(fine.position, 0.002);
  EXPECT_LT(coarse.energy, 0.0005);
  EXPECT_LT(fine.energy, 0.000125);
  EXPECT_NEAR(coarse.position / middle.position, 2.0, 0.4);
  EXPECT_NEAR(middle.position / fine.position, 2.0, 0.4);
}

TEST(Accuracy, ArmFollowsItsTorques) {
  const Errors errors = move_arm<20>(2.0, 1.0);
  std::printf("arm with torques: position %.2e rad\n", errors.position);
  EXPECT_LT(errors.position, 0.008);
}

// ---- the cart

TEST(Accuracy, CartMovesAsItsEquationsSay) {
  Scene<CartPole<PendulumModelIo<double>>, RigidConfig<20>> scene;
  std::array<double, 4> expected = {0.0, 0.1, 0.0, 0.0};  // [x, theta, x', theta']
  scene.simulator.want_joint(1, {{0.1, 0.0}, {}});
  scene.reset();
  constexpr double mc = 1.0, mp = 0.1, l = 0.5, g = 9.81;
  double worst = 0.0;
  for (int tick = 0; tick < 50; ++tick) {
    const double force = tick % 10 < 5 ? 5.0 : -5.0;
    scene.simulator.set_joint_torque(0, force);
    scene.tick();
    expected = exact(expected, kPeriod, [&](const std::array<double, 4>& x) {
      // Barto, Sutton, Anderson, 1983
      const double s = std::sin(x[1]), c = std::cos(x[1]);
      const double push = (force + mp * l * x[3] * x[3] * s) / (mc + mp);
      const double turn = (g * s - c * push) / (l * (4.0 / 3.0 - mp * c * c / (mc + mp)));
      return std::array<double, 4>{x[2], x[3], push - mp * l * turn * c / (mc + mp), turn};
    });
    worst = std::max({worst, std::abs(scene.simulator.joint_position(0) - expected[0]),
                      std::abs(scene.simulator.joint_position(1) - expected[1])});
  }
  std::printf("cart-pole: %.2e m or rad\n", worst);
  EXPECT_LT(worst, 0.002);
}

}  // namespace
}  // namespace eagerx::models::testing

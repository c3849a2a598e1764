// Against solutions that are exact to a millionth: accelerations, motion, energy, momentum.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <models/objects/cart_pole/cart_pole.hpp>
#include <models/objects/two_link_arm/two_link_arm.hpp>

#include "tests/unit/multibody/multibody_io.hpp"
#include "tests/unit/multibody/robots.hpp"
#include "tests/unit/multibody/sampler.hpp"

namespace eagerx::models::testing {
namespace {

template <class Real>
using ArmOf = TwoLinkArm<ModelIo<Real, LagrangeArm::Config>>;
template <class Real>
using CartPoleOf = CartPole<ModelIo<Real, NoConfig>>;

using Arm = LagrangeArm;

template <class Real>
double worst_of_arm() {
  MultibodyScene<ArmOf<Real>> scene;
  Sampler sample;
  double worst = 0.0;
  for (int n = 0; n < 1000; ++n) {
    const std::array<double, 4> x = {sample(3), sample(3), sample(5), sample(5)};
    const double t1 = sample(10), t2 = sample(10);
    scene.simulator.want_joint(0, {{x[0], 0.0}, {x[2], 0.0}});
    scene.simulator.want_joint(1, {{x[1], 0.0}, {x[3], 0.0}});
    scene.simulator.set_joint_torque(0, Real(t1));
    scene.simulator.set_joint_torque(1, Real(t2));
    const auto expected = Arm::acceleration(x, t1, t2);
    const auto a = accelerations(scene.simulator);
    const double scale = std::max(std::abs(expected[0]), std::abs(expected[1]));
    for (std::size_t j = 0; j < 2; ++j)
      worst = std::max(worst, std::abs(a[j] - expected[j]) / scale);
  }
  return worst;
}

TEST(MultibodyAccuracy, AccelerationsOfTheArmAreLagranges) {
  const double in_double = worst_of_arm<double>(), in_float = worst_of_arm<float>();
  std::printf("arm: accelerations %.1e in double, %.1e in float\n", in_double, in_float);
  EXPECT_LT(in_double, 1e-12);
  EXPECT_LT(in_float, 2e-5);
}

TEST(MultibodyAccuracy, AccelerationsOfTheCartPoleAreThoseOfTheTextbook) {
  constexpr double kCart = 1.0, kPole = 0.1, kHalf = 0.5, g = 9.81;
  MultibodyScene<CartPoleOf<double>> scene;
  Sampler sample;
  for (int n = 0; n < 100; ++n) {
    const double theta = sample(3), omega = sample(5), force = sample(10);
    scene.simulator.want_joint(0, {{sample(1), 0.0}, {sample(2), 0.0}});
    scene.simulator.want_joint(1, {{theta, 0.0}, {omega, 0.0}});
    scene.simulator.set_joint_torque(0, force);
    // Florian 2007, without friction.
    const double s = std::sin(theta), c = std::cos(theta), m = kCart + kPole;
    const double push = (force + kPole * kHalf * omega * omega * s) / m;
    const double turn = (g * s - c * push) / (kHalf * (4.0 / 3.0 - kPole * c * c / m));
    const double move = push - kPole * kHalf * turn * c / m;
    const auto a = accelerations(scene.simulator);
    EXPECT_NEAR(a[0], move, 1e-10);
    EXPECT_NEAR(a[1], turn, 1e-10);
  }
}

/// Largest drift of the energy in 2 s of free motion, in J.
template <int Substeps>
double drift_of_arm() {
  MultibodyScene<ArmOf<double>, MultibodyConfig<Substeps>> scene;
  scene.simulator.want_joint(0, {{2.0, 0.0}, {0.0, 0.0}});
  scene.simulator.want_joint(1, {{0.5, 0.0}, {0.0, 0.0}});
  scene.reset();
  const double start = Arm::energy({2.0, 0.5, 0.0, 0.0});
  double worst = 0.0;
  for (int i = 0; i < 100; ++i) {
    scene.tick();
    const auto& s = scene.simulator.numbers();
    worst = std::max(worst, std::abs(Arm::energy({s.q[0], s.q[1], s.v[0], s.v[1]}) - start));
  }
  return worst;
}

TEST(MultibodyAccuracy, EnergyIsOfFirstOrderInTheStep) {
  const double coarse = drift_of_arm<20>(), middle = drift_of_arm<40>(), fine = drift_of_arm<80>();
  std::printf("arm: energy %.1e, %.1e, %.1e J\n", coarse, middle, fine);
  EXPECT_LT(coarse, 0.05);  // of 25 J; 1 ms
  EXPECT_NEAR(coarse / middle, 2.0, 0.4);
  EXPECT_NEAR(middle / fine, 2.0, 0.4);
}

/// Momentum and angular momentum about the world's origin, of all bodies.
template <class Model>
std::array<double, 6> momentum(const MultibodySimulator<Model>& simulator) {
  std::array<double, 6> sum{};
  for (std::size_t b = 0; b < Model::kBodies.size(); ++b) {
    const RigidState at = simulator.state(b);
    const RigidBody& body = Model::kBodies[b];
    const Vector3 w = rotate(inverse(at.rotation), at.angular_velocity);
    const Vector3 &i = body.inertia, &p = body.products;
    const Vector3 own{{i[0] * w[0] + p[0] * w[1] + p[1] * w[2],
                       p[0] * w[0] + i[1] * w[1] + p[2] * w[2],
                       p[1] * w[0] + p[2] * w[1] + i[2] * w[2]}};
    const Vector3 linear = body.mass * at.velocity;
    const Vector3 angular = rotate(at.rotation, own) + cross(at.position, linear);
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] += linear[k];
      sum[3 + k] += angular[k];
    }
  }
  return sum;
}

/// Drift in 1 s relative to the largest number of each kind.
template <class Real, int Substeps>
std::array<double, 2> drift_of_momentum() {
  MultibodyScene<FloatingWalker<Real>, WeightlessMultibody<Substeps>> scene;
  Sampler sample;
  scene.simulator.want_twist(0, {{1.0, -0.5, 0.7, 2.0, 1.0, -1.5}});
  for (std::size_t j = 0; j < 12; ++j)
    scene.simulator.want_joint(j, {{sample(1), 0.0}, {sample(3), 0.0}});
  scene.reset();
  const auto start = momentum(scene.simulator);
  std::array<double, 2> worst{}, scale{};
  for (int i = 0; i < 50; ++i) {
    scene.tick();
    const auto now = momentum(scene.simulator);
    for (std::size_t k = 0; k < 6; ++k) {
      worst[k / 3] = std::max(worst[k / 3], std::abs(now[k] - start[k]));
      scale[k / 3] = std::max(scale[k / 3], std::abs(start[k]));
    }
  }
  return {worst[0] / scale[0], worst[1] / scale[1]};
}

TEST(MultibodyAccuracy, MomentumIsKeptToFirstOrderInTheStep) {
  const auto coarse = drift_of_momentum<double, 20>(), fine = drift_of_momentum<double, 40>();
  const auto in_float = drift_of_momentum<float, 20>();
  std::printf("momentum: linear %.1e, %.1e; angular %.1e, %.1e; in float %.1e, %.1e\n", coarse[0],
              fine[0], coarse[1], fine[1], in_float[0], in_float[1]);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_LT(coarse[k], 0.02);
    EXPECT_NEAR(coarse[k] / fine[k], 2.0, 0.4);
    EXPECT_NEAR(in_float[k], coarse[k], 1e-4);
  }
}

/// A robot in any other frame accelerates alike: axes that are none of the object's, and opposite
/// ones.
template <bool kOpposite>
struct TurnedArm : ArmOf<double> {
  using Arm = ArmOf<double>;
  static constexpr Quaternion kTurn = rotation({{0.6, 0.0, 0.8}}, kOpposite ? 0.0 : 0.7);
  static constexpr std::array<RigidBody, 2> kBodies = [] {
    auto bodies = Arm::kBodies;
    for (RigidBody& body : bodies) {
      body.position = rotate(kTurn, body.position);
      // R·diag(i)·Rᵀ by its columns.
      std::array<Vector3, 3> column{};
      for (std::size_t k = 0; k < 3; ++k) {
        Vector3 unit{};
        unit[k] = 1.0;
        column[k] = rotate(kTurn, unit);
      }
      const Vector3 i = body.inertia;
      const auto element = [&](std::size_t a, std::size_t b) {
        double sum = 0.0;
        for (std::size_t k = 0; k < 3; ++k) sum += column[k][a] * i[k] * column[k][b];
        return sum;
      };
      body.inertia = {{element(0, 0), element(1, 1), element(2, 2)}};
      body.products = {{element(0, 1), element(0, 2), element(1, 2)}};
    }
    return bodies;
  }();
  static constexpr std::array<RigidJoint, 2> kJoints = [] {
    auto joints = Arm::kJoints;
    for (RigidJoint& joint : joints) {
      joint.anchor = rotate(kTurn, joint.anchor);
      joint.axis = rotate(kTurn, joint.axis);
      if (kOpposite) joint.axis = -1.0 * joint.axis;
    }
    return joints;
  }();
};

TEST(MultibodyAccuracy, AxesMayPointAnywhere) {
  MultibodyScene<ArmOf<double>> plain;
  MultibodyScene<TurnedArm<false>> turned;
  MultibodyScene<TurnedArm<true>> opposite;
  const Vector3 down = rotate(TurnedArm<false>::kTurn, {{0.0, 0.0, -9.81}});
  turned.simulator.set_gravity(down);
  const auto set = [](auto& scene, double sign) {
    scene.simulator.want_joint(0, {{sign * 2.0, 0.0}, {sign * 1.0, 0.0}});
    scene.simulator.want_joint(1, {{sign * -0.7, 0.0}, {sign * 2.0, 0.0}});
    scene.simulator.set_joint_torque(1, sign * 1.5);
    scene.reset();
    scene.run(1.0);
  };
  set(plain, 1.0);
  set(turned, 1.0);
  set(opposite, -1.0);
  for (std::size_t j = 0; j < 2; ++j) {
    EXPECT_NEAR(turned.simulator.joint_position(j), plain.simulator.joint_position(j), 1e-9);
    EXPECT_EQ(opposite.simulator.joint_position(j), -plain.simulator.joint_position(j));
    EXPECT_EQ(opposite.simulator.joint_torque(j), -plain.simulator.joint_torque(j));
  }
}

}  // namespace
}  // namespace eagerx::models::testing

// Joints that follow others, against closed forms.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <eagerx/simd.hpp>

#include "tests/unit/multibody/robots.hpp"

namespace eagerx::models::testing {
namespace {

/// Two fingers on sliders that open by the same way, 1 and 2 kg.
template <class RealType>
struct Gripper {
  using Real = RealType;
  static constexpr std::array<RigidBody, 2> kBodies = {
      {{.name = "left", .mass = 1.0}, {.name = "right", .mass = 2.0}}};
  static constexpr std::array<RigidJoint, 2> kJoints = {
      {{.name = "opens", .kind = JointKind::slider, .child = "left", .axis = {{0.0, 1.0, 0.0}}},
       {.name = "follows",
        .kind = JointKind::slider,
        .child = "right",
        .axis = {{0.0, -1.0, 0.0}},
        .mimics = "opens",
        .ratio = 1.0,
        .offset = 0.01}}};
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};
};

TEST(MultibodyMimic, ForceMovesBothFingers) {
  MultibodyScene<Gripper<double>, WeightlessMultibody<20>> scene;
  EXPECT_EQ(scene.simulator.joint_position(1), 0.01);  // from the start
  scene.simulator.set_joint_torque(0, 6.0);
  scene.reset();
  scene.run(0.5);
  const double speed = scene.simulator.joint_velocity(0);
  EXPECT_NEAR(speed, 6.0 / (1.0 + 2.0) * 0.5, 1e-12);
  EXPECT_EQ(scene.simulator.joint_velocity(1), speed);
  EXPECT_EQ(scene.simulator.joint_position(1), scene.simulator.joint_position(0) + 0.01);
  EXPECT_NEAR(scene.simulator.twist(1)[1], -speed, 1e-12);
}

/// The force may act on the one that follows.
TEST(MultibodyMimic, FollowerPushesItsLeader) {
  MultibodyScene<Gripper<double>, WeightlessMultibody<20>> scene;
  scene.simulator.set_joint_torque(1, 6.0);
  scene.reset();
  scene.run(0.5);
  EXPECT_NEAR(scene.simulator.joint_velocity(0), 1.0, 1e-12);
}

TEST(MultibodyMimic, AResetPlacesTheFollower) {
  MultibodyScene<Gripper<float>, WeightlessMultibody<20>> scene;
  scene.simulator.want_joint(0, {{0.3, 0.0}, {0.2, 0.0}});
  scene.simulator.want_joint(1, {{9.0, 0.0}, {9.0, 0.0}});
  scene.reset();
  EXPECT_NEAR(scene.simulator.joint_position(1), 0.31F, 1e-6F);
  EXPECT_NEAR(scene.simulator.joint_velocity(1), 0.2F, 1e-6F);
}

/// A finger of two rods of length 1 whose second joint turns `ratio` times as far as the first, and
/// a gear train: several followers of one leader, one of them on another limb.
template <class RealType>
struct Finger {
  using Real = RealType;
  static constexpr double kRatio = 0.5;
  static constexpr std::array<RigidBody, 3> kBodies = {
      {{.name = "first", .mass = 1.0, .inertia = {{0.1, 0.1, 0.1}}, .position = {{0.5, 0.0, 0.0}}},
       {.name = "second", .mass = 0.5, .inertia = {{0.2, 0.2, 0.2}}, .position = {{1.5, 0.0, 0.0}}},
       {.name = "wheel",
        .mass = 3.0,
        .inertia = {{0.3, 0.3, 0.3}},
        .position = {{0.0, 1.0, 0.0}}}}};
  static constexpr std::array<RigidJoint, 3> kJoints = {{{.name = "a", .child = "first"},
                                                         {.name = "b",
                                                          .parent = "first",
                                                          .child = "second",
                                                          .anchor = {{1.0, 0.0, 0.0}},
                                                          .mimics = "a",
                                                          .ratio = kRatio},
                                                         {.name = "c",
                                                          .child = "wheel",
                                                          .anchor = {{0.0, 1.0, 0.0}},
                                                          .axis = {{0.0, -1.0, 0.0}},
                                                          .mimics = "a",
                                                          .ratio = -3.0}}};
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};
};

/// Lagrange's equation of the one coordinate q: T = m(q)·q̇²/2, no gravity: energy stays, and the
/// first acceleration is τ/m(0).
double finger_mass(double q) {
  const double k = Finger<double>::kRatio, c = std::cos(k * q);
  const double first = 1.0 * 0.25 + 0.1;
  // The second rod turns with 1 + k; its centre moves with the end of the first one.
  const double second =
      0.5 * (1.0 + 0.25 * (1 + k) * (1 + k) + (1 + k) * c) + 0.2 * (1 + k) * (1 + k);
  return first + second + 9.0 * 0.3;
}

TEST(MultibodyMimic, SeveralFollowersMoveAsLagrangesEquationSays) {
  MultibodyScene<Finger<double>, WeightlessMultibody<200>> scene;  // steps of 0.1 ms
  scene.simulator.set_joint_torque(0, 2.0);
  scene.reset();
  scene.tick();
  EXPECT_NEAR(scene.simulator.joint_velocity(0), 2.0 / finger_mass(0.0) * 0.02, 1e-6);
  EXPECT_NEAR(scene.simulator.joint_velocity(2), -3.0 * scene.simulator.joint_velocity(0), 1e-15);
  scene.run(1.98);
  const double q = scene.simulator.joint_position(0), v = scene.simulator.joint_velocity(0);
  EXPECT_NEAR(0.5 * finger_mass(q) * v * v, 2.0 * q, 2e-4 * 2.0 * q);  // the work
}

/// On a free base in space, momentum stays.
template <class RealType>
struct FreeGripper {
  using Real = RealType;
  static constexpr std::array<RigidBody, 3> kBodies = {
      {{.name = "palm", .mass = 4.0},
       {.name = "left", .mass = 1.0, .position = {{0.0, 0.2, 0.0}}},
       {.name = "right", .mass = 2.0, .position = {{0.0, -0.3, 0.1}}}}};
  static constexpr std::array<RigidJoint, 2> kJoints = {{{.name = "opens",
                                                          .kind = JointKind::slider,
                                                          .parent = "palm",
                                                          .child = "left",
                                                          .axis = {{0.0, 1.0, 0.0}}},
                                                         {.name = "follows",
                                                          .kind = JointKind::slider,
                                                          .parent = "palm",
                                                          .child = "right",
                                                          .axis = {{0.0, -1.0, 0.0}},
                                                          .mimics = "opens"}}};
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};
};

TEST(MultibodyMimic, MomentumOfAFreeGripperStays) {
  MultibodyScene<FreeGripper<double>, WeightlessMultibody<20>> scene;
  scene.simulator.set_joint_torque(0, 1.0);
  scene.reset();
  scene.tick();
  double momentum = 0.0;
  for (std::size_t b = 0; b < 3; ++b)
    momentum += FreeGripper<double>::kBodies[b].mass * scene.simulator.twist(b)[1];
  EXPECT_NEAR(momentum, 0.0, 1e-9);
  EXPECT_GT(scene.simulator.joint_velocity(0), 0.005);
  EXPECT_EQ(scene.simulator.joint_velocity(0), scene.simulator.joint_velocity(1));
}

/// Lanes of a SIMD vector: the bits of each alone.
TEST(MultibodyMimic, LanesHaveTheBitsOfPlainNumbers) {
  constexpr std::size_t kLanes = 4;
  using One = MultibodySimulator<Finger<float>>;
  using All = MultibodySimulator<Finger<eagerx::Simd<float, kLanes>>>;
  std::array<One, kLanes> ones{};
  All all{};
  constexpr std::size_t kWords = sizeof(One) / 4;
  const auto word_of = [](All& many, std::size_t word, std::size_t lane) {
    return reinterpret_cast<char*>(&many) + 4 * (word * kLanes + lane);
  };
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    ones[lane].start({{0.0, 0.0, -9.81}});
    ones[lane].set_joint_torque(0, 1.5F - static_cast<float>(lane));
    ones[lane].begin_episode();
    for (std::size_t w = 0; w < kWords; ++w)
      std::memcpy(word_of(all, w, lane), reinterpret_cast<const char*>(&ones[lane]) + 4 * w, 4);
  }
  constexpr multibody::ContactSettings<float> kSettings{2e4F, 400.0F, 0.005F, 0.2F, 0.004F};
  for (int i = 0; i < 500; ++i) {
    all.step(kSettings, 4);
    for (One& one : ones) one.step(kSettings, 4);
  }
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    for (std::size_t w = 0; w < kWords; ++w)
      EXPECT_EQ(
          std::memcmp(word_of(all, w, lane), reinterpret_cast<const char*>(&ones[lane]) + 4 * w, 4),
          0)
          << lane << " " << w;
    EXPECT_NE(ones[lane].joint_position(0), 0.0F);
  }
}

}  // namespace
}  // namespace eagerx::models::testing

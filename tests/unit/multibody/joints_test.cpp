// Joints: stops, servos, motors, friction, damping, limits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <models/objects/two_link_arm/two_link_arm.hpp>

#include "tests/unit/multibody/multibody_io.hpp"

namespace eagerx::models::testing {
namespace {

/// A rod of 1 kg on one joint, whose other parts the tests choose.
template <class RealType, class Joint>
struct Rod {
  using Real = RealType;
  static constexpr std::array<RigidBody, 1> kBodies = {
      {{.name = "rod", .inertia = {{0.1, 0.1, 0.01}}, .position = {{0.0, 0.0, Joint::kCentre}}}}};
  static constexpr std::array<RigidJoint, 1> kJoints = {Joint::joint()};
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};
};
constexpr double kPi = 3.141592653589793;
template <class Joint, class Real = double, class Config = MultibodyConfig<20>>
using RodScene = MultibodyScene<Rod<Real, Joint>, Config>;

template <int kTenthsOfPi>
struct Stopped {
  static constexpr double kCentre = 0.5;
  static constexpr double kStop = 0.1 * kTenthsOfPi * kPi;
  static constexpr RigidJoint joint() {
    return {.name = "j", .child = "rod", .low = -kStop, .high = kStop};
  }
};

template <int kTenthsOfPi, class Real, int Substeps>
void check_stop() {
  RodScene<Stopped<kTenthsOfPi>, Real, WeightlessMultibody<Substeps>> scene;
  const double stop = Stopped<kTenthsOfPi>::kStop;
  for (const double side : {1.0, -1.0}) {
    scene.simulator.want_joint(0, {{side * (stop - 0.5), 0.0}, {0.0, 0.0}});
    scene.simulator.set_joint_torque(0, Real(side * 20.0));
    scene.reset();
    double furthest = 0.0;
    for (int i = 0; i < 100; ++i) {
      scene.tick();
      furthest = std::max(furthest, side * static_cast<double>(scene.simulator.joint_position(0)));
    }
    EXPECT_NEAR(furthest, stop, 2e-3);
    EXPECT_NEAR(side * static_cast<double>(scene.simulator.joint_position(0)), stop, 2e-3);
    EXPECT_LT(std::abs(static_cast<double>(scene.simulator.joint_velocity(0))), 1e-3);
    scene.simulator.set_joint_torque(0, Real(-side));  // and it does not stick
    scene.run(0.5);
    EXPECT_LT(side * static_cast<double>(scene.simulator.joint_position(0)), stop - 0.2);
  }
}

TEST(MultibodyJoints, StopsHoldBelowAtAndBeyondHalfATurn) {
  check_stop<5, double, 20>();
  check_stop<10, double, 20>();  // at π: Open Dynamics Engine lets it through
  check_stop<10, float, 4>();
  check_stop<35, double, 10>();  // 1.75 turns
  check_stop<35, float, 20>();
}

TEST(MultibodyJoints, WhatAResetPutBeyondAStopComesBackSlowly) {
  RodScene<Stopped<5>, float, WeightlessMultibody<20>> scene;
  scene.simulator.want_joint(0, {{2.5, 0.0}, {0.0, 0.0}});
  scene.reset();
  for (int i = 0; i < 50; ++i) {
    scene.tick();
    EXPECT_LE(std::abs(scene.simulator.joint_velocity(0)), 5.01F);
  }
  EXPECT_LE(scene.simulator.joint_position(0), 0.5 * kPi + 1e-3);
}

struct Damped {
  static constexpr double kCentre = 0.0;
  static constexpr RigidJoint joint() { return {.name = "j", .child = "rod", .damping = 1000.0}; }
};

TEST(MultibodyJoints, DampingFarAboveInertiaPerStepIsStable) {
  RodScene<Damped> scene;  // inertia/step is 100 N·m·s/rad
  scene.simulator.want_joint(0, {{0.0, 0.0}, {5.0, 0.0}});
  scene.reset();
  scene.simulator.set_joint_torque(0, 50.0);
  scene.run(1.0);
  EXPECT_NEAR(scene.simulator.joint_velocity(0), 0.05, 1e-6);  // torque/damping
}

template <int kStiffness>
struct Sprung {
  static constexpr double kCentre = 0.0;
  static constexpr RigidJoint joint() {
    return {.name = "j",
            .child = "rod",
            .axis = {{0.0, -1.0, 0.0}},
            .damping = 1.0,
            .stiffness = kStiffness,
            .rest = 0.3};
  }
};

TEST(MultibodyJoints, SpringsPullToWhereTheyRest) {
  RodScene<Sprung<10>> scene;
  scene.simulator.set_joint_torque(0, 1.0);
  scene.run(5.0);
  EXPECT_NEAR(scene.simulator.joint_position(0), 0.4, 1e-6);  // torque/stiffness further
  RodScene<Sprung<10'000'000>> firm;                          // inertia/step² is 100,000 N·m/rad
  firm.run(5.0);
  EXPECT_NEAR(firm.simulator.joint_position(0), 0.3, 1e-6);
}

struct Rubbing {
  static constexpr double kCentre = 0.0;
  static constexpr RigidJoint joint() { return {.name = "j", .child = "rod", .friction = 2.0}; }
};

TEST(MultibodyJoints, FrictionHoldsAndBrakes) {
  RodScene<Rubbing> scene;
  scene.simulator.set_joint_torque(0, 1.9);
  scene.run(1.0);
  EXPECT_LT(std::abs(scene.simulator.joint_position(0)),
            1e-4);  // creeps by load·step/(1000·inertia)
  scene.simulator.set_joint_torque(0, 3.0);
  scene.run(1.0);
  EXPECT_NEAR(scene.simulator.joint_velocity(0), 10.0, 0.02);  // (3 − 2)/0.1
  scene.simulator.set_joint_torque(0, 0.0);
  const double position = scene.simulator.joint_position(0);
  const double speed = scene.simulator.joint_velocity(0);
  scene.run(1.0);
  EXPECT_NEAR(scene.simulator.joint_position(0) - position, speed * speed / 40.0, 0.02);
  EXPECT_LT(std::abs(scene.simulator.joint_velocity(0)), 1e-6);
}

struct Strong {
  static constexpr double kCentre = 0.5;
  static constexpr RigidJoint joint() {
    return {.name = "j", .child = "rod", .axis = {{0.0, -1.0, 0.0}}, .max_torque = 8.0};
  }
};

TEST(MultibodyJoints, ServoHoldsWithItsStiffnessAndItsLargestTorque) {
  RodScene<Strong, double, WeightlessMultibody<4>> scene;  // 5 ms
  scene.simulator.set_joint_servo(0, {1.0, 1e4, 2000.0, 100.0});
  scene.tick();
  EXPECT_NEAR(scene.simulator.joint_torque(0), 8.0, 1e-9);  // max_torque of the joint
  EXPECT_NEAR(scene.simulator.joint_velocity(0), 8.0 / 0.35 * 0.02, 1e-9);
  scene.run(2.0);
  EXPECT_NEAR(scene.simulator.joint_position(0), 1.0, 1e-4);
  RodScene<Strong> loaded;
  loaded.simulator.set_joint_servo(0, {1.5707963267948966, 100.0, 10.0, 100.0});
  loaded.run(3.0);
  const double q = loaded.simulator.joint_position(0);
  EXPECT_NEAR(100.0 * (1.5707963267948966 - q), -9.81 * 0.5 * std::sin(q), 1e-6);
  EXPECT_NEAR(loaded.simulator.joint_torque(0), 100.0 * (1.5707963267948966 - q), 1e-6);
}

TEST(MultibodyJoints, MotorHoldsAVelocityWithItsLargestTorque) {
  RodScene<Strong, float> scene;
  scene.simulator.set_joint_motor(0, 3.0F, 7.0F);
  scene.run(2.0);
  double least = 9.0, most = 0.0;
  for (int i = 0; i < 100; ++i) {  // turns around under its weight of 4.9 N·m
    scene.tick();
    least = std::min(least, static_cast<double>(scene.simulator.joint_velocity(0)));
    most = std::max(most, static_cast<double>(scene.simulator.joint_velocity(0)));
  }
  EXPECT_NEAR(least, 3.0, 1e-3);
  EXPECT_NEAR(most, 3.0, 1e-3);
  scene.simulator.want_joint(0, {{0.0, 0.0}, {0.0, 0.0}});
  scene.reset();
  scene.simulator.set_joint_motor(0, 3.0F, 1.0F);
  scene.tick();
  EXPECT_NEAR(scene.simulator.joint_velocity(0), 1.0 / 0.35 * 0.02, 1e-3);
}

struct Limited {
  static constexpr double kCentre = 0.0;
  static constexpr RigidJoint joint() {
    return {.name = "j", .child = "rod", .armature = 0.1, .max_velocity = 2.0};
  }
};

TEST(MultibodyJoints, ArmatureAndTheLimitOfSpeed) {
  RodScene<Limited> scene;
  scene.simulator.set_joint_torque(0, 1.0);
  scene.run(0.2);
  EXPECT_NEAR(scene.simulator.joint_velocity(0), 1.0, 1e-9);  // 1/(0.1 + 0.1)·0.2
  scene.run(2.0);
  EXPECT_NEAR(scene.simulator.joint_velocity(0), 2.0, 0.01);
}

struct Sliding {
  static constexpr double kCentre = 0.0;
  static constexpr RigidJoint joint() {
    return {.name = "j",
            .kind = JointKind::slider,
            .child = "rod",
            .axis = {{0.0, 0.0, 1.0}},
            .low = -0.5};
  }
};

TEST(MultibodyJoints, SliderFallsOnItsStop) {
  RodScene<Sliding> scene;
  scene.run(0.2);
  EXPECT_NEAR(scene.simulator.joint_position(0), -0.5 * 9.81 * 0.2 * 0.2, 2e-3);
  scene.run(2.0);
  EXPECT_NEAR(scene.simulator.joint_position(0), -0.5, 1e-4);
  EXPECT_LT(std::abs(scene.simulator.joint_velocity(0)), 1e-9);
}

TEST(MultibodyJoints, WhatIsNotFiniteCountsAsZero) {
  RodScene<Damped> scene;
  const double nan = std::nan("");
  scene.simulator.set_joint_torque(0, nan);
  scene.simulator.set_force(0, {{nan, nan, nan}});
  scene.simulator.want_joint(0, {{nan, 0.0}, {nan, 0.0}});
  scene.reset();
  scene.run(0.1);
  EXPECT_EQ(scene.simulator.joint_position(0), 0.0);
  EXPECT_EQ(scene.simulator.faults(), 0U);
  scene.simulator.want_joint(0, {{1e300, 0.0}, {1e308, 0.0}});
  scene.run(0.1);
  EXPECT_GT(scene.simulator.faults(), 0U);
}

/// A light base with a heavy arm of two joints, in space.
template <class RealType>
struct Tossed {
  using Real = RealType;
  static constexpr std::array<RigidBody, 3> kBodies = {
      {{.name = "base", .mass = 0.2, .inertia = {{4e-4, 4e-4, 5e-4}}},
       {.name = "upper", .mass = 0.9, .inertia = {{3e-3, 0.3, 0.3}}, .position = {{0.3, 0.0, 0.1}}},
       {.name = "lower",
        .mass = 0.9,
        .inertia = {{3e-3, 0.3, 0.3}},
        .position = {{1.2, 0.0, 0.1}}}}};
  static constexpr std::array<RigidJoint, 2> kJoints = {{{.name = "a",
                                                          .parent = "base",
                                                          .child = "upper",
                                                          .axis = {{0.0, 0.0, 1.0}},
                                                          .max_velocity = 5.0},
                                                         {.name = "b",
                                                          .parent = "upper",
                                                          .child = "lower",
                                                          .anchor = {{1.0, 0.0, 0.1}},
                                                          .axis = {{0.0, 0.0, 1.0}},
                                                          .max_velocity = 5.0}}};
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};
};

/// Torques that turn the base by 100 rad/s in a step: the joints' speeds stay below 1.25 times
/// their limit, and angular momentum stays 0.
TEST(MultibodyJoints, LimitOfSpeedHoldsWhatOtherLinksDrive) {
  MultibodyScene<Tossed<double>, WeightlessMultibody<20>> scene;
  double fastest = 0.0;
  for (int i = 0; i < 100; ++i) {
    scene.simulator.set_joint_torque(0, i % 3 == 0 ? 50.0 : -50.0);
    scene.simulator.set_joint_torque(1, i % 2 == 0 ? 50.0 : -50.0);
    scene.tick();
    for (std::size_t j = 0; j < 2; ++j)
      fastest = std::max(fastest, std::abs(scene.simulator.joint_velocity(j)));
  }
  EXPECT_LT(fastest, 1.3 * 5.0);
  double linear = 0.0;
  for (std::size_t b = 0; b < 3; ++b)
    linear += Tossed<double>::kBodies[b].mass * scene.simulator.twist(b)[0];
  EXPECT_NEAR(linear, 0.0, 0.05);
  EXPECT_LT(std::abs(scene.simulator.twist(0)[5]), 20.0);
}

/// An arm of seven links that get lighter, with axes across, along and up in turn.
struct LongArm {
  using Real = double;
  static constexpr std::size_t kJointCount = 7;
  static constexpr std::array<const char*, kJointCount + 1> kNames = {
      {"base", "a", "b", "c", "d", "e", "f", "g"}};
  static constexpr auto kBodies = [] {
    std::array<RigidBody, kJointCount> bodies{};
    for (std::size_t i = 0; i < kJointCount; ++i) {
      const double mass = 5.0 / static_cast<double>(1U << i);
      bodies[i] = {.name = kNames[i + 1],
                   .mass = mass,
                   .inertia = {{0.01 * mass, 0.01 * mass, 0.002 * mass}},
                   .position = {{0.05, 0.0, 0.2 * static_cast<double>(i) + 0.1}}};
    }
    return bodies;
  }();
  static constexpr auto kJoints = [] {
    std::array<RigidJoint, kJointCount> joints{};
    for (std::size_t i = 0; i < kJointCount; ++i) {
      joints[i] = {
          .name = kNames[i + 1],
          .parent = i == 0 ? "" : kNames[i],
          .child = kNames[i + 1],
          .anchor = {{0.0, 0.0, 0.2 * static_cast<double>(i)}},
          .axis = {{i % 3 == 1 ? 1.0 : 0.0, i % 3 == 0 ? 1.0 : 0.0, i % 3 == 2 ? 1.0 : 0.0}},
          .low = -2.0,
          .high = 2.0,
          .max_velocity = 1.5};
    }
    return joints;
  }();
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};
};

/// Random torques that exceed what the light links weigh many times: no joint is faster than 1.25
/// times its limit, although each drives all others.
TEST(MultibodyJoints, LimitOfSpeedHoldsInALongArm) {
  MultibodyScene<LongArm, WeightlessMultibody<4>> scene;
  std::uint32_t bits = 1;
  double fastest = 0.0;
  for (int i = 0; i < 2000; ++i) {
    for (std::size_t j = 0; j < LongArm::kJointCount; ++j) {
      bits = bits * 1664525U + 1013904223U;
      const double part = static_cast<double>(bits >> 8U) * 0x1p-23 - 1.0;
      scene.simulator.set_joint_torque(j, part * (j < 4 ? 50.0 : 15.0));
    }
    scene.tick();
    for (std::size_t j = 0; j < LongArm::kJointCount; ++j)
      fastest = std::max(fastest, std::abs(scene.simulator.joint_velocity(j)));
  }
  EXPECT_LT(fastest, 1.25 * 1.5 + 1e-9);
  EXPECT_GT(fastest, 1.5);
}

}  // namespace
}  // namespace eagerx::models::testing

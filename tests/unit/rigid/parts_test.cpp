// Parts of robot descriptions: inertia about any axes, rotated shapes, joints with friction.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/rigid/rigid_io.hpp"

namespace eagerx::models::testing {
namespace {

/// Two wheels and a slider, all of 0.1 kg·m² or 2 kg, that something holds back.
struct Brakes {
  using Real = double;
  static constexpr std::array<RigidBody, 3> kBodies = {
      {{.name = "damped", .mass = 1.0, .inertia = {{0.1, 0.1, 0.1}}},
       {.name = "braked", .mass = 1.0, .inertia = {{0.1, 0.1, 0.1}}},
       {.name = "cart", .mass = 2.0}}};
  static constexpr std::array<RigidJoint, 3> kJoints = {
      {{.name = "damped", .child = "damped", .axis = {{0.0, 0.0, 1.0}}, .damping = 0.05},
       {.name = "braked",
        .child = "braked",
        .axis = {{0.0, 0.0, 1.0}},
        .max_torque = 1.5,
        .friction = 0.5},
       {.name = "rail",
        .kind = JointKind::slider,
        .child = "cart",
        .axis = {{1.0, 0.0, 0.0}},
        .max_torque = 6.0}}};
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};
};
using BrakesScene = Scene<Brakes, WeightlessConfig<20>>;

TEST(JointBrakes, DampingIsProportionalToVelocity) {
  BrakesScene scene;
  scene.simulator.want_joint(0, {{}, {4.0, 0.0}});
  scene.reset();
  for (int tick = 1; tick <= 100; ++tick) {
    scene.tick();
    EXPECT_NEAR(scene.simulator.joint_velocity(0), 4.0 * std::exp(-0.5 * tick * kPeriod), 1e-3);
  }
}

TEST(JointBrakes, FrictionStopsAndHolds) {
  BrakesScene scene;
  scene.simulator.want_joint(1, {{}, {-2.0, 0.0}});
  scene.reset();
  for (int tick = 1; tick <= 50; ++tick) {  // 5 rad/s²
    scene.tick();
    EXPECT_NEAR(scene.simulator.joint_velocity(1), std::min(0.0, -2.0 + 5.0 * tick * kPeriod),
                1e-6);
  }
  scene.simulator.set_joint_torque(1, 0.49);
  for (int i = 0; i < 25; ++i) scene.tick();
  EXPECT_NEAR(scene.simulator.joint_velocity(1), 0.0, 1e-6);
  scene.simulator.set_joint_torque(1, 1.0);
  for (int i = 0; i < 25; ++i) scene.tick();
  EXPECT_NEAR(scene.simulator.joint_velocity(1), 2.5, 1e-6);
}

TEST(JointBrakes, NoActuatorHasMoreThanTheLargestTorque) {
  BrakesScene scene;
  scene.simulator.set_joint_torque(2, -40.0);
  EXPECT_EQ(scene.simulator.joint_torque(2), -6.0);
  for (int i = 0; i < 25; ++i) scene.tick();
  EXPECT_NEAR(scene.simulator.joint_velocity(2), -1.5, 1e-6);

  BrakesScene servo;
  servo.simulator.set_joint_servo(
      2, {.position = 9.0, .stiffness = 100.0, .damping = 0.0, .max_torque = 50.0});
  for (int i = 0; i < 25; ++i) servo.tick();
  EXPECT_NEAR(servo.simulator.joint_velocity(2), 1.5, 1e-6);

  BrakesScene motor;
  motor.simulator.set_joint_motor(1, 3.0, 20.0);  // 1.5 N·m, less the friction
  motor.simulator.set_joint_motor(2, 3.0, 20.0);
  for (int i = 0; i < 10; ++i) motor.tick();
  EXPECT_NEAR(motor.simulator.joint_velocity(1), 2.0, 1e-6);
  EXPECT_NEAR(motor.simulator.joint_velocity(2), 0.6, 1e-6);
  motor.simulator.set_joint_motor(1, 3.0, 0.3);  // less than the friction: it brakes
  for (int i = 0; i < 50; ++i) motor.tick();
  EXPECT_NEAR(motor.simulator.joint_velocity(1), 0.0, 1e-6);
}

constexpr double kHalf = 0.7071067811865476;
constexpr double kSmall = 0.01, kMiddle = 0.02, kLarge = 0.025;  // principal moments [kg·m²]

/// A body along its principal axes, and the same turned by 45° about z in the reference pose.
struct Plain {
  using Real = double;
  static constexpr std::array<RigidBody, 1> kBodies = {
      {{.name = "body", .mass = 0.5, .inertia = {{kSmall, kMiddle, kLarge}}}}};
  static constexpr std::array<RigidJoint, 0> kJoints = {};
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};
};
struct Turned : Plain {
  static constexpr std::array<RigidBody, 1> kBodies = {
      {{.name = "body",
        .mass = 0.5,
        .inertia = {{0.5 * (kSmall + kMiddle), 0.5 * (kSmall + kMiddle), kLarge}},
        .products = {{0.5 * (kSmall - kMiddle), 0.0, 0.0}}}}};
};

TEST(Inertia, ProductsAreThoseOfTurnedAxes) {
  Scene<Plain, WeightlessConfig<20>> plain;
  Scene<Turned, WeightlessConfig<20>> turned;
  const double c = std::cos(M_PI / 8), s = std::sin(M_PI / 8);
  plain.simulator.want_pose(0, {{0, 0, 0, c, 0, 0, s}});
  const Twist spin{{0, 0, 0, 3.0, 1.0, 2.0}};
  plain.simulator.want_twist(0, spin);
  turned.simulator.want_twist(0, spin);
  plain.reset();
  turned.reset();
  for (int i = 0; i < 100; ++i) {
    plain.tick();
    turned.tick();
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_NEAR(plain.simulator.state(0).angular_velocity[k],
                  turned.simulator.state(0).angular_velocity[k], 1e-9);
    }
  }
  EXPECT_GT(std::abs(plain.simulator.state(0).angular_velocity[0] - 3.0), 0.1);  // it tumbles
}

constexpr double kRadius = 0.05, kLength = 0.4;

constexpr RigidGeometry lying(const char* name, ShapeKind kind) {
  return {.name = name,
          .kind = kind,
          .body = name,
          .size = {{kRadius, kLength, 0.0}},
          .rotation = {{kHalf, 0.0, kHalf, 0.0}}};  // along x
}

/// Shapes along x, a step that is part of the world and turned, and a plane.
struct Shapes {
  using Real = double;
  static constexpr std::array<RigidBody, 3> kBodies = {
      {{.name = "roller", .inertia = {{0.01, 0.01, 0.01}}, .position = {{0.0, 0.0, 0.06}}},
       {.name = "capsule", .inertia = {{0.01, 0.01, 0.01}}, .position = {{2.0, 0.0, 0.06}}},
       {.name = "ball", .inertia = {{0.01, 0.01, 0.01}}, .position = {{4.0, 0.0, 0.9}}}}};
  static constexpr std::array<RigidJoint, 0> kJoints = {};
  static constexpr std::array<RigidGeometry, 5> kGeometries = {
      {lying("roller", ShapeKind::cylinder), lying("capsule", ShapeKind::capsule),
       RigidGeometry{.name = "ball", .body = "ball", .size = {{kRadius, 0.0, 0.0}}},
       RigidGeometry{.name = "step",
                     .kind = ShapeKind::box,
                     .size = {{0.2, 0.2, 1.6}},
                     .position = {{4.0, 0.0, 0.5}},
                     .rotation = {{kHalf, 0.0, kHalf, 0.0}}},  // 1.6 m along x, 0.2 m high
       RigidGeometry{.name = "ground", .kind = ShapeKind::plane}}};
};

TEST(Shapes, LieAsTheyAreTurned) {
  Scene<Shapes, RigidConfig<20>> scene;
  for (int i = 0; i < 200; ++i) scene.tick();
  EXPECT_NEAR(scene.simulator.state(0).position[2], kRadius, 1e-3);
  EXPECT_NEAR(scene.simulator.state(1).position[2], kRadius, 1e-3);
  EXPECT_NEAR(scene.simulator.state(2).position[2], 0.5 + 0.1 + kRadius, 1e-3);
  EXPECT_EQ(scene.engine.dropped_contacts(), 0U);
}

TEST(Shapes, CylindersRollAboutTheirAxis) {
  Scene<Shapes, RigidConfig<20>> scene;
  scene.simulator.want_twist(0, {{0.0, 0.5, 0.0, -0.5 / kRadius, 0.0, 0.0}});
  scene.reset();
  for (int i = 0; i < 50; ++i) scene.tick();
  const RigidState state = scene.simulator.state(0);
  EXPECT_NEAR(state.velocity[1], 0.5, 0.05);
  EXPECT_NEAR(state.angular_velocity[0], -state.velocity[1] / kRadius, 0.5);
  EXPECT_NEAR(state.position[0], 0.0, 0.01);
}

}  // namespace
}  // namespace eagerx::models::testing

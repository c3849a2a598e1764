// Joints of every kind: where reset puts them, which way they turn, motors and servos.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/rigid/rigid_io.hpp"

namespace eagerx::models::testing {
namespace {

constexpr RigidBody link(const char* name, double z) {
  return {
      .name = name, .mass = 0.5, .inertia = {{0.01, 0.012, 0.008}}, .position = {{0.05, 0.02, z}}};
}

/// A chain with a joint of every kind, away from the origin.
struct Chain {
  using Real = double;
  static constexpr Vector3 kOrigin{{0.5, -1.0, 2.0}};
  static constexpr std::array<RigidBody, 5> kBodies = {
      {link("a", 0.0), link("b", 0.3), link("c", 0.6), link("d", 0.9), link("e", 1.2)}};
  static constexpr std::array<RigidJoint, 5> kJoints = {
      {{.name = "slide", .kind = JointKind::slider, .child = "a", .axis = {{0.6, 0.8, 0.0}}},
       {.name = "turn",
        .parent = "a",
        .child = "b",
        .anchor = {{0.0, 0.1, 0.15}},
        .axis = {{0.0, 0.6, 0.8}}},
       {.name = "cross",
        .kind = JointKind::universal,
        .parent = "b",
        .child = "c",
        .anchor = {{0.0, 0.0, 0.45}},
        .axis = {{1.0, 0.0, 0.0}},
        .axis2 = {{0.0, 1.0, 0.0}}},
       {.name = "ball",
        .kind = JointKind::ball,
        .parent = "c",
        .child = "d",
        .anchor = {{0.0, 0.0, 0.75}}},
       {.name = "weld", .kind = JointKind::fixed, .parent = "d", .child = "e"}}};
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};
};
static_assert(scene::find(Chain::kJoints, "cross") == 2);
static_assert(scene::count_names(" slide  cross ") == 2);

template <class Simulator>
void want_all(Simulator& simulator) {
  simulator.want_joint(0, {{0.2, 0.0}, {0.3, 0.0}});
  simulator.want_joint(1, {{-1.1, 0.0}, {0.7, 0.0}});
  simulator.want_joint(2, {{0.4, -0.9}, {-0.5, 0.6}});
}

/// A rod whose damping is ten times its inertia by the step.
struct Damped {
  using Real = double;
  static constexpr std::array<RigidBody, 1> kBodies = {
      {{.name = "rod", .inertia = {{0.1, 0.1, 0.01}}}}};
  static constexpr std::array<RigidJoint, 1> kJoints = {
      {{.name = "j", .child = "rod", .damping = 1000.0}}};
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};
};

TEST(RigidJoints, DampingFarAboveInertiaPerStepIsStable) {
  Scene<Damped, RigidConfig<20>> scene;  // 1 ms
  scene.simulator.want_joint(0, {{0.0, 0.0}, {5.0, 0.0}});
  scene.reset();
  scene.simulator.set_joint_torque(0, 50.0);
  for (int i = 0; i < 50; ++i) scene.tick();
  EXPECT_NEAR(scene.simulator.joint_velocity(0), 0.05, 1e-3);  // torque/damping
}

TEST(Joints, ResetPutsThemWhereItSays) {
  Scene<Chain, WeightlessConfig<20>> scene;
  want_all(scene.simulator);
  scene.reset();
  const auto& s = scene.simulator;
  EXPECT_NEAR(s.joint_position(0), 0.2, 1e-12);
  EXPECT_NEAR(s.joint_position(1), -1.1, 1e-12);
  EXPECT_NEAR(s.joint_position(2, 0), 0.4, 1e-12);
  EXPECT_NEAR(s.joint_position(2, 1), -0.9, 1e-12);
  EXPECT_NEAR(s.joint_velocity(0), 0.3, 1e-12);
  EXPECT_NEAR(s.joint_velocity(1), 0.7, 1e-12);
  EXPECT_NEAR(s.joint_velocity(2, 0), -0.5, 1e-12);
  EXPECT_NEAR(s.joint_velocity(2, 1), 0.6, 1e-12);
  EXPECT_NEAR(s.state(0).position[0], 0.5 + 0.05 + 0.2 * 0.6, 1e-12);
}

/// The library agrees about places and velocities: its constraints have nothing to correct, and
/// positions continue as velocities say.
TEST(Joints, ResetLeavesNothingToCorrect) {
  Scene<Chain, WeightlessConfig<2000>> scene;
  want_all(scene.simulator);
  scene.reset();
  std::array<RigidState, 5> before;
  for (std::size_t b = 0; b < 5; ++b) before[b] = scene.simulator.state(b);
  scene.tick();  // 2000 steps of 10 µs
  for (std::size_t b = 0; b < 5; ++b) {
    const RigidState now = scene.simulator.state(b);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(now.position[i], before[b].position[i] + kPeriod * before[b].velocity[i], 2e-3)
          << b;
      EXPECT_NEAR(now.velocity[i], before[b].velocity[i], 0.1) << b;
    }
  }
  EXPECT_NEAR(scene.simulator.joint_position(1), -1.1 + 0.02 * 0.7, 2e-3);
  EXPECT_NEAR(scene.simulator.joint_position(2, 1), -0.9 + 0.02 * 0.6, 2e-3);
}

TEST(Joints, WhatAResetLeavesOutStaysAsItIs) {
  Scene<Chain, WeightlessConfig<20>> scene;
  want_all(scene.simulator);
  scene.reset();
  for (int i = 0; i < 5; ++i) scene.tick();
  const double slide = scene.simulator.joint_position(0),
               cross = scene.simulator.joint_position(2, 1);
  scene.simulator.want_joint(1, {{0.3, 0.0}, {0.0, 0.0}});
  scene.reset();
  EXPECT_NEAR(scene.simulator.joint_position(0), slide, 1e-12);
  EXPECT_NEAR(scene.simulator.joint_position(1), 0.3, 1e-12);
  EXPECT_NEAR(scene.simulator.joint_position(2, 1), cross, 1e-9);
  const RigidState before = scene.simulator.state(4);
  scene.reset();
  EXPECT_EQ(scene.simulator.state(4).position, before.position);
}

/// A wheel and a cart that are free to move.
struct Wheel {
  using Real = double;
  static constexpr std::array<RigidBody, 2> kBodies = {
      {{.name = "wheel", .mass = 1.0, .inertia = {{0.1, 0.1, 0.1}}},
       {.name = "cart", .mass = 2.0, .position = {{0.0, 1.0, 0.0}}}}};
  static constexpr std::array<RigidJoint, 2> kJoints = {
      {{.name = "axle", .child = "wheel", .axis = {{0.0, 0.0, 1.0}}},
       {.name = "rail", .kind = JointKind::slider, .child = "cart", .axis = {{1.0, 0.0, 0.0}}}}};
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};
};

TEST(Joints, TurnsAreCountedInBothDirections) {
  Scene<Wheel, RigidConfig<20>> scene;
  for (const double start : {0.0, 20.0, -7.5}) {
    for (const double speed : {30.0, -30.0}) {
      scene.simulator.want_joint(0, {{start, 0.0}, {speed, 0.0}});
      scene.reset();
      EXPECT_NEAR(scene.simulator.joint_position(0), start, 1e-9);
      for (int i = 1; i <= 100; ++i) {
        scene.tick();
        ASSERT_NEAR(scene.simulator.joint_position(0), start + speed * i * kPeriod, 0.02);
      }
    }
  }
}

TEST(Joints, TurnsBeyondAllThatADoubleCountsAreTheMost) {
  constexpr std::int64_t kMost = std::int64_t{1} << 52;
  for (const double sign : {1.0, -1.0}) {
    TurnCounter counter;
    counter.begin(sign * 1e300, 1.0, 0.0);
    EXPECT_EQ(counter.turns, static_cast<std::int64_t>(sign) * kMost);
  }
}

TEST(Joints, TorqueIsPositiveAboutTheAxis) {
  Scene<Wheel, RigidConfig<20>> scene;
  scene.simulator.set_joint_torque(0, 0.5);
  scene.simulator.set_joint_torque(1, -4.0);
  for (int i = 0; i < 50; ++i) scene.tick();
  EXPECT_NEAR(scene.simulator.joint_velocity(0), 5.0, 1e-6);  // 0.5 N·m, 0.1 kg·m², 1 s
  EXPECT_NEAR(scene.simulator.joint_velocity(1), -2.0, 1e-6);
  EXPECT_EQ(scene.simulator.joint_torque(1), -4.0);
}

TEST(Joints, MotorsReachTheirVelocityWithTheirTorque) {
  Scene<Wheel, RigidConfig<20>> scene;
  scene.simulator.set_joint_motor(0, 3.0, 0.5);   // 5 rad/s² at most
  scene.simulator.set_joint_motor(1, -1.0, 8.0);  // 4 m/s²
  for (int i = 0; i < 10; ++i) scene.tick();
  EXPECT_NEAR(scene.simulator.joint_velocity(0), 1.0, 1e-6);
  EXPECT_NEAR(scene.simulator.joint_velocity(1), -0.8, 1e-6);
  for (int i = 0; i < 40; ++i) scene.tick();
  EXPECT_NEAR(scene.simulator.joint_velocity(0), 3.0, 1e-6);
  EXPECT_NEAR(scene.simulator.joint_velocity(1), -1.0, 1e-6);
}

TEST(Joints, ServosReachTheirPosition) {
  Scene<Wheel, RigidConfig<20>> scene;
  scene.simulator.set_joint_servo(
      0, {.position = 1.5, .stiffness = 10.0, .damping = 2.0, .max_torque = 3.0});
  for (int i = 0; i < 200; ++i) scene.tick();
  EXPECT_NEAR(scene.simulator.joint_position(0), 1.5, 1e-3);
}

/// A rod on a hinge with stops at `Tenths` tenths of half a turn on both sides.
template <int kTenths>
struct Stopped {
  using Real = double;
  static constexpr double kStop = 0.314159265358979 * kTenths;
  static constexpr std::array<RigidBody, 1> kBodies = {
      {{.name = "rod", .inertia = {{0.1, 0.1, 0.01}}}}};
  static constexpr std::array<RigidJoint, 1> kJoints = {
      {{.name = "j", .child = "rod", .low = -kStop, .high = kStop}}};
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};
};

/// Below, at and beyond half a turn: pressed against the stop, and away from it.
template <int kTenths>
void check_stop() {
  Scene<Stopped<kTenths>, WeightlessConfig<20>> scene;
  const double stop = Stopped<kTenths>::kStop;
  for (const double side : {1.0, -1.0}) {
    scene.simulator.want_joint(0, {{side * (stop - 0.5), 0.0}, {0.0, 0.0}});
    scene.simulator.set_joint_torque(0, side * 0.5);
    scene.reset();
    double furthest = 0.0;
    for (int i = 0; i < 250; ++i) {
      scene.tick();
      furthest = std::max(furthest, side * scene.simulator.joint_position(0));
    }
    EXPECT_NEAR(furthest, stop, 5e-3) << kTenths;
    EXPECT_NEAR(side * scene.simulator.joint_position(0), stop, 5e-3) << kTenths;
    EXPECT_LT(std::abs(scene.simulator.joint_velocity(0)), 0.1) << kTenths;
    scene.simulator.set_joint_torque(0, -side * 0.5);
    for (int i = 0; i < 50; ++i) scene.tick();  // half of 5 rad/s², 1 s
    EXPECT_NEAR(side * scene.simulator.joint_position(0), stop - 2.5, 0.1) << kTenths;
  }
}

TEST(RigidJoints, StopsHoldBelowAtAndBeyondHalfATurn) {
  check_stop<5>();
  check_stop<9>();
  check_stop<10>();  // 3.14159: the library's own stop lets the joint through
  check_stop<11>();
  check_stop<20>();
  check_stop<37>();
}

/// A forearm and a hand whose inertia is far too small for the gains of the servos in steps of 1
/// ms, as the wrist of an industrial arm.
struct Wrist {
  using Real = double;
  static constexpr std::array<RigidBody, 2> kBodies = {{{.name = "forearm",
                                                         .mass = 2.0,
                                                         .inertia = {{0.02, 0.02, 0.002}},
                                                         .position = {{0.2, 0.0, 0.0}}},
                                                        {.name = "hand",
                                                         .mass = 0.2,
                                                         .inertia = {{1e-4, 1e-4, 1e-4}},
                                                         .position = {{0.4, 0.0, 0.0}}}}};
  static constexpr std::array<RigidJoint, 2> kJoints = {
      {{.name = "elbow", .child = "forearm", .max_torque = 150.0},
       {.name = "wrist",
        .parent = "forearm",
        .child = "hand",
        .anchor = {{0.4, 0.0, 0.0}},
        .max_torque = 28.0,
        .damping = 2.0}}};
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};
};

TEST(RigidJoints, ServosFarAboveInertiaPerStepAreStable) {
  Scene<Wrist, RigidConfig<20>> scene;
  for (std::size_t j = 0; j < 2; ++j)
    scene.simulator.set_joint_servo(
        j, {.position = 0.3, .stiffness = 500.0, .damping = 20.0, .max_torque = 100.0});
  double fastest = 0.0;
  for (int i = 0; i < 250; ++i) {
    scene.tick();
    fastest = std::max(fastest, std::abs(scene.simulator.joint_velocity(1)));
  }
  EXPECT_LT(fastest, 15.0);
  // Gravity turns about y, so that the elbow sinks by its torque over its stiffness.
  const double angle = scene.simulator.joint_position(0);
  const double torque = 9.81 * std::cos(angle) * (2.0 * 0.2 + 0.2 * 0.4);
  EXPECT_NEAR(angle, 0.3 + torque / 500.0, 1e-4);
  EXPECT_NEAR(scene.simulator.joint_torque(0), -torque, 1e-2);
  EXPECT_NEAR(scene.simulator.joint_position(1), 0.3, 1e-4);
  EXPECT_LT(std::abs(scene.simulator.joint_velocity(1)), 1e-6);
}

/// Next to a motor, damping is a torque of the step's beginning.
TEST(RigidJoints, DampingNextToAMotorIsStable) {
  Scene<Wrist, RigidConfig<20>> scene;
  scene.simulator.set_joint_servo(
      0, {.position = 0.0, .stiffness = 500.0, .damping = 20.0, .max_torque = 100.0});
  scene.simulator.set_joint_motor(1, 0.0, 5.0);  // 2 N·m·s/rad, 1e-4 kg·m²: 20 times too much
  scene.simulator.want_joint(1, {{0.0, 0.0}, {3.0, 0.0}});
  scene.reset();
  double fastest = 0.0;
  for (int i = 0; i < 100; ++i) {
    scene.tick();
    fastest = std::max(fastest, std::abs(scene.simulator.joint_velocity(1)));
  }
  EXPECT_LT(fastest, 1e-3);
}

/// Where the library would abort, the program says which joint moves and in which step.
void push_far_too_hard() {
  Scene<Wrist, RigidConfig<20>> scene;
  scene.simulator.set_force(1, {{0.0, 0.0, 1e200}});
  for (int i = 0; i < 50; ++i) scene.tick();
}
TEST(RigidJointsDeathTest, WhatTheLibraryGivesUpIsSaid) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(push_far_too_hard(), ::testing::ExitedWithCode(1),
              "gives up in step [0-9]+ of the episode: [^`]*The fastest joint is `(wrist|elbow)`, "
              "at [^`]* raise `substeps`");
}

}  // namespace
}  // namespace eagerx::models::testing

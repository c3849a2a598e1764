// Springs of joints: closed forms, steps far too long for an explicit spring, both engines.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/unit/multibody/multibody_io.hpp"
#include "tests/unit/rigid/rigid_io.hpp"

namespace eagerx::models::testing {
namespace {

constexpr double kRest = 0.3;

/// A body of 0.1 kg·m² and 2 kg on one joint.
template <JointKind kKind, int kStiffness, int kDampingInTenths = 0, int kFrictionInTenths = 0>
struct Sprung {
  using Real = double;
  static constexpr std::array<RigidBody, 1> kBodies = {
      {{.name = "body", .mass = 2.0, .inertia = {{0.1, 0.1, 0.1}}}}};
  static constexpr std::array<RigidJoint, 1> kJoints = {{{.name = "j",
                                                          .kind = kKind,
                                                          .child = "body",
                                                          .axis = {{0.6, 0.0, 0.8}},
                                                          .damping = 0.1 * kDampingInTenths,
                                                          .friction = 0.1 * kFrictionInTenths,
                                                          .stiffness = kStiffness,
                                                          .rest = kRest}}};
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};
};

struct Swing {
  double period = 0.0;     // mean [s]
  double decrement = 0.0;  // logarithmic, of a period
};
/// From 0.5 from its rest, over ten periods.
template <class Scene>
Swing swing(Scene&& scene) {
  scene.simulator.want_joint(0, {{kRest + 0.5, 0.0}, {0.0, 0.0}});
  scene.reset();
  double before = 0.5, peak = 0.0, first_peak = 0.0, first = 0.0, last = 0.0;
  int crossings = 0;
  for (int i = 1; crossings < 11; ++i) {
    if (i == 10000) ADD_FAILURE() << "it does not swing";
    if (i == 10000) return {};
    scene.tick();
    const double now = scene.simulator.joint_position(0) - kRest;
    peak = std::max(peak, now);
    if (before < 0.0 && now >= 0.0) {
      last = 0.02 * (i - now / (now - before));
      if (crossings == 0) first = last;
      if (crossings == 1) first_peak = peak;
      peak = 0.0, ++crossings;
      if (crossings == 11) break;
    }
    before = now;
  }
  double at_end = 0.0;  // the peak after the last crossing
  for (int i = 0; i < 20; ++i) {
    scene.tick();
    at_end = std::max(at_end, scene.simulator.joint_position(0) - kRest);
  }
  return {(last - first) / 10.0, std::log(first_peak / at_end) / 10.0};
}

/// Of a spring with a frequency [rad/s] and a ratio of damping, to which a step adds ω·dt/2.
void expect_closed_form(const Swing& found, double frequency, double ratio, double step_s) {
  const double kTwoPi = 6.283185307179586;
  const double all = ratio + 0.5 * frequency * step_s;
  const double root = std::sqrt(1.0 - ratio * ratio);
  EXPECT_NEAR(found.period, kTwoPi / (frequency * root), 1e-3 * kTwoPi / frequency);
  EXPECT_NEAR(found.decrement, kTwoPi * all / std::sqrt(1.0 - all * all), 0.01);
}

TEST(RigidSprings, PeriodAndDecayAreThoseOfTheClosedForm) {
  using Hinge = Sprung<JointKind::hinge, 10>;    // 10 rad/s
  using Slider = Sprung<JointKind::slider, 50>;  // 5 rad/s
  expect_closed_form(swing(Scene<Hinge, WeightlessConfig<20>>()), 10.0, 0.0, 0.001);
  expect_closed_form(swing(Scene<Hinge, WeightlessConfig<80>>()), 10.0, 0.0, 0.00025);
  expect_closed_form(swing(Scene<Slider, WeightlessConfig<20>>()), 5.0, 0.0, 0.001);
  // 0.1 N·m·s/rad is a ratio of damping of 0.05, 1 N·s/m one of 0.05.
  using DampedHinge = Sprung<JointKind::hinge, 10, 1>;
  using DampedSlider = Sprung<JointKind::slider, 50, 10>;
  expect_closed_form(swing(Scene<DampedHinge, WeightlessConfig<20>>()), 10.0, 0.05, 0.001);
  expect_closed_form(swing(Scene<DampedSlider, WeightlessConfig<20>>()), 5.0, 0.05, 0.001);
}

/// 1e8 N·m/rad and 0.1 kg·m²: an explicit spring is stable in steps below 0.06 ms.
template <class Model, class Config>
void check_stiff() {
  Scene<Model, Config> scene;
  scene.simulator.want_joint(0, {{kRest + 1e-3, 0.0}, {5.0, 0.0}});
  scene.reset();
  for (int i = 0; i < 50; ++i) {
    scene.tick();
    ASSERT_LT(std::abs(scene.simulator.joint_velocity(0)), 1.0);
    ASSERT_LT(std::abs(scene.simulator.joint_position(0) - kRest), 2e-3);
  }
  EXPECT_NEAR(scene.simulator.joint_position(0), kRest, 1e-6);
  EXPECT_NEAR(scene.simulator.joint_velocity(0), 0.0, 1e-6);
}
TEST(RigidSprings, StiffOnesAreStableInStepsOfOneAndTwentyMilliseconds) {
  check_stiff<Sprung<JointKind::hinge, 100000000>, RigidConfig<20>>();
  check_stiff<Sprung<JointKind::hinge, 100000000>, RigidConfig<1>>();
  check_stiff<Sprung<JointKind::hinge, 100000000, 5, 20>, RigidConfig<20>>();
  check_stiff<Sprung<JointKind::slider, 100000000>, RigidConfig<20>>();
  check_stiff<Sprung<JointKind::slider, 100000000>, RigidConfig<1>>();
  check_stiff<Sprung<JointKind::slider, 100000000>, QuickConfig<20>>();
}

/// Two free bodies with a spring between them, off their centers: the parent is 1,000 times
/// lighter.
struct Apart {
  using Real = double;
  static constexpr std::array<RigidBody, 2> kBodies = {
      {{.name = "light", .mass = 0.002, .inertia = {{1e-5, 1e-5, 1e-5}}},
       {.name = "heavy",
        .mass = 2.0,
        .inertia = {{0.01, 0.01, 0.01}},
        .position = {{0.2, 0.1, 0.3}}}}};
  static constexpr std::array<RigidJoint, 1> kJoints = {{{.name = "j",
                                                          .kind = JointKind::slider,
                                                          .parent = "light",
                                                          .child = "heavy",
                                                          .axis = {{0.0, 0.6, 0.8}},
                                                          .stiffness = 1e6}}};
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};
};
TEST(RigidSprings, TheySpareMomentum) {
  Scene<Apart, WeightlessConfig<20>> scene;
  scene.simulator.want_joint(0, {{0.05, 0.0}, {0.0, 0.0}});
  scene.reset();
  const RigidState start[2] = {scene.simulator.state(0), scene.simulator.state(1)};
  for (int i = 0; i < 50; ++i) scene.tick();
  const RigidState end[2] = {scene.simulator.state(0), scene.simulator.state(1)};
  EXPECT_NEAR(scene.simulator.joint_position(0), 0.0, 1e-6);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(0.002 * end[0].velocity[i] + 2.0 * end[1].velocity[i], 0.0, 1e-9);
    EXPECT_NEAR(0.002 * (end[0].position[i] - start[0].position[i]) +
                    2.0 * (end[1].position[i] - start[1].position[i]),
                0.0, 1e-9);
    EXPECT_NEAR(end[1].angular_velocity[i], 0.0, 1e-6) << "a force along the axis turns nothing";
  }
}

TEST(RigidSprings, FrictionHoldsThem) {
  using Rubbing = Sprung<JointKind::hinge, 10, 0, 10>;  // 1 N·m holds 0.1 rad
  Scene<Rubbing, WeightlessConfig<80>> scene;           // 0.25 ms
  scene.simulator.want_joint(0, {{kRest + 0.09, 0.0}, {0.0, 0.0}});
  scene.reset();
  for (int i = 0; i < 50; ++i) scene.tick();
  EXPECT_NEAR(scene.simulator.joint_position(0), kRest + 0.09, 1e-6);
  // Coulomb: each half swing ends 0.2 rad nearer to the rest, so at 0.55, -0.35, 0.15, 0.05 rad.
  // The step adds a ratio of damping of 0.00125, which leaves 0.053 rad.
  scene.simulator.want_joint(0, {{kRest + 0.55, 0.0}, {0.0, 0.0}});
  scene.reset();
  for (int i = 0; i < 100; ++i) scene.tick();
  EXPECT_NEAR(scene.simulator.joint_position(0), kRest + 0.05, 0.004);
  EXPECT_NEAR(scene.simulator.joint_velocity(0), 0.0, 1e-6);
}

TEST(RigidSprings, ActuatorsWorkAgainstThem) {
  Scene<Sprung<JointKind::hinge, 10, 10>, WeightlessConfig<20>> scene;
  scene.simulator.set_joint_torque(0, 2.0);
  for (int i = 0; i < 200; ++i) scene.tick();
  EXPECT_NEAR(scene.simulator.joint_position(0), kRest + 0.2, 1e-5);
  scene.simulator.set_joint_servo(
      0, {.position = 0.0, .stiffness = 5e4, .damping = 10.0, .max_torque = 100.0});
  for (int i = 0; i < 200; ++i) scene.tick();
  EXPECT_NEAR(scene.simulator.joint_position(0), 3.0 / 50010.0, 1e-7);
  EXPECT_NEAR(scene.simulator.joint_torque(0), -3.0, 1e-3);
  scene.simulator.set_joint_servo(0, {});
  scene.simulator.set_joint_motor(0, 0.5, 100.0);
  for (int i = 0; i < 50; ++i) scene.tick();
  EXPECT_NEAR(scene.simulator.joint_velocity(0), 0.5, 1e-6);
}

/// An arm with a spring on each joint, one of them firm, that gravity pulls down; the forearm
/// slides.
struct SprungArm {
  using Real = double;
  static constexpr std::array<RigidBody, 3> kBodies = {{{.name = "upper",
                                                         .mass = 1.0,
                                                         .inertia = {{0.002, 0.02, 0.02}},
                                                         .position = {{0.2, 0.0, 0.0}}},
                                                        {.name = "lower",
                                                         .mass = 0.7,
                                                         .inertia = {{0.001, 0.01, 0.01}},
                                                         .position = {{0.6, 0.05, 0.0}}},
                                                        {.name = "hand",
                                                         .mass = 0.3,
                                                         .inertia = {{4e-4, 4e-4, 4e-4}},
                                                         .position = {{0.9, 0.0, 0.02}}}}};
  static constexpr std::array<RigidJoint, 3> kJoints = {
      {{.name = "shoulder", .child = "upper", .damping = 0.2, .stiffness = 20.0, .rest = -0.2},
       {.name = "elbow",
        .parent = "upper",
        .child = "lower",
        .anchor = {{0.4, 0.0, 0.0}},
        .axis = {{0.0, 0.8, 0.6}},
        .damping = 0.05,
        .stiffness = 8.0,
        .rest = 0.5},
       {.name = "slide",
        .kind = JointKind::slider,
        .parent = "lower",
        .child = "hand",
        .axis = {{1.0, 0.0, 0.0}},
        .damping = 1.0,
        .stiffness = 2000.0}}};
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};
};

/// The largest difference of a position between the engines over two seconds.
template <int kSubsteps>
double difference_of_engines() {
  Scene<SprungArm, RigidConfig<kSubsteps>> library;
  MultibodyScene<SprungArm, MultibodyConfig<kSubsteps>> own;
  library.simulator.want_joint(0, {{0.4, 0.0}, {0.0, 0.0}});
  own.simulator.want_joint(0, {{0.4, 0.0}, {0.0, 0.0}});
  library.reset();
  own.reset();
  double largest = 0.0, range = 0.0;
  for (int i = 0; i < 100; ++i) {
    library.tick();
    own.tick();
    for (std::size_t j = 0; j < 3; ++j) {
      const double one = library.simulator.joint_position(j),
                   other = own.simulator.joint_position(j);
      largest = std::max(largest, std::abs(one - other));
      range = std::max(range, std::abs(one));
    }
  }
  EXPECT_GT(range, 0.5) << "it swings";
  return largest;
}
TEST(RigidSprings, BothEnginesSwingAlike) {
  const double coarse = difference_of_engines<20>(), fine = difference_of_engines<40>();
  std::printf("difference of the engines: %.2e at 1 ms, %.2e at 0.5 ms\n", coarse, fine);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_NEAR(coarse / fine, 2.0, 0.4) << "of first order in the step";
}

}  // namespace
}  // namespace eagerx::models::testing

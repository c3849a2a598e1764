// Contacts with the ground: friction, drops, standing, slopes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/multibody/multibody_io.hpp"
#include "tests/unit/multibody/robots.hpp"

namespace eagerx::models::testing {
namespace {

constexpr double kWeight = 2.0 * 9.81;  // of the box [N]

TEST(MultibodyContact, BoxSlidesAsCoulombSays) {
  for (const double angle : {0.0, 1.0, 2.5, -2.0}) {
    MultibodyScene<BoxOf<double>> scene;
    scene.simulator.want_twist(0, {{1.5 * std::cos(angle), 1.5 * std::sin(angle), 0, 0, 0, 0}});
    scene.reset();
    scene.run(1.0);
    const auto pose = scene.simulator.pose(0);
    EXPECT_NEAR(std::hypot(pose[0], pose[1]), 1.5 * 1.5 / (2 * 0.5 * 9.81), 2e-3);
    EXPECT_NEAR(std::atan2(pose[1], pose[0]), angle, 1e-3);
    EXPECT_NEAR(pose[2], 0.05, 1e-5);
    const auto force = scene.simulator.contact_force(0), ground = scene.simulator.contact_force(1);
    EXPECT_NEAR(force[2], kWeight, 1e-6);
    EXPECT_EQ(ground[2], -force[2]);
  }
}

struct Bouncing : BoxOf<double> {
  static constexpr std::array<RigidGeometry, 2> kGeometries = [] {
    auto geometries = BoxOf<double>::kGeometries;
    geometries[0].bounce = 0.6;
    return geometries;
  }();
};

TEST(MultibodyContact, ABoxBouncesToTheSquareOfItsShare) {
  MultibodyScene<Bouncing> scene;
  scene.simulator.want_pose(0, {{0.0, 0.0, 1.05, 1.0, 0.0, 0.0, 0.0}});
  scene.reset();
  scene.run(0.5);  // the impact is at 0.452 s
  double top = 0.0;
  for (int i = 0; i < 25; ++i) {
    scene.tick();
    top = std::max(top, scene.simulator.pose(0)[2]);
  }
  EXPECT_NEAR(top, 0.05 + 0.6 * 0.6, 0.02);
  scene.run(4.0);
  EXPECT_NEAR(scene.simulator.pose(0)[2], 0.05, 1e-5);
  EXPECT_LT(std::abs(scene.simulator.twist(0)[2]), 1e-6);
}

/// Speed after a second on a slope; the gravity is tilted.
double slide(double angle) {
  MultibodyScene<BoxOf<double>> scene;
  scene.simulator.set_gravity({{9.81 * std::sin(angle), 0.0, -9.81 * std::cos(angle)}});
  scene.reset();
  scene.run(1.0);
  return scene.simulator.twist(0)[0];
}

TEST(MultibodyContact, TheConeOfFrictionIsExact) {
  const double limit = std::atan(0.5);
  EXPECT_LT(std::abs(slide(0.99 * limit)), 1e-6);
  const double steep = 1.02 * limit;
  const double expected = 9.81 * (std::sin(steep) - 0.5 * std::cos(steep));
  EXPECT_NEAR(slide(steep), expected, 0.02 * expected);
}

TEST(MultibodyContact, BoxThatTumblesLosesEnergyAndLiesDown) {
  MultibodyScene<BoxOf<float>> scene;
  scene.simulator.want_pose(0, {{0.0, 0.0, 0.5, 0.9, 0.3, 0.25, 0.1}});
  scene.simulator.want_twist(0, {{1.0, 0.0, 0.0, 3.0, 5.0, 0.0}});
  scene.reset();
  const Vector3 inertia = BoxOf<float>::kBodies[0].inertia;
  const auto energy = [&] {
    const RigidState s = scene.simulator.state(0);
    const Vector3 w = rotate(inverse(s.rotation), s.angular_velocity);
    double sum = 2.0 * 9.81 * s.position[2] + dot(s.velocity, s.velocity);
    for (std::size_t i = 0; i < 3; ++i) sum += 0.5 * inertia[i] * w[i] * w[i];
    return sum;
  };
  double least = energy(), rise = 0.0;
  for (int i = 0; i < 200; ++i) {
    scene.tick();
    rise = std::max(rise, energy() - least);
    least = std::min(least, energy());
  }
  const auto pose = scene.simulator.pose(0);
  const auto twist = scene.simulator.twist(0);
  std::printf("box: energy rises by %.1e J at most\n", rise);
  EXPECT_LT(rise, 0.05);
  EXPECT_NEAR(pose[2], 0.05F, 2e-3F);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_LT(std::abs(twist[i]), 1e-3F);
}

template <class Scene>
void let_walker_stand(Scene& scene, double height) {
  using Real = typename Scene::Real;
  constexpr double kHome[3] = {0.0, 0.9, -1.8};
  scene.simulator.want_pose(0, {{0.0, 0.0041, height, 1.0, 0.0, 0.0, 0.0}});
  for (std::size_t j = 0; j < 12; ++j) {
    scene.simulator.want_joint(j, {{kHome[j % 3], 0.0}, {0.0, 0.0}});
    scene.simulator.set_joint_servo(j, {Real(kHome[j % 3]), Real(40), Real(3), Real(33.5)});
  }
  scene.reset();
}
constexpr double kWalkerMass = 6.0 + 4 * (0.696 + 1.013 + 0.226);

/// Drops the walker by 5 cm and lets it stand for 7 s.
template <class Real>
void check_standing(double step_s) {
  MultibodyScene<WalkerOf<Real>> scene;
  let_walker_stand(scene, 0.32);
  const multibody::ContactSettings<Real> settings{Real(2e4), Real(400), Real(0.005), Real(0.2),
                                                  static_cast<Real>(step_s)};
  const auto run = [&](double seconds, auto&& look) {
    for (int i = 0; i < static_cast<int>(seconds / step_s); ++i) {
      scene.simulator.step(settings, 4);
      look(scene.simulator.numbers());
    }
  };
  run(6.0, [](const auto&) {});
  const auto before = scene.simulator.numbers();
  double jitter = 0.0, speed = 0.0;
  run(1.0, [&](const auto& now) {
    for (std::size_t j = 0; j < 12; ++j) {
      jitter = std::max(jitter, std::abs(static_cast<double>(now.q[j] - before.q[j])));
      speed = std::max(speed, std::abs(static_cast<double>(now.v[j])));
    }
  });
  double normal = 0.0;
  for (std::size_t g = 0; g < 4; ++g)
    normal += static_cast<double>(scene.simulator.contact_force(g)[2]);
  std::printf("walker, %g ms: joints move by %.1e rad, %.1e rad/s\n", 1e3 * step_s, jitter, speed);
  EXPECT_LT(jitter, 1e-4);
  EXPECT_NEAR(normal, kWalkerMass * 9.81, 0.01);
  const auto pose = scene.simulator.pose(0);
  EXPECT_NEAR(static_cast<double>(pose[2]), 0.24, 0.02);
  EXPECT_GT(static_cast<double>(pose[3]), 0.999);
}

TEST(MultibodyContact, WalkerStandsWithoutJitterAtEveryStep) {
  for (const double step_s : {0.001, 0.002, 0.004, 0.005}) check_standing<float>(step_s);
  check_standing<double>(0.002);
}

TEST(MultibodyContact, RandomTargetsNeverBreakAWalker) {
  for (const float step_s : {0.001F, 0.005F, 0.01F}) {
    MultibodyScene<WalkerOf<float>> scene;
    let_walker_stand(scene, 0.3);
    const multibody::ContactSettings<float> settings{2e4F, 400.0F, 0.005F, 0.2F, step_s};
    unsigned state = 7;
    double fastest = 0.0, beyond = 0.0;
    for (int i = 0; i < 10000; ++i) {
      for (std::size_t j = 0; i % 20 == 0 && j < 12; ++j) {
        state = state * 1664525U + 1013904223U;
        const float target = static_cast<float>(state >> 8) / 16777216.0F * 6.0F - 3.0F;
        scene.simulator.set_joint_servo(j, {target, 80.0F, 1.0F, 33.5F});
      }
      scene.simulator.step(settings, 4);
      for (std::size_t j = 0; j < 12; ++j) {
        const RigidJoint& joint = WalkerOf<float>::kJoints[j];
        const auto q = static_cast<double>(scene.simulator.joint_position(j));
        const double speed = std::abs(static_cast<double>(scene.simulator.joint_velocity(j)));
        ASSERT_LT(speed, 200.0);  // false for NaN, too
        fastest = std::max(fastest, speed);
        beyond = std::max({beyond, q - joint.high, joint.low - q});
      }
      ASSERT_GT(scene.simulator.pose(0)[2], -0.45F);  // the trunk has no shape, legs reach as far
    }
    std::printf("random, %g ms: %.0f rad/s, %.3f rad beyond a stop\n",
                1e3 * static_cast<double>(step_s), fastest, beyond);
    EXPECT_LT(beyond, 100.0 * static_cast<double>(step_s));  // what it moves in a step
  }
}

/// A trunk of a box, a capsule or a cylinder below it: their points are compliant on the base.
template <ShapeKind kKind>
struct Bellied : WalkerOf<double> {
  static constexpr std::array<RigidGeometry, 6> kGeometries = [] {
    std::array<RigidGeometry, 6> all{};
    for (std::size_t i = 0; i < 5; ++i) all[i] = WalkerOf<double>::kGeometries[i];
    all[5] = {
        .name = "belly",
        .kind = kKind,
        .body = "trunk",
        .size = kKind == ShapeKind::box ? Vector3{{0.26, 0.18, 0.12}} : Vector3{{0.06, 0.3, 0.0}},
        .friction = 0.8,
        .rotation = kKind == ShapeKind::box ? kNoRotation
                                            : rotation({{0.0, 1.0, 0.0}}, 1.5707963267948966)};
    return all;
  }();
};

template <ShapeKind kKind>
void check_belly() {
  MultibodyScene<Bellied<kKind>> scene;
  for (std::size_t j = 0; j < 12; ++j)  // legs folded next to the trunk
    scene.simulator.want_joint(j, {{j % 3 == 0 ? 0.0 : j % 3 == 1 ? 1.6 : -2.6, 0.0}, {0.0, 0.0}});
  scene.simulator.want_pose(0, {{0.0, 0.0041, 0.2, 1.0, 0.0, 0.0, 0.0}});
  scene.reset();
  double lowest = 1.0;
  for (int i = 0; i < 150; ++i) {
    scene.tick();
    lowest = std::min(lowest, scene.simulator.pose(0)[2]);
  }
  EXPECT_GT(lowest, 0.03);  // the impact
  EXPECT_NEAR(scene.simulator.pose(0)[2], 0.06, 0.005);
  EXPECT_GT(scene.simulator.contact_force(5)[2], 10.0);
}

TEST(MultibodyContact, TheTrunkLiesOnBoxCapsuleOrCylinder) {
  check_belly<ShapeKind::box>();
  check_belly<ShapeKind::capsule>();
  check_belly<ShapeKind::cylinder>();
}

struct High : BoxOf<double> {
  static constexpr Vector3 kOrigin{{1.0, 2.0, 3.0}};
};

/// A wheel, lying or upright: a cylinder that is an object's only body.
struct Wheel {
  using Real = double;
  static constexpr std::array<RigidBody, 1> kBodies = {{{.name = "wheel",
                                                         .mass = 1.0,
                                                         .inertia = {{0.01, 0.01, 0.005}},
                                                         .position = {{0, 0, 0.1}}}}};
  static constexpr std::array<RigidJoint, 0> kJoints = {};
  static constexpr std::array<RigidGeometry, 2> kGeometries = {
      {{.name = "wheel", .kind = ShapeKind::cylinder, .body = "wheel", .size = {{0.1, 0.06, 0.0}}},
       {.name = "ground", .kind = ShapeKind::plane}}};
};

TEST(MultibodyContact, ACylinderRollsOnItsRimsAndLiesOnItsFaces) {
  MultibodyScene<Wheel> scene;
  scene.simulator.want_pose(0, {{0.0, 0.0, 0.1, 1.0, 1.0, 0.0, 0.0}});  // its axis along y
  scene.simulator.want_twist(0, {{0.5, 0.0, 0.0, 0.0, 5.0, 0.0}});
  scene.reset();
  for (int i = 0; i < 100; ++i) {
    scene.tick();
    EXPECT_NEAR(scene.simulator.pose(0)[2], 0.1, 1e-3);
  }
  EXPECT_NEAR(scene.simulator.pose(0)[0], 1.0, 1e-3);
  EXPECT_NEAR(scene.simulator.twist(0)[4], 5.0, 1e-3);
  scene.simulator.want_pose(0, {{0.0, 0.0, 0.05, 1.0, 0.05, 0.1, 0.0}});  // falls on its face
  scene.simulator.want_twist(0, {});
  scene.reset();
  scene.run(3.0);
  EXPECT_NEAR(scene.simulator.pose(0)[2], 0.03, 1e-4);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_LT(std::abs(scene.simulator.twist(0)[i]), 1e-3);
}

TEST(MultibodyContact, PlanesLieWhereTheModelSays) {
  MultibodyScene<High> scene;
  scene.reset();
  scene.run(0.5);
  const auto pose = scene.simulator.pose(0);
  EXPECT_NEAR(pose[0], 1.0, 1e-6);
  EXPECT_NEAR(pose[2], 3.05, 1e-5);
}

}  // namespace
}  // namespace eagerx::models::testing

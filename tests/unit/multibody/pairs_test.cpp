// Chosen pairs of spheres and capsules of one object.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <eagerx/simd.hpp>

#include "tests/unit/multibody/multibody_io.hpp"
#include "tests/unit/multibody/robots.hpp"
#include "tests/unit/multibody/sampler.hpp"

namespace eagerx::models::testing::pairs {
namespace {

using multibody::Vec;

/// The smallest distance of two lines, by trying.
double tried_distance(const Vec<double>& a, const Vec<double>& b, const Vec<double>& between) {
  double least = 1e9;
  for (int i = -100; i <= 100; ++i) {
    for (int k = -100; k <= 100; ++k) {
      const Vec<double> d = between + a * (0.01 * i) - b * (0.01 * k);
      least = std::min(least, std::sqrt(multibody::dot(d, d)));
    }
  }
  return least;
}
TEST(MultibodyPairs, NearestPointsOfLinesAreNearest) {
  Sampler sample;
  const auto vector = [&](double most) {
    return Vec<double>{sample(most), sample(most), sample(most)};
  };
  for (int n = 0; n < 60; ++n) {
    Vec<double> a = vector(1.0), b = vector(1.0);
    const Vec<double> between = vector(1.5);
    if (n % 5 == 1) b = a * 0.7;                   // parallel
    if (n % 5 == 2) a = Vec<double>{0, 0, 0};      // a sphere
    if (n % 5 == 3) a = b = Vec<double>{0, 0, 0};  // two
    const auto [s, t] = multibody::nearest(a, b, between);
    const Vec<double> d = between + a * s - b * t;
    const double tried = tried_distance(a, b, between);
    EXPECT_LE(std::sqrt(multibody::dot(d, d)), tried + 1e-9) << n;
    EXPECT_LE(std::max(std::abs(s), std::abs(t)), 1.0);
  }
}

/// Two balls on rails along x, 1 and 2 kg, 0.1 m in radius, 1 m apart.
template <int kBounceTenths>
struct Rails {
  using Real = double;
  static constexpr std::array<RigidBody, 2> kBodies = {
      {{.name = "left", .mass = 1.0},
       {.name = "right", .mass = 2.0, .position = {{1.0, 0.0, 0.0}}}}};
  static constexpr std::array<RigidJoint, 2> kJoints = {
      {{.name = "a", .kind = JointKind::slider, .child = "left", .axis = {{1.0, 0.0, 0.0}}},
       {.name = "b",
        .kind = JointKind::slider,
        .child = "right",
        .anchor = {{1.0, 0.0, 0.0}},
        .axis = {{1.0, 0.0, 0.0}}}}};
  static constexpr std::array<RigidGeometry, 2> kGeometries = {
      {{.name = "left", .body = "left", .size = {{0.1, 0, 0}}, .bounce = 0.1 * kBounceTenths},
       {.name = "right", .body = "right", .size = {{0.1, 0, 0}}}}};
  static constexpr std::array<std::array<const char*, 2>, 1> kPairs = {{{"left", "right"}}};
};
template <class Model>
std::array<double, 2> collide() {
  MultibodyScene<Model, WeightlessMultibody<20>> scene;
  scene.simulator.want_joint(0, {{0.0, 0.0}, {2.0, 0.0}});
  scene.simulator.want_joint(1, {{0.0, 0.0}, {-1.0, 0.0}});
  scene.reset();
  scene.run(0.2);
  EXPECT_EQ(scene.simulator.joint_velocity(0), 2.0) << "nothing before they touch";
  scene.run(0.4);
  return {scene.simulator.joint_velocity(0), scene.simulator.joint_velocity(1)};
}
TEST(MultibodyPairs, BallsThatCollideKeepTheirMomentum) {
  const auto [a, b] = collide<Rails<0>>();
  EXPECT_NEAR(a, 0.0, 1e-9) << "(1*2 - 2*1)/3";
  EXPECT_NEAR(b, 0.0, 1e-9);
  const auto [c, d] = collide<Rails<5>>();
  EXPECT_NEAR(c, -1.0, 1e-9) << "they part at half of 3 m/s";
  EXPECT_NEAR(d, 0.5, 1e-9);
}
TEST(MultibodyPairs, BallsThatPressDoNotPassThrough) {
  MultibodyScene<Rails<0>, WeightlessMultibody<20>> scene;
  scene.simulator.set_joint_torque(0, 30.0);
  scene.simulator.set_joint_torque(1, -30.0);
  scene.reset();
  scene.run(2.0);
  const double gap =
      1.0 + scene.simulator.joint_position(1) - scene.simulator.joint_position(0) - 0.2;
  EXPECT_NEAR(gap, 0.0, 1e-6);
  EXPECT_NEAR(scene.simulator.contact_force(0)[0], -30.0, 1e-6);
  EXPECT_NEAR(scene.simulator.contact_force(1)[0], 30.0, 1e-6);
}

/// A walker in weightless space whose front shanks, capsules, touch each other and the other feet.
template <class RealType>
struct Crossing : WalkerOf<RealType> {
  using Base = WalkerOf<RealType>;
  static constexpr std::array<RigidGeometry, 6> kGeometries = [] {
    std::array<RigidGeometry, 6> all{};
    for (std::size_t i = 0; i < 4; ++i) all[i] = Base::kGeometries[i];
    for (std::size_t i = 0; i < 2; ++i)
      all[4 + i] = {.name = i == 0 ? "left_shank" : "right_shank",
                    .kind = ShapeKind::capsule,
                    .body = Base::kNames[i][2],
                    .size = {{0.015, 0.16, 0.0}},
                    .position = {{-0.00435, 0.0, -0.012}},
                    .friction = 0.5};
    return all;
  }();
  static constexpr std::array<std::array<const char*, 2>, 3> kPairs = {
      {{"left_shank", "right_shank"}, {"fl_foot", "fr_foot"}, {"left_shank", "fr_foot"}}};
};
template <class Real>
void cross_legs(MultibodySimulator<Crossing<Real>>& simulator, double how) {
  for (std::size_t j = 0; j < 12; ++j) {
    const double home = j % 3 == 0 ? 0.0 : j % 3 == 1 ? 0.6 : -1.2;
    simulator.want_joint(j, {{home, 0.0}, {0.0, 0.0}});
    // Hips of the front legs turn inwards, against each other.
    const double target = j == 0 ? -0.75 : j == 3 ? 0.75 : home;
    simulator.set_joint_servo(j, {Real(target + how), Real(60), Real(2), Real(33.5)});
  }
  simulator.begin_episode();
}
TEST(MultibodyPairs, LegsThatCrossStopEachOther) {
  MultibodyScene<Crossing<double>, WeightlessMultibody<20>> scene;
  cross_legs<double>(scene.simulator, 0.0);
  scene.reset();
  double deepest = -1.0, drift = 0.0, strongest = 0.0;
  for (int i = 0; i < 100; ++i) {
    scene.tick();
    const auto left = scene.simulator.pose(3), right = scene.simulator.pose(6);
    deepest = std::max(deepest, right[1] - left[1]);
    Vector3 momentum{};
    for (std::size_t b = 0; b < 13; ++b) {
      const auto twist = scene.simulator.twist(b);
      for (std::size_t k = 0; k < 3; ++k)
        momentum[k] += Crossing<double>::kBodies[b].mass * twist[k];
    }
    drift = std::max(drift, std::sqrt(dot(momentum, momentum)));
    for (const std::size_t shape : {std::size_t{0}, std::size_t{4}}) {
      const auto force = scene.simulator.contact_force(shape);
      strongest = std::max(strongest, std::hypot(force[0], force[1], force[2]));
    }
  }
  EXPECT_LT(deepest, 0.0) << "the left leg stays on the left";
  EXPECT_LT(drift, 0.06) << "forces within the robot move nothing";
  EXPECT_GT(strongest, 5.0);
}
struct Ghost : Crossing<double> {
  static constexpr std::array<std::array<const char*, 2>, 0> kPairs = {};
};
TEST(MultibodyPairs, WithoutPairsLegsPassThroughEachOther) {
  MultibodyScene<Ghost, WeightlessMultibody<10>> scene;
  for (std::size_t j = 0; j < 12; ++j) {
    const double home = j % 3 == 0 ? 0.0 : j % 3 == 1 ? 0.6 : -1.2;
    scene.simulator.want_joint(j, {{home, 0.0}, {0.0, 0.0}});
    const double target = j == 0 ? -0.75 : j == 3 ? 0.75 : home;
    scene.simulator.set_joint_servo(j, {target, 60.0, 2.0, 33.5});
  }
  scene.reset();
  scene.run(2.0);
  EXPECT_GT(scene.simulator.pose(6)[1], scene.simulator.pose(3)[1]);
}

TEST(MultibodyPairs, LanesHaveTheBitsOfPlainNumbers) {
  constexpr std::size_t kLanes = 4;
  using One = MultibodySimulator<Crossing<float>>;
  using All = MultibodySimulator<Crossing<Simd<float, kLanes>>>;
  std::array<One, kLanes> ones{};
  All all{};
  const auto word = [](auto& many, std::size_t i, std::size_t lane) {
    return reinterpret_cast<char*>(&many) + 4 * (i * kLanes + lane);
  };
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    One& one = ones[lane];
    one.start({{0.0, 0.0, -9.81}});
    one.want_pose(0, {{0.0, 0.0, 0.35, 1.0, 0.05, 0.0, 0.0}});
    cross_legs<float>(one, 0.05 * static_cast<double>(lane));
    for (std::size_t i = 0; i < sizeof(One) / 4; ++i)
      std::memcpy(word(all, i, lane), reinterpret_cast<const char*>(&one) + 4 * i, 4);
  }
  constexpr multibody::ContactSettings<float> kSettings{2e4F, 400.0F, 0.005F, 0.2F, 0.004F};
  for (int i = 0; i < 300; ++i) {
    all.step(kSettings, 4);
    for (One& one : ones) one.step(kSettings, 4);
  }
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    One from_simd{};
    for (std::size_t i = 0; i < sizeof(One) / 4; ++i)
      std::memcpy(reinterpret_cast<char*>(&from_simd) + 4 * i, word(all, i, lane), 4);
    EXPECT_EQ(std::memcmp(&from_simd, &ones[lane], sizeof(One)), 0) << "lane " << lane;
    EXPECT_TRUE(std::isfinite(ones[lane].pose(0)[2]));
  }
}

}  // namespace
}  // namespace eagerx::models::testing::pairs

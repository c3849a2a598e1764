// Ground that is not a level plane: tilted planes and height fields.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <eagerx/simd.hpp>
#include <models/engine_states/ground_roughness/ground_roughness.hpp>

#include "tests/unit/multibody/multibody_io.hpp"
#include "tests/unit/multibody/robots.hpp"

namespace eagerx::models::testing::ground {
namespace {

constexpr double kG = 9.81;

/// Rotation from z to the normal of a plane that falls by `angle` in the direction `heading`.
Quaternion leaning(double angle, double heading) {
  return rotation({{-std::sin(heading), std::cos(heading), 0.0}}, angle);
}

/// A ball of 0.1 m on ground that falls by kAngle in the direction of kHeading.
struct Falls {
  double angle, heading;
  constexpr Vector3 normal() const {
    const double s = eagerx::sin(angle);
    return {{s * eagerx::cos(heading), s * eagerx::sin(heading), eagerx::cos(angle)}};
  }
};
constexpr Falls kGentle{0.2, 0.5}, kSteep{1.0, 2.0}, kWall{1.5707963267948966, 0.3};

template <class RealType, Falls kFalls, bool kBox>
struct Sliding {
  using Real = RealType;
  static constexpr Vector3 kOrigin{{0.3, -0.2, 0.5}};
  static constexpr double kInertia = 0.4 * 2.0 * 0.01;  // of a solid ball
  static constexpr std::array<RigidBody, 1> kBodies = {
      {{.name = "thing",
        .mass = 2.0,
        .inertia = {{kInertia, kInertia, kInertia}},
        .position = {
            {0.1 * kFalls.normal()[0], 0.1 * kFalls.normal()[1], 0.1 * kFalls.normal()[2]}}}}};
  static constexpr std::array<RigidJoint, 0> kJoints = {};
  static constexpr std::array<RigidGeometry, 2> kGeometries = {
      {{.name = "thing",
        .kind = kBox ? ShapeKind::box : ShapeKind::sphere,
        .body = "thing",
        .size = kBox ? Vector3{{0.4, 0.4, 0.2}} : Vector3{{0.1, 0.0, 0.0}},
        .friction = 0.5},
       {.name = "slope", .kind = ShapeKind::plane, .axis = kFalls.normal()}}};
};

/// Speed down the slope, and along the other two directions, after a second from rest.
template <class Model>
Vector3 speeds(const Falls& falls, double friction = 0.5) {
  MultibodyScene<Model> scene;
  const Quaternion q = leaning(falls.angle, falls.heading);
  const Vector3 at = Model::kOrigin + Model::kBodies[0].position;
  scene.simulator.set_friction(0, friction);
  scene.simulator.want_pose(0, {{at[0], at[1], at[2], q[0], q[1], q[2], q[3]}});
  scene.reset();
  scene.run(1.0);
  const RigidState s = scene.simulator.state(0);
  const auto force = scene.simulator.contact_force(0);
  const Vector3 normal = falls.normal();
  const Vector3 pushed{{static_cast<double>(force[0]), static_cast<double>(force[1]),
                        static_cast<double>(force[2])}};
  EXPECT_NEAR(dot(normal, pushed), 2.0 * kG * std::cos(falls.angle), 0.02);
  const Vector3 along = rotate(q, {{std::cos(falls.heading), std::sin(falls.heading), 0.0}});
  return {{dot(along, s.velocity), dot(cross(normal, along), s.velocity), dot(normal, s.velocity)}};
}

TEST(MultibodyGround, ABallRollsDownASlopeWithFiveSevenths) {
  const double expected = 5.0 / 7.0 * kG * std::sin(0.2);
  const Vector3 v = speeds<Sliding<double, kGentle, false>>(kGentle, 1.0);
  EXPECT_NEAR(v[0], expected, 1e-3 * expected);
  EXPECT_NEAR(v[1], 0.0, 1e-9);
  EXPECT_NEAR(v[2], 0.0, 1e-9);
  const double in_float = (speeds<Sliding<float, kGentle, false>>(kGentle, 1.0))[0];
  EXPECT_NEAR(in_float, expected, 2e-3 * expected);
}
TEST(MultibodyGround, ABallOnASteepSlopeSlips) {
  // Coulomb: it does not roll where tan(angle) > 3.5 mu.
  const Vector3 v = speeds<Sliding<double, kSteep, false>>(kSteep, 0.3);
  const double expected = kG * (std::sin(1.0) - 0.3 * std::cos(1.0));
  EXPECT_NEAR(v[0], expected, 0.02 * expected);
  EXPECT_NEAR(v[1], 0.0, 1e-6);
}

constexpr Falls at_share_of_cone(double share, double heading) {
  return {eagerx::atan(0.5) * share, heading};
}
constexpr Falls kStands = at_share_of_cone(0.99, 0.7), kSlides = at_share_of_cone(1.05, 0.7);
constexpr Falls kOtherStands = at_share_of_cone(0.99, -2.0),
                kOtherSlides = at_share_of_cone(1.05, -2.0);

template <Falls kBelow, Falls kAbove>
void check_cone() {
  const Vector3 still = speeds<Sliding<double, kBelow, true>>(kBelow);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(still[i], 0.0, 1e-6);
  const Vector3 v = speeds<Sliding<double, kAbove, true>>(kAbove);
  const double expected = kG * (std::sin(kAbove.angle) - 0.5 * std::cos(kAbove.angle));
  EXPECT_NEAR(v[0], expected, 0.02 * expected);
  EXPECT_NEAR(v[1], 0.0, 1e-6);
}
TEST(MultibodyGround, TheConeOfFrictionLeansWithThePlane) {
  check_cone<kStands, kSlides>();
  check_cone<kOtherStands, kOtherSlides>();
}
TEST(MultibodyGround, APlaneMayBeAWall) {
  MultibodyScene<Sliding<double, kWall, false>> scene;
  scene.simulator.set_gravity({{-kG * std::cos(0.3), -kG * std::sin(0.3), 0.0}});
  scene.reset();
  scene.run(1.0);
  const Vector3 start =
      Sliding<double, kWall, false>::kOrigin + Sliding<double, kWall, false>::kBodies[0].position;
  const auto pose = scene.simulator.pose(0);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(pose[i], start[i], 1e-6);
}

// ---- height fields
/// Ground of 4 m by 4 m around the origin, with heights f(x, y).
template <class F>
constexpr HeightField<41, 41> field_of(const F& f) {
  HeightField<41, 41> field{.corner = {-2.0, -2.0}, .spacing = 0.1, .height = {}};
  for (std::size_t i = 0; i < 41; ++i) {
    for (std::size_t k = 0; k < 41; ++k)
      field.height[i][k] = static_cast<float>(
          f(-2.0 + 0.1 * static_cast<double>(i), -2.0 + 0.1 * static_cast<double>(k)));
  }
  return field;
}
struct Level {
  constexpr double operator()(double /*x*/, double /*y*/) const { return 0.0; }
};
struct Slope {
  constexpr double operator()(double x, double y) const { return -0.2 * x - 0.1 * y; }
};
struct Steps {  // 3 cm high, 0.4 m wide
  constexpr double operator()(double x, double /*y*/) const {
    return x < 0.05 ? 0.0 : x < 0.45 ? 0.03 : 0.06;
  }
};
struct Bowl {
  constexpr double operator()(double x, double y) const { return 0.5 * (x * x + y * y); }
};
struct Gravel {
  constexpr double operator()(double x, double y) const {
    const auto i = static_cast<unsigned>((x + 3.0) * 10.0 + 0.5);
    const auto k = static_cast<unsigned>((y + 3.0) * 10.0 + 0.5);
    const unsigned mixed = (i * 2654435761U ^ k * 40503U) * 2246822519U;
    return 0.03 * static_cast<double>(mixed >> 16) / 65535.0;
  }
};

/// A model on ground with heights.
template <class Model, class Heights>
struct On : Model {
  static constexpr auto kHeights = field_of(Heights{});
};

TEST(MultibodyGround, ALevelFieldIsALevelPlane) {
  MultibodyScene<BoxOf<double>> plane;
  MultibodyScene<On<BoxOf<double>, Level>> field;
  const auto throw_it = [](auto& scene) {
    scene.simulator.want_pose(0, {{0.0, 0.0, 0.3, 0.9, 0.3, 0.25, 0.1}});
    scene.simulator.want_twist(0, {{1.0, 0.5, 0.0, 3.0, 5.0, 0.0}});
    scene.reset();
    scene.run(0.4);
    return scene.simulator.pose(0);
  };
  const auto on_plane = throw_it(plane), on_field = throw_it(field);
  for (std::size_t i = 0; i < 7; ++i) EXPECT_NEAR(on_field[i], on_plane[i], 1e-9);
}

TEST(MultibodyGround, ABallRollsDownASlopeOfAField) {
  using Ball = On<Sliding<double, Falls{0.0, 0.0}, false>, Slope>;
  MultibodyScene<Ball> scene;
  const double steepness = std::hypot(0.2, 0.1), angle = std::atan(steepness);
  const double scale = 0.1 / std::hypot(1.0, steepness);
  scene.simulator.set_friction(0, 1.0);
  // Heights are of the object's frame, whose origin is at (0.3, -0.2, 0.5).
  scene.simulator.want_pose(
      0, {{0.3 + 0.2 * scale, -0.2 + 0.1 * scale, 0.5 + scale, 1.0, 0.0, 0.0, 0.0}});
  scene.reset();
  scene.run(0.5);
  const RigidState s = scene.simulator.state(0);
  const double expected = 5.0 / 7.0 * kG * std::sin(angle) * 0.5;
  EXPECT_NEAR(std::sqrt(dot(s.velocity, s.velocity)), expected, 0.02 * expected);
  EXPECT_NEAR(std::atan2(s.velocity[1], s.velocity[0]), std::atan2(0.1, 0.2), 1e-3);
}

TEST(MultibodyGround, ABallComesToRestInABowl) {
  MultibodyScene<On<Sliding<double, Falls{0.0, 0.0}, false>, Bowl>> scene;
  scene.simulator.want_pose(0, {{0.8, 0.2, 1.2, 1.0, 0.0, 0.0, 0.0}});
  scene.reset();
  double highest = -1.0;
  for (int i = 0; i < 500; ++i) {
    scene.tick();
    if (i > 250) highest = std::max(highest, scene.simulator.pose(0)[2]);
  }
  EXPECT_LT(highest, 1.2) << "no energy from the kinks of the grid";
  EXPECT_GT(scene.simulator.pose(0)[2], 0.55);
}

TEST(MultibodyGround, HeightsAreAboveTheGround) {
  using Ball = Sliding<double, Falls{0.0, 0.0}, false>;
  MultibodyScene<On<Ball, Slope>> slope;  // the object's frame is at (0.3, -0.2, 0.5)
  slope.simulator.set_roughness(0.5);
  EXPECT_NEAR(slope.simulator.height_above_ground({{1.3, -0.2, 2.0}}), 1.5 + 0.5 * 0.2, 1e-6);
  EXPECT_NEAR(slope.simulator.height_above_ground({{0.3, 0.8, 0.0}}), -0.5 + 0.5 * 0.1, 1e-6);
  MultibodyScene<Sliding<double, Falls{0.3, 0.0}, false>> tilted;
  const Vector3 normal = Falls{0.3, 0.0}.normal();
  EXPECT_NEAR(tilted.simulator.height_above_ground(
                  {{0.3 + 2.0 * normal[0], -0.2 + 2.0 * normal[1], 0.5 + 2.0 * normal[2]}}),
              2.0, 1e-12)
      << "the distance from a plane";
}

struct RoughnessIo {
  using State = Array<float, 1>;
  using Simulator = MultibodySimulator<On<WalkerOf<float>, Gravel>>;
};
TEST(MultibodyGround, AResetSetsTheRoughness) {
  MultibodyScene<On<WalkerOf<float>, Gravel>> scene;
  EXPECT_EQ(scene.simulator.numbers().roughness, 1.0F);
  GroundRoughness<RoughnessIo>::reset({{0.25F}}, scene.simulator);
  EXPECT_EQ(scene.simulator.numbers().roughness, 0.25F);
  GroundRoughness<RoughnessIo>::reset({{-1.0F}}, scene.simulator);
  EXPECT_EQ(scene.simulator.numbers().roughness, 0.25F) << "no factor";
}

TEST(MultibodyGround, ABallLiesOnAStep) {
  MultibodyScene<On<Sliding<double, Falls{0.0, 0.0}, false>, Steps>> scene;
  scene.simulator.want_pose(0, {{0.3 + 0.25, -0.2, 0.7, 1.0, 0.0, 0.0, 0.0}});
  scene.reset();
  scene.run(1.0);
  EXPECT_NEAR(scene.simulator.pose(0)[2], 0.5 + 0.03 + 0.1, 1e-5);
}

/// Drops the walker, tilted by `pitch`, and lets it stand; the height of its trunk.
template <class Heights, class Real>
auto stand(double roughness, double pitch = 0.0, double height = 0.32) {
  MultibodyScene<On<WalkerOf<Real>, Heights>> scene;
  constexpr double kHome[3] = {0.0, 0.9, -1.8};
  scene.simulator.set_roughness(roughness);
  scene.simulator.want_pose(
      0, {{0.0, 0.0041, height, std::cos(0.5 * pitch), 0.0, std::sin(0.5 * pitch), 0.0}});
  for (std::size_t j = 0; j < 12; ++j) {
    scene.simulator.want_joint(j, {{kHome[j % 3], 0.0}, {0.0, 0.0}});
    scene.simulator.set_joint_servo(j, {Real(kHome[j % 3]), Real(40), Real(3), Real(33.5)});
  }
  scene.reset();
  scene.run(3.0);
  const auto pose = scene.simulator.pose(0);
  const auto twist = scene.simulator.twist(0);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(static_cast<double>(twist[i]), 0.0, 0.01) << i;
  double lifted = 0.0;
  for (std::size_t g = 0; g < 4; ++g)
    lifted += static_cast<double>(scene.simulator.contact_force(g)[2]);
  EXPECT_NEAR(lifted, (6.0 + 4 * (0.696 + 1.013 + 0.226)) * kG, 0.5);
  return static_cast<double>(pose[2]);
}
TEST(MultibodyGround, AWalkerStandsOnStepsSlopesAndGravel) {
  const double flat = stand<Level, float>(1.0);
  EXPECT_NEAR((stand<Gravel, float>(0.0)), flat, 1e-4) << "no roughness is level";
  const double on_gravel = stand<Gravel, float>(1.0);
  EXPECT_GT(on_gravel, flat);
  EXPECT_LT(on_gravel, flat + 0.04);
  EXPECT_NEAR((stand<Steps, float>(1.0, -0.08)), flat + 0.015, 0.01) << "two feet are 3 cm higher";
  stand<Slope, float>(1.0);
}

/// Corners of a box are compliant on a trunk.
struct BelliedOnSlope : On<WalkerOf<double>, Slope> {
  static constexpr std::array<RigidGeometry, 6> kGeometries = [] {
    std::array<RigidGeometry, 6> all{};
    for (std::size_t i = 0; i < 5; ++i) all[i] = WalkerOf<double>::kGeometries[i];
    all[5] = {.name = "belly",
              .kind = ShapeKind::box,
              .body = "trunk",
              .size = {{0.26, 0.18, 0.12}},
              .friction = 0.8};
    return all;
  }();
};
TEST(MultibodyGround, ATrunkLiesOnASlope) {
  MultibodyScene<BelliedOnSlope> scene;
  for (std::size_t j = 0; j < 12; ++j)  // legs folded next to the trunk
    scene.simulator.want_joint(j, {{j % 3 == 0 ? 0.0 : j % 3 == 1 ? 1.6 : -2.6, 0.0}, {0.0, 0.0}});
  scene.simulator.want_pose(0, {{0.0, 0.0041, 0.2, 1.0, 0.0, 0.0, 0.0}});
  scene.reset();
  scene.run(3.0);
  const RigidState s = scene.simulator.state(0);
  const Vector3 up = rotate(s.rotation, {{0.0, 0.0, 1.0}});
  const double below = -0.2 * s.position[0] - 0.1 * s.position[1];
  EXPECT_NEAR((s.position[2] - below) / std::hypot(1.0, 0.2, 0.1), 0.06, 0.01);
  EXPECT_NEAR(up[0], 0.2 / std::hypot(1.0, 0.2, 0.1), 0.02);
  EXPECT_LT(dot(s.velocity, s.velocity), 1e-4) << "friction holds it";
}

TEST(MultibodyGround, LanesHaveTheBitsOfPlainNumbers) {
  constexpr std::size_t kLanes = 4;
  using One = MultibodySimulator<On<WalkerOf<float>, Gravel>>;
  using All = MultibodySimulator<On<WalkerOf<Simd<float, kLanes>>, Gravel>>;
  std::array<One, kLanes> ones{};
  All all{};
  const auto word = [](auto& many, std::size_t i, std::size_t lane) {
    return reinterpret_cast<char*>(&many) + 4 * (i * kLanes + lane);
  };
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    One& one = ones[lane];
    const double x = 0.4 * static_cast<double>(lane) - 0.7;
    one.start({{0.5, 0.0, -9.81}});
    one.set_roughness(0.3 * static_cast<double>(lane));
    one.want_pose(0, {{x, 0.1 - x, 0.3, 1.0, 0.05, 0.0, x}});
    for (std::size_t j = 0; j < 12; ++j) {
      const float home = j % 3 == 0 ? 0.0F : j % 3 == 1 ? 0.9F : -1.8F;
      one.want_joint(j, {{static_cast<double>(home), 0.0}, {0.0, 0.0}});
      one.set_joint_servo(j, {home, 40.0F, 1.0F, 33.5F});
    }
    one.begin_episode();
    for (std::size_t i = 0; i < sizeof(One) / 4; ++i)
      std::memcpy(word(all, i, lane), reinterpret_cast<const char*>(&one) + 4 * i, 4);
  }
  constexpr multibody::ContactSettings<float> kSettings{2e4F, 400.0F, 0.005F, 0.2F, 0.004F};
  for (int i = 0; i < 500; ++i) {
    all.step(kSettings, 4);
    for (One& one : ones) one.step(kSettings, 4);
  }
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    One from_simd{};
    for (std::size_t i = 0; i < sizeof(One) / 4; ++i)
      std::memcpy(reinterpret_cast<char*>(&from_simd) + 4 * i, word(all, i, lane), 4);
    EXPECT_EQ(std::memcmp(&from_simd, &ones[lane], sizeof(One)), 0) << "lane " << lane;
    EXPECT_GT(ones[lane].pose(0)[2], 0.1F);
  }
}

}  // namespace
}  // namespace eagerx::models::testing::ground

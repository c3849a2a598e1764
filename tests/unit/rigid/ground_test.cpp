// Ground with heights: the same objects on both engines.
#include <gtest/gtest.h>

#include <cmath>
#include <models/engine_states/ground_roughness/ground_roughness.hpp>

#include "tests/unit/multibody/multibody_io.hpp"
#include "tests/unit/rigid/rigid_io.hpp"

namespace eagerx::models::testing::ground {
namespace {

constexpr double kG = 9.81;

/// Ground of 4 m by 4 m around the origin, with heights F(x, y).
template <class F>
constexpr HeightField<41, 41> field_of() {
  HeightField<41, 41> field{.corner = {-2.0, -2.0}, .spacing = 0.1, .height = {}};
  for (std::size_t i = 0; i < 41; ++i) {
    for (std::size_t k = 0; k < 41; ++k)
      field.height[i][k] = static_cast<float>(
          F::at(-2.0 + 0.1 * static_cast<double>(i), -2.0 + 0.1 * static_cast<double>(k)));
  }
  return field;
}
struct Slope {
  static constexpr double at(double x, double y) { return -0.2 * x - 0.1 * y; }
};
struct Step {  // 3 cm, from x = 0 to 0.1 m
  static constexpr double at(double x, double /*y*/) { return x < 0.05 ? 0.0 : 0.03; }
};
struct Bump {  // a flat top of 0.2 m by 0.2 m, 5 cm high
  static constexpr double at(double x, double y) {
    return x * x < 0.012 && y * y < 0.012 ? 0.05 : 0.0;
  }
};
struct Saddle {  // bilinear itself
  static constexpr double at(double x, double y) { return x * y; }
};

/// A ball of 0.1 m, or a box of 0.4 m by 0.4 m by 0.2 m, on such ground.
template <class Heights, ShapeKind kKind>
struct Thing {
  using Real = double;
  static constexpr Vector3 kOrigin{{0.3, -0.2, 0.5}};
  static constexpr double kInertia = 0.4 * 2.0 * 0.01;  // of a solid ball
  static constexpr std::array<RigidBody, 1> kBodies = {
      {{.name = "thing", .mass = 2.0, .inertia = {{kInertia, kInertia, kInertia}}}}};
  static constexpr std::array<RigidJoint, 0> kJoints = {};
  static constexpr std::array<RigidGeometry, 2> kGeometries = {
      {{.name = "thing",
        .kind = kKind,
        .body = "thing",
        .size = kKind == ShapeKind::box ? Vector3{{0.4, 0.4, 0.2}} : Vector3{{0.1, 0.2, 0.0}}},
       {.name = "ground", .kind = ShapeKind::plane}}};
  static constexpr auto kHeights = field_of<Heights>();
};
template <class Heights>
using Ball = Thing<Heights, ShapeKind::sphere>;
template <class Heights>
using Box = Thing<Heights, ShapeKind::box>;

template <class Model>
using Library = Scene<Model, RigidConfig<20>>;
template <class Model>
using Own = MultibodyScene<Model>;

/// After `seconds` from rest at a place of the object's frame; the position is in that frame.
template <class SceneOf>
RigidState left_alone(SceneOf& scene, const Vector3& at, double seconds,
                      const Quaternion& q = kNoRotation) {
  const Vector3 origin{{0.3, -0.2, 0.5}}, start = origin + at;
  scene.simulator.want_pose(0, {{start[0], start[1], start[2], q[0], q[1], q[2], q[3]}});
  scene.reset();
  for (int i = 0; i < static_cast<int>(seconds * 50.0 + 0.5); ++i) scene.tick();
  RigidState s = scene.simulator.state(0);
  s.position = s.position - origin;
  return s;
}
void expect_at_rest(const RigidState& s) {
  EXPECT_LT(dot(s.velocity, s.velocity), 1e-8);
  EXPECT_LT(dot(s.angular_velocity, s.angular_velocity), 1e-6);
}

TEST(RigidGround, HeightsAreThoseOfTheFormula) {
  using Model = Ball<Saddle>;
  const RigidHeights ground = RigidHeights::of<Model>({{0.3, -0.2, 0.5}}, Model::kGeometries[1]);
  for (int n = 0; n < 200; ++n) {
    const double x = -1.99 + 0.0199 * n, y = 1.9 * std::sin(1.7 * n);
    const auto plane = ground.below({{0.3 + x, -0.2 + y, 9.0}});
    EXPECT_NEAR(plane.at[2], 0.5 + x * y, 1e-6);
    const double scale = 1.0 / std::sqrt(1.0 + x * x + y * y);
    EXPECT_NEAR(plane.normal[0], -y * scale, 1e-5);
    EXPECT_NEAR(plane.normal[1], -x * scale, 1e-5);
    EXPECT_NEAR(plane.normal[2], scale, 1e-5);
  }
  // Around the grid as at its edge; what is no number is somewhere.
  EXPECT_NEAR(ground.below({{0.3 + 9.0, -0.2 + 1.0, 0.0}}).at[2], 0.5 + 2.0, 1e-6);
  EXPECT_NEAR(ground.below({{0.3 - 9.0, -0.2 - 9.0, 0.0}}).at[2], 0.5 + 4.0, 1e-6);
  EXPECT_TRUE(std::isfinite(ground.below({{std::nan(""), 0.0, 0.0}}).at[2]));
}

template <template <class> class SceneOf>
void check_bump() {
  SceneOf<Ball<Bump>> ball;
  const RigidState on_top = left_alone(ball, {{0.02, 0.03, 0.2}}, 2.0);
  expect_at_rest(on_top);
  EXPECT_NEAR(on_top.position[2], 0.05 + 0.1, 2e-4);
  SceneOf<Ball<Bump>> next_to;
  EXPECT_NEAR(left_alone(next_to, {{-1.0, 0.5, 0.2}}, 2.0).position[2], 0.1, 2e-4);
  SceneOf<Thing<Bump, ShapeKind::capsule>> capsule;
  const RigidState standing = left_alone(capsule, {{0.0, 0.0, 0.4}}, 0.5);
  EXPECT_NEAR(standing.position[2], 0.05 + 0.1 + 0.1, 2e-4) << "it stands on its lower end";
}
TEST(RigidGround, ABallComesToRestOnABump) {
  check_bump<Library>();
  check_bump<Own>();
}

template <template <class> class SceneOf>
void check_slope() {
  const double steepness = std::hypot(0.2, 0.1), flat = 1.0 / std::hypot(1.0, steepness);
  SceneOf<Ball<Slope>> ball;
  const RigidState rolls =
      left_alone(ball, {{0.1 * 0.2 * flat, 0.1 * 0.1 * flat, 0.1 * flat}}, 0.5);
  const double expected = 5.0 / 7.0 * kG * steepness * flat * 0.5;
  EXPECT_NEAR(std::sqrt(dot(rolls.velocity, rolls.velocity)), expected, 0.02 * expected);
  EXPECT_NEAR(std::atan2(rolls.velocity[1], rolls.velocity[0]), std::atan2(0.1, 0.2), 5e-3);
  SceneOf<Box<Slope>> box;
  const RigidState lies = left_alone(box, {{0.0, 0.0, 0.2}}, 2.0);
  expect_at_rest(lies);
  const double above = lies.position[2] - Slope::at(lies.position[0], lies.position[1]);
  EXPECT_NEAR(above * flat, 0.1, 2e-4);
  const Vector3 up = rotate(lies.rotation, {{0.0, 0.0, 1.0}});
  EXPECT_NEAR(up[0], 0.2 * flat, 1e-3);
  EXPECT_NEAR(up[1], 0.1 * flat, 1e-3);
}
TEST(RigidGround, ABallRollsDownASlopeAndABoxStaysOnIt) {
  check_slope<Library>();
  check_slope<Own>();
}

template <template <class> class SceneOf>
void check_step() {
  SceneOf<Box<Step>> scene;
  scene.simulator.watch_contact_force(0);
  const RigidState lies = left_alone(scene, {{0.0, 0.0, 0.2}}, 2.0);
  expect_at_rest(lies);
  // Its bottom, 0.4 m long, is 3 cm higher at one end.
  const double angle = std::asin(0.03 / 0.4);
  EXPECT_NEAR(lies.position[2], 0.015 + 0.1 * std::cos(angle), 3e-4);
  const Vector3 along = rotate(lies.rotation, {{1.0, 0.0, 0.0}});
  EXPECT_NEAR(std::asin(along[2]), angle, 1e-3);
  EXPECT_NEAR(scene.simulator.contact_force(0)[2], 2.0 * kG, 0.05);
}
TEST(RigidGround, ABoxLiesAcrossAStep) {
  check_step<Library>();
  check_step<Own>();
}

template <class Of>
struct StateIo {
  using State = Array<double, 1>;
  using Simulator = Of;
};
template <template <class> class SceneOf>
void check_roughness() {
  using Model = Ball<Bump>;
  SceneOf<Model> scene;
  using State = GroundRoughness<StateIo<typename SceneOf<Model>::Simulator>>;
  const auto height = [&] { return left_alone(scene, {{0.0, 0.0, 0.2}}, 2.0).position[2] - 0.1; };
  EXPECT_NEAR(height(), 0.05, 2e-4);
  State::reset({{0.4}}, scene.simulator);
  EXPECT_NEAR(height(), 0.02, 2e-4);
  State::reset({{-1.0}}, scene.simulator);
  EXPECT_NEAR(height(), 0.02, 2e-4) << "no factor";
  State::reset({{0.0}}, scene.simulator);
  EXPECT_NEAR(height(), 0.0, 2e-4);
}
TEST(RigidGround, AResetSetsTheRoughness) {
  check_roughness<Library>();
  check_roughness<Own>();
}

}  // namespace
}  // namespace eagerx::models::testing::ground

// How bodies are drawn: by the facets of the model, where it has some.
#include <gtest/gtest.h>

#include <models/engine_nodes/rigid_drawing/rigid_drawing.hpp>

#include "tests/unit/multibody/multibody_io.hpp"
#include "tests/unit/rigid/rigid_io.hpp"

namespace eagerx::models::testing {
namespace {

/// A body on a hinge that has a box, and looks like a triangle; and one that has a capsule alone.
struct Seen {
  using Real = double;
  static constexpr Vector3 kOrigin{{0.0, 0.0, 5.0}};
  static constexpr std::array<RigidBody, 2> kBodies = {
      {{.name = "arm", .position = {{1.0, 0.0, 0.0}}},
       {.name = "end", .position = {{2.0, 0.0, 0.0}}}}};
  static constexpr std::array<RigidJoint, 2> kJoints = {
      {{.name = "j", .child = "arm", .axis = {{0.0, 0.0, 1.0}}},
       {.name = "k", .kind = JointKind::fixed, .parent = "arm", .child = "end"}}};
  static constexpr std::array<RigidGeometry, 2> kGeometries = {
      {{.name = "box", .kind = ShapeKind::box, .body = "arm"},
       {.name = "rod", .kind = ShapeKind::capsule, .body = "end"}}};
  static constexpr std::array<RigidFacet, 2> kFacets = {
      {{"arm", {{{{0.0, 0.0, 0.0}}, {{0.5, 0.0, 0.0}}, {{0.0, 0.0, 0.25}}, {{0.0, 0.0, 0.25}}}}},
       {"", {{{{0.0, 0.0, 0.0}}, {{0.0, 0.5, 0.0}}, {{0.0, 0.0, 1.0}}, {{0.0, 0.0, 1.0}}}}}}};
};

template <class SimulatorType>
struct DrawingIo {
  using Real = double;
  using Simulator = SimulatorType;
  using States = NoStates;
  struct Config {
    static constexpr std::array<double, 3> eye = {2.0, -2.5, 1.5}, target = {0.0, 0.0, 0.0};
    static constexpr double angle = 0.7, chequer = 0.25, rail = 0.0;
    static constexpr const char* follow = "";
  };
  struct Inputs {};
  struct Outputs {
    Array<float, 8, 16>& scene;
  };
};

template <class SceneOf>
void check_drawing() {
  using Io = DrawingIo<typename SceneOf::Simulator>;
  SceneOf scene;
  scene.simulator.want_joint(0, {{1.5707963267948966, 0.0}, {0.0, 0.0}});
  scene.reset();
  Array<float, 8, 16> message{};
  typename Io::Outputs out{message};
  RigidDrawing<Io>().callback({0}, {}, out, scene.simulator);
  const auto row = [&](std::size_t i) { return SceneRow::read(&message[16 * i]); };
  EXPECT_EQ(row(0).shape, Shape::camera);
  EXPECT_EQ(row(1).shape, Shape::capsule) << "of the body without facets";
  ASSERT_EQ(row(2).shape, Shape::facet);
  // The arm has turned from x to y, about the origin at 5 m.
  const float expected[] = {0, 1, 5, 0, 1.5F, 5, 0, 1, 5.25F, 0, 1, 5.25F};
  for (std::size_t i = 0; i < 12; ++i) EXPECT_NEAR(row(2).n[i], expected[i], 1e-6F) << i;
  ASSERT_EQ(row(3).shape, Shape::facet);
  EXPECT_NEAR(row(3).n[4], 0.5F, 1e-6F);
  EXPECT_NEAR(row(3).n[5], 5.0F, 1e-6F);
  EXPECT_EQ(row(4).shape, Shape::none) << "no box, no rod";
}
TEST(RigidDrawing, FacetsReplaceWhatElseABodyHas) {
  check_drawing<Scene<Seen, RigidConfig<20>>>();
  check_drawing<MultibodyScene<Seen>>();
}

/// A ball on a ground that rises by 0.5 m a metre along x.
struct OnSlope {
  using Real = double;
  static constexpr std::array<RigidBody, 1> kBodies = {
      {{.name = "ball", .position = {{0.0, 0.0, 5.0}}}}};
  static constexpr std::array<RigidJoint, 0> kJoints = {};
  static constexpr std::array<RigidGeometry, 2> kGeometries = {
      {{.name = "skin", .kind = ShapeKind::sphere, .body = "ball"},
       {.name = "ground", .kind = ShapeKind::plane}}};
  static constexpr auto kHeights = [] {
    HeightField<9, 9> field;
    field.corner[0] = field.corner[1] = -2.0;
    field.spacing = 0.5;
    for (std::size_t i = 0; i < 9; ++i) {
      for (std::size_t k = 0; k < 9; ++k)
        field.height[i][k] = 0.25F * (static_cast<float>(i) - 4.0F);
    }
    return field;
  }();
};

template <class SceneOf>
void check_heights() {
  using Io = DrawingIo<typename SceneOf::Simulator>;
  SceneOf scene;
  scene.simulator.set_roughness(0.5);
  scene.reset();
  Array<float, 8, 16> message{};
  typename Io::Outputs out{message};
  RigidDrawing<Io>().callback({0}, {}, out, scene.simulator);
  std::size_t cells = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    const SceneRow row = SceneRow::read(&message[16 * i]);
    EXPECT_NE(row.shape, Shape::plane);
    if (row.shape != Shape::facet) continue;
    ++cells;
    for (std::size_t c = 0; c < 4; ++c)
      EXPECT_NEAR(row.n[3 * c + 2], 0.25F * row.n[3 * c], 1e-6F) << "z = 0.5·0.5·x";
  }
  EXPECT_EQ(cells, 4U) << "the largest square that fits behind camera and ball";
}
TEST(RigidDrawing, HeightsAreDrawnAsTheyAreSampled) {
  check_heights<Scene<OnSlope, RigidConfig<20>>>();
  check_heights<MultibodyScene<OnSlope>>();
}

}  // namespace
}  // namespace eagerx::models::testing

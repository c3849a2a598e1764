// Shapes around meshes, and the files that meshes are in.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "generator/urdf/meshes.hpp"
#include "generator/urdf/robot.hpp"

namespace eagerx::urdf {
namespace {

namespace fs = std::filesystem;
using models::ShapeKind;

/// The two triangles of a rectangle.
void add_rectangle(Triangles& to, const Vector3& corner, const Vector3& u, const Vector3& v) {
  for (const Vector3& p : {corner, corner + u, corner + u + v, corner, corner + u + v, corner + v})
    to.push_back(p);
}
/// A block with sides along the axes, turned.
Triangles block(const Vector3& size, const Quaternion& turn = models::kNoRotation,
                const Vector3& at = {}) {
  Triangles result;
  const Vector3 x{{size[0], 0, 0}}, y{{0, size[1], 0}}, z{{0, 0, size[2]}};
  add_rectangle(result, {}, x, y), add_rectangle(result, z, x, y);
  add_rectangle(result, {}, x, z), add_rectangle(result, y, x, z);
  add_rectangle(result, {}, y, z), add_rectangle(result, x, y, z);
  for (Vector3& p : result) p = at + rotate(turn, p - 0.5 * size);
  return result;
}
/// A body of revolution: radius at heights.
Triangles turned_body(const std::vector<std::array<double, 2>>& profile) {
  constexpr int kSides = 64;
  Triangles result;
  const auto point = [](const std::array<double, 2>& at, int side) {
    const double angle = 2.0 * M_PI * side / kSides;
    return Vector3{{at[0] * std::cos(angle), at[0] * std::sin(angle), at[1]}};
  };
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    for (int side = 0; side < kSides; ++side) {
      const Vector3 a = point(profile[i], side), b = point(profile[i], side + 1);
      const Vector3 c = point(profile[i + 1], side), d = point(profile[i + 1], side + 1);
      for (const Vector3& p : {a, b, c, b, d, c}) result.push_back(p);
    }
  }
  return result;
}
std::vector<std::array<double, 2>> half_circle(double radius, double low, double high) {
  std::vector<std::array<double, 2>> profile;
  for (int i = 0; i <= 32; ++i) {
    const double angle = M_PI * (i / 32.0 - 0.5);
    profile.push_back({radius * std::cos(angle), radius * std::sin(angle) + (i < 16 ? low : high)});
  }
  return profile;
}

bool is_inside(const Fitted& shape, const Vector3& p) {
  constexpr double kRounding = 1e-9;
  const Vector3 at = rotate(models::inverse(shape.origin.rotation), p - shape.origin.position);
  const double across = std::hypot(at[0], at[1]), r = shape.size[0] + kRounding;
  const double beyond = std::max(0.0, std::abs(at[2]) - 0.5 * shape.size[1]);
  switch (shape.kind) {
    case ShapeKind::sphere:
      return std::sqrt(dot(at, at)) <= r;
    case ShapeKind::cylinder:
      return across <= r && beyond <= kRounding;
    case ShapeKind::capsule:
      return std::hypot(across, beyond) <= r;
    case ShapeKind::box:
    case ShapeKind::plane:
      break;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(at[i]) > 0.5 * shape.size[i] + kRounding) return false;
  }
  return true;
}
void expect_enclosed(const Fitted& shape, const Triangles& triangles) {
  for (const Vector3& p : triangles) EXPECT_TRUE(is_inside(shape, p));
}

TEST(UrdfMeshes, SmallestShapeIsTheOneThatTheMeshIs) {
  const Quaternion turn = models::normalised({{0.8, 0.3, -0.4, 0.2}});
  const Triangles turned = block({{0.3, 0.2, 0.1}}, turn, {{1.0, 2.0, 3.0}});
  const Fitted box = smallest_shape(turned);
  EXPECT_EQ(box.kind, ShapeKind::box);
  EXPECT_NEAR(box.size[0] * box.size[1] * box.size[2], 0.006, 1e-6);
  EXPECT_NEAR(box.origin.position[2], 3.0, 1e-6);
  expect_enclosed(box, turned);

  const Triangles round = turned_body(half_circle(0.1, 0.0, 0.0));
  const Fitted sphere = smallest_shape(round);
  EXPECT_EQ(sphere.kind, ShapeKind::sphere);
  EXPECT_NEAR(sphere.size[0], 0.1, 2e-3);
  expect_enclosed(sphere, round);

  const Triangles rod = turned_body(half_circle(0.05, -0.2, 0.2));
  const Fitted capsule = smallest_shape(rod);
  EXPECT_EQ(capsule.kind, ShapeKind::capsule);
  EXPECT_NEAR(capsule.size[0], 0.05, 1e-3);
  EXPECT_NEAR(capsule.size[1], 0.4, 0.02);
  expect_enclosed(capsule, rod);

  const Triangles can = turned_body({{0.0, -0.1}, {0.06, -0.1}, {0.06, 0.1}, {0.0, 0.1}});
  const Fitted cylinder = smallest_shape(can);
  EXPECT_EQ(cylinder.kind, ShapeKind::cylinder);
  EXPECT_NEAR(cylinder.size[0], 0.06, 1e-3);
  EXPECT_NEAR(cylinder.size[1], 0.2, 1e-9);
  expect_enclosed(cylinder, can);
  EXPECT_EQ(smallest_box(can).kind, ShapeKind::box);
}

TEST(UrdfMeshes, AFlatMeshHasAThinBox) {
  Triangles flat;
  add_rectangle(flat, {}, {{1, 0, 0}}, {{0, 2, 0}});
  const Fitted box = smallest_shape(flat);
  EXPECT_EQ(box.kind, ShapeKind::box);
  EXPECT_GT(std::min({box.size[0], box.size[1], box.size[2]}), 0.0);
  expect_enclosed(box, flat);
}

TEST(UrdfMeshes, SpheresEncloseWithinTheDistance) {
  const Triangles rod = block({{0.5, 0.04, 0.04}});
  const auto spheres = enclosing_spheres(rod, 0.025, 16);
  EXPECT_GT(spheres.size(), 4U);
  EXPECT_LE(reach_beyond(spheres, rod), 0.025);
  for (int i = 0; i <= 100; ++i) {  // along an edge and an axis of a side
    for (const double y : {0.0, 0.02}) {
      const Vector3 p{{0.005 * i - 0.25, y, 0.02}};
      EXPECT_TRUE(std::ranges::any_of(spheres, [&](const Fitted& s) { return is_inside(s, p); }))
          << i;
    }
  }
  EXPECT_EQ(enclosing_spheres(rod, 1e-6, 5).size(), 5U);  // as many as there may be
  const double one = reach_beyond(enclosing_spheres(rod, 1.0, 16), rod);
  EXPECT_NEAR(one, std::hypot(0.25, 0.02, 0.02) - 0.02, 2e-3);  // beyond the side
}

double volume_of(const Triangles& triangles) {
  double sum = 0.0;
  for (std::size_t t = 0; t + 2 < triangles.size(); t += 3)
    sum += dot(triangles[t], models::cross(triangles[t + 1], triangles[t + 2])) / 6.0;
  return sum;
}

TEST(UrdfMeshes, FewTrianglesLookLikeAllOfThem) {
  const Triangles ball = turned_body(half_circle(0.1, 0.0, 0.0));
  ASSERT_GT(ball.size() / 3, 4000U);
  for (const std::size_t most : {40U, 200U, 1000U}) {
    const Triangles few = decimated(ball, most);
    EXPECT_LE(few.size() / 3, most);
    EXPECT_GE(few.size() / 3, most / 4);
    for (const Vector3& p : few) EXPECT_NEAR(std::sqrt(dot(p, p)), 0.1, most < 100 ? 0.03 : 0.01);
    const double expected = 4.0 / 3.0 * M_PI * 0.001;
    EXPECT_GT(volume_of(few), (most < 100 ? 0.15 : 0.8) * expected) << "counterclockwise";
    EXPECT_LT(volume_of(few), expected);
  }
  EXPECT_NEAR(surface_of(ball), 4.0 * M_PI * 0.01, 3e-4);
  Triangles inside_out = ball;
  for (std::size_t t = 0; t + 2 < ball.size(); t += 3)
    std::swap(inside_out[t + 1], inside_out[t + 2]);
  EXPECT_GT(volume_of(decimated(inside_out, 200)), 0.0);
  const Triangles brick = block({{0.3, 0.2, 0.1}});
  EXPECT_EQ(decimated(brick, 12).size(), brick.size());
  const Triangles box = decimated(ball, 5);  // too few for a ball
  EXPECT_EQ(box.size(), 36U);
  EXPECT_NEAR(volume_of(box), 0.008, 1e-5);
  EXPECT_TRUE(decimated({}, 10).empty());
}

/// A folder for the files of a test.
class UrdfMeshFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("urdf_meshes_" + std::to_string(getpid()));
    fs::create_directories(folder_ / "arm/meshes");
    fs::create_directories(folder_ / "arm/urdf");
    write("arm/meshes/block.obj", kBlock);
  }
  void TearDown() override { fs::remove_all(folder_); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  /// A robot of one link with a mesh.
  std::optional<Robot> robot(const std::string& mesh, const MeshOptions& options = {}) {
    const std::string text =
        "<robot name='r'><link name='a'><inertial><mass value='1'/><inertia ixx='1' iyy='1' "
        "izz='1'/></inertial><collision><origin xyz='0 0 1'/><geometry><mesh " +
        mesh + "/></geometry></collision></link></robot>";
    auto description = read_text("r.urdf", text, sources_, diagnostics_);
    if (!description) return std::nullopt;
    resolve_meshes(*description, (folder_ / "arm/urdf").string(), options, diagnostics_);
    return make_robot(*description, {}, diagnostics_);
  }

  /// 0.2, 0.4 and 0.6 m, its first corner at 0.
  static constexpr const char* kBlock =
      "v 0 0 0\nv 0.2 0 0\nv 0.2 0.4 0\nv 0 0.4 0\nv 0 0 0.6\nv 0.2 0 0.6\nv 0.2 0.4 0.6\nv 0 0.4 "
      "0.6\nf 1 2 3 4\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 1 4 8 5\nf 2 3 7 6\n";
  fs::path folder_;
  gen::SourceMap sources_;
  gen::Diagnostics diagnostics_;
};

TEST_F(UrdfMeshFiles, AreFoundByPackageAndPath) {
  const std::string from = (folder_ / "arm/urdf").string();
  const std::string block = (folder_ / "arm/meshes/block.obj").string();
  EXPECT_EQ(find_mesh("package://arm/meshes/block.obj", from, {}), block);
  EXPECT_EQ(find_mesh("package://another_name/meshes/block.obj", from, {}), block);
  EXPECT_EQ(fs::weakly_canonical(find_mesh("../meshes/block.obj", from, {})), block);
  EXPECT_EQ(find_mesh("meshes/block.obj", from, {}), block);
  EXPECT_EQ(find_mesh("file://" + block, from, {}), block);
  EXPECT_EQ(find_mesh("package://arm/meshes/none.obj", from, {}), "");
  EXPECT_EQ(find_mesh("package://arm/meshes/block.obj", "/", {}), "");
  EXPECT_EQ(find_mesh("package://arm/meshes/block.obj", "/", {folder_.string()}), block);
}

TEST_F(UrdfMeshFiles, BecomeShapesOfTheRobot) {
  if (!reads_meshes()) {
    EXPECT_FALSE(robot("filename='package://arm/meshes/block.obj'"));  // and says what to install
    EXPECT_EQ(diagnostics_.all().back().code, "E0858");
    return;
  }
  const auto made = robot("filename='package://arm/meshes/block.obj' scale='1 1 2'");
  ASSERT_TRUE(made);
  ASSERT_EQ(made->shapes.size(), 1U);
  EXPECT_EQ(made->shapes[0].kind, ShapeKind::box);
  const Vector3 &size = made->shapes[0].size, &at = made->shapes[0].position;
  EXPECT_NEAR(size[0] * size[1] * size[2], 0.2 * 0.4 * 1.2, 1e-6);
  EXPECT_NEAR(at[0], 0.1, 1e-6);
  EXPECT_NEAR(at[2], 1.0 + 0.6, 1e-6);
  EXPECT_EQ(robot("filename='package://arm/meshes/block.obj'", {.shapes = CollisionShapes::none})
                ->shapes.size(),
            0U);
  EXPECT_GT(robot("filename='package://arm/meshes/block.obj'", {.shapes = CollisionShapes::spheres})
                ->shapes.size(),
            4U);
}

TEST_F(UrdfMeshFiles, VisualsAreDrawn) {
  const auto arm = [&](const std::string& visual, std::size_t facets) {
    const std::string inertial =
        "<inertial><origin xyz='0 0 1'/><mass value='1'/><inertia ixx='1' iyy='1' "
        "izz='1'/></inertial>";
    auto description = read_text(
        "r.urdf",
        "<robot name='r'><link name='base'><visual><geometry><mesh "
        "filename='package://arm/meshes/block.obj'/></geometry></visual></link><link name='a'>" +
            inertial + visual +
            "</link><joint name='j' type='continuous'><parent link='base'/><child "
            "link='a'/><origin "
            "xyz='0 0 2'/></joint></robot>",
        sources_, diagnostics_);
    EXPECT_TRUE(description);
    resolve_meshes(*description, (folder_ / "arm/urdf").string(), {.facets = facets}, diagnostics_);
    return make_robot(*description, {}, diagnostics_);
  };
  const std::string visual =
      "<visual><origin xyz='0 0 3' rpy='0 0 1.5707963267948966'/><geometry><mesh "
      "filename='package://arm/meshes/block.obj' scale='1 2 1'/></geometry></visual>";
  const auto made = arm(visual, 400);
  ASSERT_TRUE(made);
  EXPECT_EQ(diagnostics_.error_count(), 0U);
  EXPECT_TRUE(made->shapes.empty()) << "nothing touches them";
  if (!reads_meshes()) {
    EXPECT_TRUE(made->facets.empty());
    return;
  }
  ASSERT_EQ(made->facets.size(), 24U);
  Vector3 low{{9, 9, 9}}, high{{-9, -9, -9}};
  for (const Facet& facet : made->facets) {
    if (facet.body != "a") continue;
    for (const Vector3& p : facet.corners) {
      for (std::size_t i = 0; i < 3; ++i)
        low[i] = std::min(low[i], p[i]), high[i] = std::max(high[i], p[i]);
    }
  }
  // Turned by a quarter, 3 m above the joint, whose body has its center of mass at 1 m.
  EXPECT_NEAR(low[0], -0.8, 1e-6);
  EXPECT_NEAR(high[0], 0.0, 1e-6);
  EXPECT_NEAR(high[1], 0.2, 1e-6);
  EXPECT_NEAR(low[2], 2.0, 1e-6);
  EXPECT_NEAR(high[2], 2.6, 1e-6);
  EXPECT_TRUE(std::ranges::any_of(made->facets, &std::string::empty, &Facet::body))
      << "the base is part of the world";
  EXPECT_NE(header_text(*made).find("std::array<RigidFacet, 24> kFacets"), std::string::npos);
  EXPECT_NE(manifest_text(*made).find("scene: {type: RigidDrawing"), std::string::npos);
  const auto none = arm(visual, 0);
  EXPECT_TRUE(none->facets.empty());
  EXPECT_EQ(header_text(*none).find("kFacets"), std::string::npos);
  EXPECT_NE(manifest_text(*none).find("scene: {type: RigidDrawing"), std::string::npos)
      << "draws the collision shapes";
  // Problems of visual elements do not reject a robot.
  const auto strange =
      arm("<visual><origin xyz='0 nan'/><geometry><mesh filename='package://arm/meshes/block.obj' "
          "scale='big'/></geometry></visual>",
          400);
  ASSERT_TRUE(strange);
  EXPECT_EQ(strange->facets.size(), 24U);
}

TEST_F(UrdfMeshFiles, OneThatIsNotThereIsLeftOutWithAWarning) {
  const auto made = robot("filename='package://arm/meshes/none.stl'");
  ASSERT_TRUE(made);
  EXPECT_TRUE(made->shapes.empty());
  EXPECT_EQ(diagnostics_.all().back().code, "E0858");
  EXPECT_EQ(diagnostics_.error_count(), 0U);
}

/// Text STL, and COLLADA in millimetres whose Y axis is up: its unit counts, its axis does not.
TEST_F(UrdfMeshFiles, StlAndDaeAreRead) {
  if (!reads_meshes()) return;
  write("arm/meshes/one.stl",
        "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 3 "
        "0\nendloop\nendfacet\nendsolid s\n");
  const LoadedMesh stl = load_mesh((folder_ / "arm/meshes/one.stl").string());
  EXPECT_EQ(stl.problem, "");
  ASSERT_EQ(stl.triangles.size(), 3U);
  EXPECT_NEAR(stl.triangles[2][1], 3.0, 1e-6);
  write("arm/meshes/one.dae",
        "<?xml version='1.0'?><COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' "
        "version='1.4.1'><asset><unit name='millimeter' meter='0.001'/><up_axis>Y_UP</up_axis>"
        "</asset><library_geometries><geometry id='g'><mesh><source id='p'><float_array id='pa' "
        "count='9'>0 0 0 2000 0 0 0 3000 0</float_array><technique_common><accessor source='#pa' "
        "count='3' stride='3'><param name='X' type='float'/><param name='Y' type='float'/><param "
        "name='Z' type='float'/></accessor></technique_common></source><vertices id='v'><input "
        "semantic='POSITION' source='#p'/></vertices><triangles count='1'><input "
        "semantic='VERTEX' source='#v' offset='0'/><p>0 1 2</p></triangles></mesh></geometry>"
        "</library_geometries><library_visual_scenes><visual_scene id='s'><node id='n'>"
        "<instance_geometry url='#g'/></node></visual_scene></library_visual_scenes><scene>"
        "<instance_visual_scene url='#s'/></scene></COLLADA>");
  const LoadedMesh dae = load_mesh((folder_ / "arm/meshes/one.dae").string());
  EXPECT_EQ(dae.problem, "");
  ASSERT_EQ(dae.triangles.size(), 3U);
  EXPECT_NEAR(dae.triangles[1][0], 2.0, 1e-6);
  EXPECT_NEAR(dae.triangles[2][1], 3.0, 1e-6);
  write("arm/meshes/bad.stl", "no mesh");
  EXPECT_NE(load_mesh((folder_ / "arm/meshes/bad.stl").string()).problem, "");
}

}  // namespace
}  // namespace eagerx::urdf

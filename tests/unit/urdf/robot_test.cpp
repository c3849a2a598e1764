// Frames, inertia and limits of descriptions; damaged files. tests/urdf has whole robots and
// messages.
#include "generator/urdf/robot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <random>

#include "generator/urdf/inertia.hpp"

namespace eagerx::urdf {
namespace {

std::optional<Robot> robot_of(const std::string& text, const RobotOptions& options = {}) {
  gen::SourceMap sources;
  gen::Diagnostics diagnostics;
  const auto description = read_text("test.urdf", text, sources, diagnostics);
  if (!description) return std::nullopt;
  return make_robot(*description, options, diagnostics);
}

/// A link of 1 kg with an inertia of its own, and a joint over it.
std::string link(const std::string& name, const std::string& more = "") {
  return "<link name='" + name +
         "'><inertial><mass value='1'/><inertia ixx='1' iyy='2' izz='2.5'/></inertial>" + more +
         "</link>";
}
std::string joint(const std::string& type, const std::string& parent, const std::string& child,
                  const std::string& more = "") {
  return "<joint name='" + parent + "_" + child + "' type='" + type + "'><parent link='" + parent +
         "'/><child link='" + child + "'/>" + more + "</joint>";
}
std::string robot(const std::string& inside) {
  return "<robot name='my robot 2'>" + inside + "</robot>";
}

TEST(Urdf, BaseWithoutInertiaIsTheWorld) {
  const std::string text = robot("<link name='base'/>" + link("a") +
                                 joint("continuous", "base", "a", "<origin xyz='1 2 3'/>"));
  const auto fixed = robot_of(text);
  ASSERT_TRUE(fixed);
  EXPECT_EQ(fixed->id, "MyRobot2");
  EXPECT_EQ(fixed->name, "my_robot_2");
  ASSERT_EQ(fixed->bodies.size(), 1U);
  EXPECT_EQ(fixed->joints[0].parent, "");
  EXPECT_EQ(fixed->joints[0].anchor, (Vector3{{1, 2, 3}}));
  const auto free = robot_of(text, {.id = {}, .base = Base::free, .ground = false});
  ASSERT_TRUE(free);  // 1/1000 of the mass of the others
  EXPECT_TRUE(free->bodies[0].is_free);
  EXPECT_DOUBLE_EQ(free->bodies[0].mass, 1e-3);
}

/// ROS recommends a first link without mass, to which the one with mass is fixed.
TEST(Urdf, BaseWithoutInertiaIsFreeIfItIsFixedToAMass) {
  const auto rover = [](const std::string& root) {
    return robot_of(robot("<link name='" + root + "'/>" + link("chassis") + link("wheel") +
                          joint("fixed", root, "chassis", "<origin xyz='0 0 1'/>") +
                          joint("continuous", "chassis", "wheel")));
  };
  const auto free = rover("base_footprint");
  ASSERT_TRUE(free);
  ASSERT_EQ(free->bodies.size(), 2U);
  EXPECT_TRUE(free->bodies[0].is_free);
  EXPECT_EQ(free->bodies[0].position, (Vector3{{0, 0, 1}}));
  EXPECT_EQ(rover("world")->bodies.size(), 1U);  // where it says so
}

TEST(Urdf, MassesThatAreNoneAreReplaced) {
  const auto made =
      robot_of(robot("<link name='base'/>" + link("a") + "<link name='frame'/>" +
                     "<link name='point'><inertial><mass value='2'/><inertia ixx='0' iyy='0' "
                     "izz='0'/></inertial></link>" +
                     joint("continuous", "base", "a") +
                     joint("continuous", "a", "frame", "<origin xyz='1 0 0'/>") +
                     joint("continuous", "frame", "point", "<origin xyz='0 1 0'/>")));
  ASSERT_TRUE(made);
  const Body &frame = made->bodies[1], &point = made->bodies[2];
  EXPECT_DOUBLE_EQ(frame.mass, 0.003);
  EXPECT_EQ(frame.position, (Vector3{{1, 0, 0}}));
  EXPECT_NEAR(frame.inertia[0], 0.003 * 0.05 * 0.05, 1e-12);
  EXPECT_EQ(point.position, (Vector3{{1, 1, 0}}));
  // A ball of 2 l has a radius of 78.2 mm.
  EXPECT_NEAR(point.inertia[2], 0.4 * 2.0 * 0.0782 * 0.0782, 1e-5);
}

TEST(Urdf, PlanarAndSphericalJointsBecomeChains) {
  const auto made = robot_of(robot("<link name='base'/>" + link("a") + link("b") +
                                   joint("planar", "base", "a", "<axis xyz='0 0 1'/>") +
                                   joint("spherical", "a", "b", "<origin xyz='0 0 2'/>")));
  ASSERT_TRUE(made);
  ASSERT_EQ(made->joints.size(), 6U);
  EXPECT_EQ(made->joints[0].name, "base_a_x");
  EXPECT_TRUE(made->joints[0].slides && made->joints[1].slides && !made->joints[2].slides);
  EXPECT_EQ(made->joints[0].axis, (Vector3{{1, 0, 0}}));
  EXPECT_EQ(made->joints[1].axis, (Vector3{{0, 1, 0}}));
  EXPECT_EQ(made->joints[2].axis, (Vector3{{0, 0, 1}}));
  EXPECT_EQ(made->joints[2].child, "a");
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(made->joints[3 + i].axis[i], 1.0);
    EXPECT_EQ(made->joints[3 + i].anchor, (Vector3{{0, 0, 2}}));
  }
}

TEST(Urdf, JointsFollowOthers) {
  const std::string limit = "<limit lower='-1' upper='1'/>";
  const auto hand = [&](const std::string& third, const std::string& fourth) {
    return robot_of(robot("<link name='base'/>" + link("a") + link("b") + link("c") +
                          joint("revolute", "base", "a", limit) +
                          joint("prismatic", "base", "b", limit + third) +
                          joint("revolute", "b", "c", limit + fourth)));
  };
  const auto made = hand("<mimic joint='base_a' multiplier='-2' offset='0.5'/>",
                         "<mimic joint='base_b' multiplier='3' offset='0.1'/>");
  ASSERT_TRUE(made);
  EXPECT_EQ(made->joints[1].mimics, "base_a");
  EXPECT_EQ(made->joints[1].ratio, -2.0);
  EXPECT_EQ(made->joints[1].offset, 0.5);
  EXPECT_EQ(made->joints[2].mimics, "base_a");  // through the other one
  EXPECT_EQ(made->joints[2].ratio, -6.0);
  EXPECT_DOUBLE_EQ(made->joints[2].offset, 1.6);
  // -2 q + 0.5 is within ±1 for q from -0.25 to 0.75, -6 q + 1.6 for q from 0.1 to 0.4333.
  EXPECT_DOUBLE_EQ(made->joints[0].limits.lower, 0.1);
  EXPECT_DOUBLE_EQ(made->joints[0].limits.upper, 2.6 / 6.0);
  EXPECT_TRUE(can_use_multibody(*made));
  EXPECT_FALSE(can_use_open_dynamics(*made));
  EXPECT_FALSE(hand("<mimic joint='base_c'/>", ""));  // is none
  EXPECT_FALSE(hand("<mimic joint='b_c'/>", "<mimic joint='base_b'/>"));
}

TEST(Urdf, WhatCannotMoveIsPartOfTheWorld) {
  const auto table = robot_of(robot(
      "<link name='table'><inertial><mass value='0'/><inertia ixx='0' iyy='0' izz='0'/>"
      "</inertial><collision><geometry><plane normal='0 0 2'/></geometry></collision></link>"));
  ASSERT_TRUE(table);
  ASSERT_EQ(table->bodies.size(), 1U);
  ASSERT_EQ(table->joints.size(), 1U);
  EXPECT_TRUE(table->joints[0].is_fixed);
  EXPECT_EQ(table->shapes[0].body, "");
  EXPECT_EQ(table->shapes[0].normal, (Vector3{{0, 0, 1}}));
}

TEST(Urdf, LimitsOfOtherTools) {
  const auto made = robot_of(robot(
      "<link name='base'/>" + link("a") + link("b") + link("c") + link("d") +
      joint("revolute", "base", "a", "<limit lower='-9' upper='9' effort='0' velocity='0'/>") +
      joint("revolute", "a", "b", "<limit lower='1' upper='-1' effort='3' velocity='2'/>") +
      joint("revolute", "b", "c", "<limit lower='-1e16' upper='1e16'/>") +
      joint("prismatic", "c", "d", "<joint_properties damping='0.5' friction='0.25'/>")));
  ASSERT_TRUE(made);
  const auto& joints = made->joints;
  EXPECT_EQ(joints[0].limits.lower, -9.0);  // stops of any size
  EXPECT_TRUE(std::isinf(joints[0].limits.effort) && std::isinf(joints[0].limits.velocity));
  EXPECT_TRUE(std::isinf(joints[1].limits.lower) && std::isinf(joints[1].limits.upper));
  EXPECT_EQ(joints[1].limits.effort, 3.0);
  EXPECT_TRUE(std::isinf(joints[2].limits.upper));
  EXPECT_TRUE(std::isinf(joints[3].limits.upper));  // has no `limit`
  EXPECT_EQ(joints[3].limits.damping, 0.5);
  EXPECT_EQ(joints[3].limits.friction, 0.25);
}

/// 1 N·m on 1 kg·m² (about x) takes 2 s to 2 rad/s, on 2.5 kg·m² (about z) 1 N·m takes 0.25 s to
/// 0.1.
TEST(Urdf, QuickestJointIsFound) {
  const auto made = robot_of(robot(
      "<link name='base'/>" + link("a") + link("b") +
      joint("continuous", "base", "a", "<limit effort='1' velocity='2'/>") +
      joint("continuous", "a", "b", "<axis xyz='0 0 1'/><limit effort='1' velocity='0.1'/>")));
  ASSERT_TRUE(made);
  const auto quick = quickest_joint(*made);
  ASSERT_TRUE(quick);
  EXPECT_EQ(quick->name, "a_b");
  EXPECT_DOUBLE_EQ(quick->time_s, 0.25);
}

TEST(Urdf, NamesThatWouldBeTheSameGetNumbers) {
  const auto made =
      robot_of(robot("<link name='base'/>" + link("a-b") + link("a.b") +
                     joint("continuous", "base", "a-b") + joint("continuous", "base", "a.b")));
  ASSERT_TRUE(made);
  EXPECT_EQ(made->bodies[0].name, "a_b");
  EXPECT_EQ(made->bodies[1].name, "a_b_2");
  EXPECT_EQ(made->joints[1].name, "base_a_b_2");
  EXPECT_EQ(made->joints[1].child, "a_b_2");
}

TEST(Urdf, BaseWithInertiaIsFreeUnlessItIsFixed) {
  const std::string text = robot(link("base") + link("a") + joint("continuous", "base", "a"));
  const auto free = robot_of(text);
  ASSERT_TRUE(free);
  ASSERT_EQ(free->bodies.size(), 2U);
  EXPECT_TRUE(free->bodies[0].is_free);
  EXPECT_FALSE(free->bodies[1].is_free);
  EXPECT_EQ(free->joints[0].parent, "base");
  const auto fixed = robot_of(text, {.id = "Fixed", .base = Base::fixed, .ground = true});
  ASSERT_TRUE(fixed);
  EXPECT_EQ(fixed->id, "Fixed");
  EXPECT_EQ(fixed->bodies.size(), 1U);
  EXPECT_TRUE(fixed->ground);
}

/// Roll, pitch, yaw are turns about fixed axes, in this order.
TEST(Urdf, AxesAndFramesAreTurned) {
  const auto made = robot_of(robot(
      "<link name='base'/>" + link("a") + link("b") +
      joint("continuous", "base", "a",
            "<origin xyz='0 0 1' rpy='1.5707963267948966 0 1.5707963267948966'/><axis xyz='0 3 "
            "0'/>") +
      joint("prismatic", "a", "b",
            "<origin xyz='1 0 0' rpy='0 1.5707963267948966 0'/><limit lower='-1' upper='2'/>")));
  ASSERT_TRUE(made);
  const auto near = [](const Vector3& a, const Vector3& b) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-15) << i;
  };
  near(made->joints[0].axis, {{0, 0, 1}});    // y, rolled to z
  near(made->joints[1].anchor, {{0, 1, 1}});  // x, turned to y
  near(made->joints[1].axis, {{-1, 0, 0}});   // x, by the joint to -z, by a to y and -x
}

TEST(Urdf, FixedLinksAreOneBody) {
  const auto made = robot_of(robot(
      "<link name='base'/>" + link("a") + link("b") + link("c") + joint("continuous", "base", "a") +
      joint("fixed", "a", "b", "<origin xyz='2 0 0'/>") + joint("continuous", "b", "c")));
  ASSERT_TRUE(made);
  ASSERT_EQ(made->bodies.size(), 2U);
  const Body& both = made->bodies[0];
  EXPECT_EQ(both.mass, 2.0);
  EXPECT_EQ(both.position, (Vector3{{1, 0, 0}}));
  EXPECT_EQ(both.inertia, (Vector3{{2, 4 + 2, 5 + 2}}));  // Steiner: 1 kg at 1 m, twice
  EXPECT_EQ(made->joints[1].parent, "a");
}

TEST(Urdf, InertiaTurnsWithItsFrame) {
  const double turn = 0.7;
  const Inertial along = {.origin = {}, .mass = 1.0, .inertia = {{1.0, 2.0, 2.5}}, .products = {}};
  const Frame link = {{}, models::rotation({{0.0, 0.0, 1.0}}, turn)};
  const MassAndInertia made = turned(along, link);
  const double c = std::cos(turn), s = std::sin(turn);
  EXPECT_NEAR(made.inertia[0], c * c * 1.0 + s * s * 2.0, 1e-15);
  EXPECT_NEAR(made.inertia[1], s * s * 1.0 + c * c * 2.0, 1e-15);
  EXPECT_NEAR(made.inertia[2], 2.5, 1e-15);
  EXPECT_NEAR(made.products[0], c * s * (1.0 - 2.0), 1e-15);
  // There and back again.
  const Inertial back = {
      {{}, models::rotation({{0.0, 0.0, 1.0}}, -turn)}, 1.0, made.inertia, made.products};
  const MassAndInertia again = turned(back, {});
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(again.inertia[i], along.inertia[i], 1e-15);
    EXPECT_NEAR(again.products[i], 0.0, 1e-15);
  }
}

TEST(Urdf, WhatInertiaABodyCanHave) {
  EXPECT_TRUE(is_positive({{1, 1, 1}}, {{0.5, 0.5, 0.5}}));
  EXPECT_FALSE(is_positive({{1, 1, 1}}, {{-0.9, -0.9, -0.9}}));
  EXPECT_FALSE(is_positive({{1, 0, 1}}, {}));
  EXPECT_TRUE(is_of_a_body({{1, 1, 0.01}}, {}));
  EXPECT_TRUE(is_of_a_body({{1, 1, 2}}, {}));  // a disc
  EXPECT_FALSE(is_of_a_body({{1, 1, 2.1}}, {}));
}

TEST(Urdf, LimitsAndDynamics) {
  const auto made =
      robot_of(robot("<link name='base'/>" + link("a") +
                     joint("revolute", "base", "a",
                           "<limit lower='-3.1416' upper='1' effort='5' velocity='2'/><dynamics "
                           "damping='0.1' friction='0.2'/>")));
  ASSERT_TRUE(made);
  const Joint& limits = made->joints[0].limits;
  EXPECT_EQ(limits.lower, -3.1416);
  EXPECT_EQ(limits.upper, 1.0);
  EXPECT_EQ(limits.effort, 5.0);
  EXPECT_EQ(limits.damping, 0.1);
  EXPECT_EQ(limits.friction, 0.2);
}

TEST(Urdf, ShapesAreSeenFromTheCentreOfMass) {
  const std::string shape =
      "<collision><origin xyz='0 0 1'/><geometry><sphere "
      "radius='0.5'/></geometry></collision>";
  const auto made = robot_of(
      robot("<link name='base'>" + shape + "</link>" +
            "<link name='a'><inertial><origin xyz='0 0 0.25'/><mass value='1'/><inertia ixx='1' "
            "iyy='1' izz='1'/></inertial>" +
            shape + shape + "</link>" + joint("continuous", "base", "a", "<origin xyz='0 0 2'/>")));
  ASSERT_TRUE(made);
  ASSERT_EQ(made->shapes.size(), 3U);
  EXPECT_EQ(made->shapes[0].body, "");
  EXPECT_EQ(made->shapes[0].position, (Vector3{{0, 0, 1}}));
  EXPECT_EQ(made->shapes[1].body, "a");
  EXPECT_EQ(made->shapes[1].position, (Vector3{{0, 0, 0.75}}));
  EXPECT_EQ(made->shapes[2].name, "a_2");
}

/// Nothing but the file's own words and places may come of damaged files (the debug preset runs
/// this under the sanitizers), and what is read can be written.
TEST(Urdf, DamagedFilesAreReadOrRefused) {
  std::ifstream file(EAGERX_SOURCE_DIR "/tests/urdf/robots/rover.urdf", std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(file), {}};
  ASSERT_FALSE(whole.empty());
  std::mt19937 random(1);
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
  const char* const pieces[] = {"\"",
                                "<",
                                "</link>",
                                "/>",
                                "&#0;",
                                "<!--",
                                "]]>",
                                "<![CDATA[",
                                "-",
                                "e",
                                "1e308",
                                "\xff",
                                "<link name=\"chassis\"/>",
                                "\n"};
  int read = 0;
  for (int run = 0; run < 4000; ++run) {
    std::string text = whole;
    for (std::size_t i = 0; i <= below(4); ++i) {
      const std::size_t at = below(text.size());
      if (below(3) == 0) {
        text.erase(at, 1 + below(30));
      } else if (below(2) == 0) {
        text.insert(at, pieces[below(std::size(pieces))]);
      } else {
        text.insert(at, whole.substr(below(whole.size()), below(60)));
      }
    }
    gen::SourceMap sources;
    gen::Diagnostics diagnostics;
    const auto description = read_text("test.urdf", text, sources, diagnostics);
    const auto made = description ? make_robot(*description, {}, diagnostics) : std::nullopt;
    EXPECT_EQ(made.has_value(), !diagnostics.has_errors());
    if (made) {
      EXPECT_FALSE((header_text(*made) + manifest_text(*made)).empty());
    }
    read += made.has_value();
    EXPECT_FALSE(run % 50 == 0 && render_text(diagnostics, sources, false).size() > 1'000'000);
  }
  EXPECT_GT(read, 50);
}

}  // namespace
}  // namespace eagerx::urdf

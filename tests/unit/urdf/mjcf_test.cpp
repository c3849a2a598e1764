// Conversion of MJCF: frames, defaults, masses, actuators. tests/urdf has whole robots and
// messages.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <random>
#include <set>
#include <string>

#include "generator/urdf/robot.hpp"

namespace eagerx::urdf {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

std::optional<Robot> mjcf_robot(const std::string& text) {
  gen::SourceMap sources;
  gen::Diagnostics diagnostics;
  const auto description =
      read_text("test.xml", "<mujoco>" + text + "</mujoco>", sources, diagnostics);
  auto robot = description ? make_robot(*description, {}, diagnostics) : std::nullopt;
  if (!robot) std::fputs(render_text(diagnostics, sources, false).c_str(), stderr);
  return robot;
}

void expect_near(const Vector3& a, const Vector3& b, double by = 1e-12) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], by) << i;
}

TEST(Mjcf, PendulumHangsOnTheWorld) {
  const auto made = mjcf_robot(
      "<worldbody><body name='rod' pos='0 0 2'>"
      "<joint name='swing' axis='0 2 0' range='-90 45' damping='0.1' frictionloss='0.2' "
      "armature='0.3'/>"
      "<inertial pos='0 0 -0.5' mass='2' diaginertia='0.1 0.2 0.3'/></body></worldbody>");
  ASSERT_TRUE(made);
  ASSERT_EQ(made->bodies.size(), 1U);
  EXPECT_EQ(made->bodies[0].mass, 2.0);
  expect_near(made->bodies[0].position, {{0, 0, 1.5}});
  ASSERT_EQ(made->joints.size(), 1U);
  const BodyJoint& joint = made->joints[0];
  EXPECT_EQ(joint.parent, "");
  expect_near(joint.anchor, {{0, 0, 2}});
  expect_near(joint.axis, {{0, 1, 0}});
  EXPECT_DOUBLE_EQ(joint.limits.lower, -90 * kDegree);  // degrees by default
  EXPECT_DOUBLE_EQ(joint.limits.upper, 45 * kDegree);
  EXPECT_EQ(joint.limits.damping, 0.1);
  EXPECT_EQ(joint.limits.friction, 0.2);
  EXPECT_EQ(joint.limits.armature, 0.3);
  EXPECT_TRUE(joint.limits.drive.exists);  // no `actuator` says otherwise
}

std::string ball(const std::string& inside, const std::string& more = "") {
  return "<worldbody><body name='a' pos='0 0 1'>" + inside +
         "<inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/></body></worldbody>" + more;
}

/// The same robot in both formats gives the same bytes.
TEST(Mjcf, IsTheSameRobotAsItsUrdf) {
  const auto mjcf = mjcf_robot(
      "<compiler angle='radian'/><worldbody><body name='a' pos='0 0 1' euler='0.1 0 0'>"
      "<joint name='first' axis='0 1 0' range='-1 2' damping='0.1' frictionloss='0.2'/>"
      "<inertial pos='0 0 0.5' mass='2' fullinertia='1 2 2.5 0.1 0.2 0.3'/>"
      "<geom name='shape' type='capsule' size='0.1 0.2' pos='0 0.1 0'/>"
      "<body name='b' pos='0 0.5 0'><joint name='second' type='slide' axis='0 0 1' range='0 1'/>"
      "<inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/></body></body></worldbody>");
  gen::SourceMap sources;
  gen::Diagnostics diagnostics;
  const auto described = read_text(
      "test.xml",
      "<robot name='test'><link name='world'/><link name='a'><inertial><origin xyz='0 0 0.5'/>"
      "<mass value='2'/><inertia ixx='1' iyy='2' izz='2.5' ixy='0.1' ixz='0.2' iyz='0.3'/>"
      "</inertial><collision name='shape'><origin xyz='0 0.1 0'/><geometry><capsule radius='0.1' "
      "length='0.4'/></geometry></collision></link><link name='b'><inertial><mass value='1'/>"
      "<inertia ixx='1' iyy='1' izz='1'/></inertial></link><joint name='first' type='revolute'>"
      "<parent link='world'/><child link='a'/><origin xyz='0 0 1' rpy='0.1 0 0'/><axis xyz='0 1 "
      "0'/>"
      "<limit lower='-1' upper='2'/><dynamics damping='0.1' friction='0.2'/></joint>"
      "<joint name='second' type='prismatic'><parent link='a'/><child link='b'/>"
      "<origin xyz='0 0.5 0'/><axis xyz='0 0 1'/><limit lower='0' upper='1'/></joint></robot>",
      sources, diagnostics);
  ASSERT_TRUE(mjcf && described);
  const auto urdf = make_robot(*described, {}, diagnostics);
  ASSERT_TRUE(urdf);
  EXPECT_EQ(header_text(*mjcf), header_text(*urdf));
  EXPECT_EQ(manifest_text(*mjcf), manifest_text(*urdf));
}

TEST(Mjcf, OrientationsAreThoseOfMuJoCo) {
  const auto axis = [](const std::string& turn, const std::string& compiler = "") {
    const auto made = mjcf_robot("<compiler " + compiler + "/><worldbody><body " + turn +
                                 "><joint axis='1 0 0'/><geom size='0.1'/></body></worldbody>");
    return made ? made->joints[0].axis : Vector3{};
  };
  const double h = std::sqrt(0.5);
  expect_near(axis("quat='2 0 0 2'"), {{0, 1, 0}});
  expect_near(axis("axisangle='0 0 2 90'"), {{0, 1, 0}});
  expect_near(axis("axisangle='0 0 2 1.5707963267948966'", "angle='radian'"), {{0, 1, 0}});
  expect_near(axis("euler='90 0 90'"), {{0, 0, 1}});                    // axes turn along
  expect_near(axis("euler='90 0 90'", "eulerseq='XYZ'"), {{0, 1, 0}});  // fixed axes
  expect_near(axis("euler='90 90 0'", "eulerseq='zyx'"), {{0, 0, -1}});
  expect_near(axis("xyaxes='0 2 0 1 1 0'"), {{0, 1, 0}});
  expect_near(axis("zaxis='1 0 1'"), {{h, 0, -h}});
  expect_near(axis("zaxis='0 0 -1'"), {{1, 0, 0}});
  expect_near(axis("xyaxes='-1 0 0 0 -1 0'"), {{-1, 0, 0}});
  expect_near(axis("xyaxes='-1 0 0 0 0 1'"), {{-1, 0, 0}});
}

TEST(Mjcf, SeveralJointsOfABodyAreAChain) {
  const auto made = mjcf_robot(
      ball("<joint name='x' type='slide' axis='1 0 0'/><joint name='z' type='slide'/>"
           "<joint name='turn' axis='0 1 0' pos='0 0 0.5'/><geom pos='0 0 0.1' size='0.1'/>"));
  ASSERT_TRUE(made);
  ASSERT_EQ(made->joints.size(), 3U);
  EXPECT_EQ(made->joints[2].name, "turn");  // the last one moves the body itself
  EXPECT_EQ(made->joints[2].child, "a");
  expect_near(made->joints[2].anchor, {{0, 0, 1.5}});
  expect_near(made->bodies[2].position, {{0, 0, 1}});
  expect_near(made->shapes[0].position, {{0, 0, 0.1}});
  EXPECT_EQ(made->bodies[0].mass, kSmallShare);
  EXPECT_TRUE(made->bodies[0].is_made);
  EXPECT_EQ(manifest_text(*made).find("x_link_pose"), std::string::npos);
}

/// At position 0 the joint is turned back by its reference.
TEST(Mjcf, ReferencesAreWhatTheDrawingShows) {
  const auto made = mjcf_robot(ball(
      "<joint name='turn' axis='0 1 0' ref='90'/><body name='b' pos='0 0 1'><joint name='slide' "
      "type='slide' axis='0 0 1' ref='0.25'/><geom size='0.1' mass='1'/></body>",
      "<equality><joint joint1='slide' joint2='turn' polycoef='0.5 2 0 0 0'/></equality>"));
  ASSERT_TRUE(made);
  expect_near(made->joints[1].axis, {{-1, 0, 0}});
  expect_near(made->bodies[1].position, {{-0.75, 0, 1}});
  EXPECT_EQ(made->joints[1].mimics, "turn");
  EXPECT_EQ(made->joints[1].ratio, 2.0);
  EXPECT_DOUBLE_EQ(made->joints[1].offset, 0.25 + 0.5 - 2.0 * 90 * kDegree);
}

TEST(Mjcf, GeomsHaveMassesOfTheirShapes) {
  const auto body = [](const std::string& geoms, const std::string& compiler = "") {
    const auto made = mjcf_robot("<compiler " + compiler + "/><worldbody><body><joint/>" + geoms +
                                 "</body></worldbody>");
    return made ? made->bodies[0] : Body{};
  };
  EXPECT_NEAR(body("<geom size='0.1'/>").mass, 4.0 / 3.0 * std::numbers::pi, 1e-12);  // of water
  expect_near(body("<geom size='0.1' mass='2'/>").inertia, {{0.008, 0.008, 0.008}});
  expect_near(body("<geom type='box' size='0.1 0.2 0.3' density='10'/>").inertia,
              0.48 / 3.0 * Vector3{{0.13, 0.1, 0.05}});
  expect_near(body("<geom type='cylinder' size='0.1 0.2' mass='12'/>").inertia,
              {{0.19, 0.19, 0.06}});
  expect_near(body("<geom type='ellipsoid' size='0.1 0.2 0.3' mass='5'/>").inertia,
              {{0.13, 0.1, 0.05}});
  // MuJoCo's of size 0.1 0.2.
  const Body capsule = body("<geom type='capsule' fromto='-0.2 0 0 0.2 0 0' size='0.1'/>");
  EXPECT_NEAR(capsule.mass, 16.755160819145566, 1e-12);
  expect_near(capsule.inertia, {{0.07958701389094143, 0.4461061568097507, 0.4461061568097507}},
              1e-7);
  const Body two = body("<geom size='0.1' mass='1' pos='1 0 0'/><geom size='0.1' mass='3'/>");
  expect_near(two.position, {{0.25, 0, 0}});
  EXPECT_NEAR(two.inertia[1], 0.75 + 4 * 0.004, 1e-12);
  // `inertial` holds unless the compiler says otherwise, and masses can have bounds.
  const std::string inertial = "<inertial pos='0 0 0' mass='9' diaginertia='1 1 1'/>";
  EXPECT_EQ(body("<geom size='0.1' mass='1'/>" + inertial).mass, 9.0);
  EXPECT_EQ(body("<geom size='0.1' mass='1'/>" + inertial, "inertiafromgeom='true'").mass, 1.0);
  EXPECT_EQ(body("<geom size='0.1' mass='1'/>", "boundmass='2'").mass, 2.0);
  EXPECT_EQ(body("<geom size='0.1' mass='1'/>", "settotalmass='4'").mass, 4.0);
}

TEST(Mjcf, ShapesThatEnclose) {
  const auto made =
      mjcf_robot(ball("<joint/><geom type='ellipsoid' size='0.3 0.1 0.05'/>"
                      "<geom type='cylinder' fromto='0 0 0 0 1 0' size='0.1'/>"));
  ASSERT_TRUE(made);
  EXPECT_EQ(made->shapes[0].kind, models::ShapeKind::capsule);
  expect_near(made->shapes[0].size, {{0.1, 0.4, 0}});
  expect_near(rotate(made->shapes[0].rotation, {{0, 0, 1}}), {{1, 0, 0}});
  expect_near(made->shapes[1].size, {{0.1, 1, 0}});
  expect_near(made->shapes[1].position, {{0, 0.5, 0}});
}

TEST(Mjcf, GeomsTouchByTheirBits) {
  const std::string geoms =
      "<joint/><geom name='a' size='1'/><geom name='b' size='1' contype='0' conaffinity='0'/>"
      "<geom name='c' size='1' contype='2' conaffinity='0' friction='0.5 0 0'/>";
  const auto names = [&](const std::string& plane) {
    std::string result;
    const auto made = mjcf_robot("<worldbody>" + plane + "</worldbody>" + ball(geoms));
    for (const Shape& shape : made ? made->shapes : std::vector<Shape>{}) {
      if (!shape.body.empty()) result += shape.name;
    }
    return result;
  };
  EXPECT_EQ(names(""), "a");
  EXPECT_EQ(names("<geom type='plane' size='1 1 1' contype='0' conaffinity='2'/>"), "c");
  EXPECT_EQ(names("<geom type='plane' size='1 1 1' conaffinity='3'/>"), "ac");
}

TEST(Mjcf, DefaultsComeFromTheNearestClass) {
  const auto made = mjcf_robot(
      "<default><joint damping='1' armature='2'/><default class='leg'><joint damping='3'/>"
      "<default class='knee'><joint frictionloss='4'/></default></default></default>"
      "<worldbody><body name='a' childclass='leg'><joint name='j'/><geom size='1'/>"
      "<body name='b'><joint name='k' class='knee' armature='5'/><geom size='1'/>"
      "<frame childclass='main' pos='0 0 1'><body name='c'><joint name='l'/><geom size='1'/></body>"
      "</frame></body></body></worldbody>");
  ASSERT_TRUE(made);
  const auto& joints = made->joints;
  EXPECT_EQ(joints[0].limits.damping, 3.0);
  EXPECT_EQ(joints[0].limits.armature, 2.0);
  EXPECT_EQ(joints[1].limits.damping, 3.0);
  EXPECT_EQ(joints[1].limits.armature, 5.0);
  EXPECT_EQ(joints[1].limits.friction, 4.0);
  EXPECT_EQ(joints[2].limits.damping, 1.0);
  expect_near(joints[2].anchor, {{0, 0, 1}});
}

TEST(Mjcf, ActuatorsSayWhatJointsCanDo) {
  const std::string joints =
      "<joint name='p'/><joint name='q' range='-90 90'/><joint name='r' stiffness='7' "
      "springref='90'/><joint name='s'/>";
  const auto made = mjcf_robot(
      "<default><motor group='1'/></default>" +
      ball(joints,
           "<actuator><motor joint='p' gear='5' ctrlrange='0 1'/><position joint='q' "
           "kp='10' kv='0.5' gear='2' forcerange='-3 4' inheritrange='0.5'/><general "
           "joint='r' gainprm='20' biastype='affine' biasprm='0 -20 -2' ctrllimited='false'/>"
           "</actuator><keyframe><key name='up' qpos='1 2 3 4'/></keyframe>"));
  ASSERT_TRUE(made);
  const Joint &p = made->joints[0].limits, &q = made->joints[1].limits, &r = made->joints[2].limits;
  EXPECT_EQ(p.drive.torque_low, 0.0);
  EXPECT_EQ(p.drive.torque_high, 5.0);
  EXPECT_EQ(p.effort, 5.0);
  EXPECT_FALSE(p.drive.stiffness);
  EXPECT_EQ(q.drive.stiffness, 40.0);  // times gear²
  EXPECT_EQ(q.drive.damping, 2.0);
  EXPECT_EQ(q.effort, 8.0);
  EXPECT_DOUBLE_EQ(q.drive.position_high, 45 * kDegree);
  EXPECT_EQ(r.drive.stiffness, 20.0);
  EXPECT_EQ(r.drive.damping, 2.0);
  EXPECT_TRUE(std::isinf(r.drive.position_high));
  EXPECT_EQ(r.stiffness, 7.0);
  EXPECT_DOUBLE_EQ(r.rest, 90 * kDegree);
  EXPECT_FALSE(made->joints[3].limits.drive.exists);
  const std::string manifest = manifest_text(*made);
  EXPECT_NE(manifest.find("Actuators are those of p q r."), std::string::npos);
  EXPECT_NE(manifest.find("stiffnesses: {type: floats, default: [100.0, 40.0, 20.0]"),
            std::string::npos);
  EXPECT_NE(manifest.find("`up` of the description: [1.0, 2.0, 3.0, 4.0]"), std::string::npos);
}

/// As in a gripper whose fingers follow each other.
TEST(Mjcf, ATendonOfJointsThatFollowEachOtherIsOneActuator) {
  const auto made = mjcf_robot(
      ball("<joint name='l' type='slide'/><joint name='r' type='slide' axis='0 1 0'/>",
           "<equality><joint joint1='r' joint2='l'/></equality><tendon><fixed name='both'>"
           "<joint joint='l' coef='0.5'/><joint joint='r' coef='0.25'/></fixed></tendon>"
           "<actuator><motor tendon='both' ctrlrange='-4 4'/></actuator>"));
  ASSERT_TRUE(made);
  EXPECT_EQ(made->joints[0].limits.drive.torque_high, 3.0);
  EXPECT_EQ(made->joints[1].mimics, "l");
}

TEST(Mjcf, SpheresThatAreAPairTouch) {
  const auto made = mjcf_robot(
      "<worldbody><body name='a'><joint/><geom name='x' size='0.1'/></body>"
      "<body name='b'><joint/><geom name='y' size='0.1'/></body></worldbody>"
      "<contact><pair geom1='y' geom2='x'/></contact>");
  ASSERT_TRUE(made);
  ASSERT_EQ(made->pairs.size(), 1U);
  EXPECT_NE(header_text(*made).find("kPairs = {{\n      {\"y\", \"x\"}}};"), std::string::npos);
}

TEST(Mjcf, WhatFlagsDisableIsLeftOut) {
  const auto made = mjcf_robot(
      "<option gravity='0 0 -1'><flag constraint='disable' "
      "passive='disable'/></option>" +
      ball("<joint range='-1 1' damping='1' frictionloss='1'/>"
           "<geom size='0.1'/>"));
  ASSERT_TRUE(made);
  EXPECT_TRUE(made->shapes.empty());
  EXPECT_TRUE(std::isinf(made->joints[0].limits.upper));
  EXPECT_EQ(made->joints[0].limits.damping, 0.0);
  EXPECT_EQ(made->gravity, (Vector3{{0, 0, -1}}));
}

/// The messages for a text.
std::string said_of(const std::string& text) {
  gen::SourceMap sources;
  gen::Diagnostics diagnostics;
  const auto description =
      read_text("test.xml", "<mujoco>" + text + "</mujoco>", sources, diagnostics);
  if (description) static_cast<void>(make_robot(*description, {}, diagnostics));
  return render_text(diagnostics, sources, false);
}

TEST(Mjcf, WhatIsTooLargeIsRefused) {
  std::string open, close, joints;
  for (int i = 0; i < 15'000; ++i) {
    open += "<default class='c" + std::to_string(i) + "'>";
    close += "</default>";
  }
  for (int i = 0; i < 1'100; ++i) joints += "<joint/>";
  EXPECT_NE(said_of("<default>" + open + close + "</default>" + ball("")).find("in each other"),
            std::string::npos);
  std::string sites;
  for (int i = 0; i < 20'000; ++i) sites += "<site/>";
  EXPECT_NE(said_of(ball(sites)).find("at most 20000 elements"), std::string::npos);
  EXPECT_NE(said_of(ball(joints)).find("more than 1000 bodies or joints"), std::string::npos);
  const std::string heavy = "<joint/><geom size='1' mass='1e308'/><geom size='1' mass='1e308'/>";
  EXPECT_NE(said_of("<worldbody><body name='a'>" + heavy + "</body></worldbody>")
                .find("a number of the body `a` is too large"),
            std::string::npos);
  EXPECT_TRUE(mjcf_robot(ball("<joint/><geom size='1' contype='1e300'/>")));
}

TEST(Mjcf, NamesThatAreMadeLeaveThoseThatAreWritten) {
  const auto made = mjcf_robot(
      "<worldbody><body><joint name='hip'/><joint/><geom size='0.1'/></body>"
      "<body name='body'><joint name='body_2'/><geom size='0.1'/></body>"
      "<body name='hip_link'><joint name='knee'/><geom size='0.1'/></body></worldbody>");
  ASSERT_TRUE(made);
  const auto names_of = [](const auto& items) {
    std::set<std::string> names;
    for (const auto& item : items) names.insert(item.name);
    return names;
  };
  EXPECT_EQ(names_of(made->bodies),
            (std::set<std::string>{"body", "body_2", "hip_link", "hip_link_2"}));
  EXPECT_EQ(names_of(made->joints), (std::set<std::string>{"body_2", "body_2_2", "hip", "knee"}));
}

TEST(Mjcf, AnActuatorThatCannotBeTakenOverIsNamed) {
  const std::string two = said_of(
      ball("<joint name='j'/>",
           "<actuator><position joint='j' kp='9'/><velocity joint='j' kv='3'/></actuator>"));
  EXPECT_NE(two.find("`j` has another actuator already"), std::string::npos) << two;
  const std::string none =
      said_of(ball("<joint name='j'/>", "<actuator><position joint='j' kp='0'/></actuator>"));
  EXPECT_NE(none.find("whose gain is 0"), std::string::npos) << none;
  const std::string ends =
      said_of(ball("<joint name='j'/><geom type='capsule' size='0.1 0.2' fromto='0 0 0 1 0'/>"));
  EXPECT_NE(ends.find("`fromto` has to be six numbers"), std::string::npos) << ends;
}

/// Nothing but places and words of the file may come of damaged files.
TEST(Mjcf, DamagedFilesAreReadOrRefused) {
  std::ifstream file(EAGERX_SOURCE_DIR "/tests/urdf/cases/mjcf_warned.xml", std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(file), {}};
  ASSERT_FALSE(whole.empty());
  std::mt19937 random(1);
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
  int read = 0;
  for (int run = 0; run < 2000; ++run) {
    std::string text = whole;
    for (std::size_t i = 0; i <= below(4); ++i) {
      const std::size_t at = below(text.size());
      if (below(2) == 0)
        text.erase(at, 1 + below(30));
      else
        text.insert(at, whole.substr(below(whole.size()), below(60)));
    }
    gen::SourceMap sources;
    gen::Diagnostics diagnostics;
    const auto description = read_text("test.xml", text, sources, diagnostics);
    const auto made = description ? make_robot(*description, {}, diagnostics) : std::nullopt;
    EXPECT_EQ(made.has_value(), !diagnostics.has_errors());
    if (made) {
      EXPECT_FALSE((header_text(*made) + manifest_text(*made)).empty());
    }
    read += made.has_value();
  }
  EXPECT_GT(read, 20);
}

}  // namespace
}  // namespace eagerx::urdf

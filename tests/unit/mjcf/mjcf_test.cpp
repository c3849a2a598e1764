// What becomes of MJCF: frames, defaults, masses, actuators. tests/urdf has whole robots and
// messages.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "generator/urdf/robot.hpp"

namespace eagerx::urdf {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

std::optional<Robot> robot_of(const std::string& text) {
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
  const auto made = robot_of(
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

}  // namespace
}  // namespace eagerx::urdf

// An arm of seven joints on MultibodyEngine and OpenDynamicsEngine.
#pragma once

#include <array>
#include <cstddef>
#include <models/engines/open_dynamics_engine/scene.hpp>

namespace arm_circle {

using eagerx::models::operator-;

/// Seven links, each a hollow rod between two joints, and a hand; see the manifest. In the
/// reference pose the arm stands upright with the hand hanging down.
template <class Io>
struct SevenJointArm {
  using Real = typename Io::Real;
  using Vector3 = eagerx::models::Vector3;
  static constexpr double kShoulder = 0.333, kElbow = 0.649, kWrist = 1.033;  // heights [m]
  static constexpr double kOffset = 0.0825;  // of the elbow to the front [m]
  static constexpr double kReach = 0.088;    // of the hand in front of the wrist [m]
  static constexpr double kHand = 0.926;     // height of the flange [m]

  /// A rod of this length along z.
  static constexpr eagerx::models::RigidBody rod(const char* name, double mass, double length,
                                                 double radius, const Vector3& center) {
    const double across = mass * (length * length / 12.0 + radius * radius / 2.0);
    return {.name = name,
            .mass = mass,
            .inertia = {{across, across, mass * radius * radius}},
            .position = center};
  }
  static constexpr std::array<eagerx::models::RigidBody, 8> kBodies = {
      {rod("link1", 4.0, 0.2, 0.05, {{0.0, 0.0, 0.25}}),
       rod("link2", 3.0, 0.2, 0.05, {{0.0, -0.01, 0.4}}),
       rod("link3", 3.0, 0.2, 0.045, {{0.01, 0.0, 0.58}}),
       rod("link4", 2.5, 0.2, 0.045, {{0.05, 0.01, 0.72}}),
       rod("link5", 2.0, 0.25, 0.04, {{0.0, -0.02, 0.92}}),
       rod("link6", 1.5, 0.1, 0.04, {{0.05, 0.01, 1.03}}),
       rod("link7", 0.7, 0.08, 0.035, {{kReach, 0.0, 0.97}}),
       rod("hand", Io::Config::load, 0.05, 0.03, {{kReach, 0.0, kHand}})}};

  static constexpr eagerx::models::RigidJoint joint(const char* name, const char* parent,
                                                    const char* child, const Vector3& anchor,
                                                    const Vector3& axis, double low, double high,
                                                    double most) {
    return {.name = name,
            .parent = parent,
            .child = child,
            .anchor = anchor,
            .axis = axis,
            .low = low,
            .high = high,
            .max_torque = most,
            .damping = 0.5,
            .armature = 0.1};
  }
  static constexpr Vector3 kUp{{0.0, 0.0, 1.0}}, kLeft{{0.0, 1.0, 0.0}}, kRight{{0.0, -1.0, 0.0}};
  static constexpr std::array<eagerx::models::RigidJoint, 8> kJoints = {
      {joint("joint1", "", "link1", {{0.0, 0.0, kShoulder}}, kUp, -2.9, 2.9, 87.0),
       joint("joint2", "link1", "link2", {{0.0, 0.0, kShoulder}}, kLeft, -1.76, 1.76, 87.0),
       joint("joint3", "link2", "link3", {{0.0, 0.0, kElbow}}, kUp, -2.9, 2.9, 87.0),
       joint("joint4", "link3", "link4", {{kOffset, 0.0, kElbow}}, kRight, -3.07, -0.07, 87.0),
       joint("joint5", "link4", "link5", {{0.0, 0.0, kWrist}}, kUp, -2.9, 2.9, 12.0),
       joint("joint6", "link5", "link6", {{0.0, 0.0, kWrist}}, kRight, -0.02, 3.75, 12.0),
       joint("joint7", "link6", "link7", {{kReach, 0.0, kWrist}}, {{0.0, 0.0, -1.0}}, -2.9, 2.9,
             12.0),
       {.name = "grasp",
        .kind = eagerx::models::JointKind::fixed,
        .parent = "link7",
        .child = "hand",
        .anchor = {{kReach, 0.0, kHand}}}}};
  /// The drawing of a link: a capsule along z, or with a rotation along x. There is no ground, so
  /// nothing touches.
  static constexpr eagerx::models::RigidGeometry drawn(const char* name, std::size_t body,
                                                       double radius, double length,
                                                       const Vector3& middle, bool along_x) {
    constexpr double kHalf = 0.70710678118654752;
    return {.name = name,
            .kind = eagerx::models::ShapeKind::capsule,
            .body = kBodies[body].name,
            .size = {{radius, length, 0.0}},
            .position = middle - kBodies[body].position,
            .rotation = {{along_x ? kHalf : 1.0, 0.0, along_x ? kHalf : 0.0, 0.0}}};
  }
  static constexpr std::array<eagerx::models::RigidGeometry, 10> kGeometries = {
      {{.name = "stand",
        .kind = eagerx::models::ShapeKind::cylinder,
        .size = {{0.09, 0.14, 0.0}},
        .position = {{0.0, 0.0, 0.07}}},
       drawn("column", 0, 0.06, 0.15, {{0.0, 0.0, 0.22}}, false),
       drawn("upper", 1, 0.06, 0.2, {{0.0, 0.0, 0.43}}, false),
       drawn("above", 2, 0.05, 0.08, {{0.0, 0.0, 0.6}}, false),
       drawn("elbow", 2, 0.045, kOffset, {{0.5 * kOffset, 0.0, kElbow}}, true),
       drawn("lower", 3, 0.045, kOffset, {{0.5 * kOffset, 0.0, kElbow + 0.09}}, true),
       drawn("forearm", 4, 0.045, 0.26, {{0.0, 0.0, 0.89}}, false),
       drawn("wrist", 5, 0.04, kReach, {{0.5 * kReach, 0.0, kWrist}}, true),
       drawn("flange", 6, 0.035, 0.06, {{kReach, 0.0, 0.99}}, false),
       drawn("fist", 7, 0.03, 0.04, {{kReach, 0.0, kHand}}, false)}};
};

}  // namespace arm_circle

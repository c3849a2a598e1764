// Positions and velocities of joints from those of their bodies, and back.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <models/engines/open_dynamics_engine/scene.hpp>

namespace eagerx::models {

/// Where a body is and how it moves, in the world's axes.
struct RigidState {
  Vector3 position{};          // of the centre of mass [m]
  Quaternion rotation{};       // from the reference pose, of length 1
  Vector3 velocity{};          // of the centre of mass [m/s]
  Vector3 angular_velocity{};  // [rad/s]
};

/// Positions and velocities of a joint: one of hinge [rad] and slider [m], two of universal [rad],
/// none of the others.
struct JointCoordinates {
  std::array<double, 2> position{};
  std::array<double, 2> velocity{};
};

/// The value, or 0 if it is not finite.
constexpr double finite_or_zero(double value) {
  return eagerx::isfinite(value) ? value : 0.0;
}
constexpr JointCoordinates finite_coordinates(JointCoordinates at) {
  for (double& value : at.position) value = finite_or_zero(value);
  for (double& value : at.velocity) value = finite_or_zero(value);
  return at;
}

constexpr std::size_t degrees_of_freedom(JointKind kind) {
  if (kind == JointKind::universal) return 2;
  return kind == JointKind::hinge || kind == JointKind::slider ? 1 : 0;
}

/// Position control of a joint; none while max_torque is zero.
template <class Number>
struct JointServoOf {
  Number position;    // [rad, m]
  Number stiffness;   // [N·m/rad, N/m]
  Number damping;     // [N·m·s/rad, N·s/m]
  Number max_torque;  // [N·m, N]

  constexpr Number torque(const Number& at, const Number& velocity) const {
    const Number wanted = stiffness * (position - at) - damping * velocity;
    return eagerx::max(-max_torque, eagerx::min(wanted, max_torque));
  }
};
using JointServo = JointServoOf<double>;

/// Of an environment: on the torques of a joint's actuators, on the gains of its servo.
struct ActuatorFactors {
  double strength, stiffness, damping;
};
constexpr bool is_factor(double value) {
  return value >= 0.0 && eagerx::isfinite(value);
}
constexpr JointServo scaled(JointServo servo, const ActuatorFactors& factors) {
  servo.stiffness *= factors.stiffness;
  servo.damping *= factors.damping;
  return servo;
}

/// The inertia of the child's body at the joint, without further children [kg·m², kg].
constexpr double inertia_of_joint(const RigidJoint& joint, const RigidBody& child) {
  if (joint.kind == JointKind::slider) return child.mass;
  const Vector3 &n = joint.axis, &i = child.inertia, &p = child.products;
  const Vector3 arm = cross(n, child.position - joint.anchor);
  return i[0] * n[0] * n[0] + i[1] * n[1] * n[1] + i[2] * n[2] * n[2] +
         2.0 * (p[0] * n[0] * n[1] + p[1] * n[0] * n[2] + p[2] * n[1] * n[2]) +
         child.mass * dot(arm, arm);
}
/// Of a damped joint, by the implicit Euler method.
constexpr double velocity_after(const RigidJoint& joint, double inertia, double velocity,
                                double torque, double step_s) {
  return (inertia * velocity + step_s * torque) / (inertia + step_s * joint.damping);
}

/// Counts the turns of a hinge, of which a quaternion knows only whether they are even. It takes
/// the rotation's w and its part along the axis: cosine and sine of half the angle, so that a full
/// circle of theirs is two turns of the joint.
struct TurnCounter {
  std::int64_t turns = 0;
  bool was_negative = false;  // the sine

  /// The angle is `position` [rad].
  constexpr void begin(double position, double cosine, double sine) {
    constexpr double kTurnsPerRad = 0.15915494309189535;
    constexpr double kMost = 4503599627370496.0;  // 2^52; a double does not count beyond it
    const double raw = 2.0 * eagerx::atan2(sine, cosine);
    const double all = eagerx::floor((position - raw) * kTurnsPerRad + 0.5);
    turns = static_cast<std::int64_t>(eagerx::max(-kMost, eagerx::min(all, kMost)));
    was_negative = sine < 0.0;
  }
  /// angle_about() jumps by two turns where the cosine is negative and the sine changes its sign.
  constexpr void follow(double cosine, double sine) {
    const bool negative = sine < 0.0;
    if (cosine < 0.0 && negative != was_negative) turns += negative ? 2 : -2;
    was_negative = negative;
  }
};

/// A joint between bodies whose centres of mass are at these places in the reference pose.
struct JointFrame {
  RigidJoint joint;
  Vector3 parent, child, anchor;  // in the reference pose
};

/// Turns of hinges are only known within ±2π.
constexpr JointCoordinates joint_coordinates(const JointFrame& frame, const RigidState& parent,
                                             const RigidState& child) {
  const RigidJoint& joint = frame.joint;
  const Quaternion back = inverse(parent.rotation);
  const Quaternion turn = product(back, child.rotation);
  const Vector3 omega = rotate(back, child.angular_velocity - parent.angular_velocity);
  JointCoordinates result;
  if (joint.kind == JointKind::hinge) {
    result.position[0] = angle_about(turn, joint.axis);
    result.velocity[0] = dot(joint.axis, omega);
  } else if (joint.kind == JointKind::slider) {
    const Vector3 apart = child.position - parent.position;
    const Vector3 speed = child.velocity - parent.velocity - cross(parent.angular_velocity, apart);
    result.position[0] = dot(joint.axis, rotate(back, apart) - (frame.child - frame.parent));
    result.velocity[0] = dot(joint.axis, rotate(back, speed));
  } else if (joint.kind == JointKind::universal) {
    const Vector3 third = cross(joint.axis, joint.axis2);
    const Vector3 moved = rotate(turn, joint.axis2);
    const Vector3 seen = rotate(inverse(turn), joint.axis);
    result.position = {eagerx::atan2(dot(third, moved), dot(joint.axis2, moved)),
                       eagerx::atan2(dot(third, seen), dot(joint.axis, seen))};
    result.velocity = {dot(joint.axis, omega), dot(moved, omega)};
  }
  return result;
}

/// The child that goes with the parent and these coordinates; a ball joint's child keeps its turn
/// and angular velocity relative to the parent, which `before` gives.
constexpr RigidState child_state(const JointFrame& frame, const RigidState& parent,
                                 const JointCoordinates& at, const RigidState& parent_before,
                                 const RigidState& before) {
  const RigidJoint& joint = frame.joint;
  const Quaternion& base = parent.rotation;
  Quaternion turn = kNoRotation;
  Vector3 spin{};            // relative to the parent, in its axes
  Vector3 shift{}, glide{};  // of a slider
  if (joint.kind == JointKind::hinge) {
    turn = rotation(joint.axis, at.position[0]);
    spin = at.velocity[0] * joint.axis;
  } else if (joint.kind == JointKind::slider) {
    shift = at.position[0] * joint.axis;
    glide = at.velocity[0] * joint.axis;
  } else if (joint.kind == JointKind::universal) {
    const Quaternion first = rotation(joint.axis, at.position[0]);
    turn = product(first, rotation(joint.axis2, at.position[1]));
    spin = at.velocity[0] * joint.axis + at.velocity[1] * rotate(first, joint.axis2);
  } else if (joint.kind == JointKind::ball) {
    const Quaternion back = inverse(parent_before.rotation);
    turn = product(back, before.rotation);
    spin = rotate(back, before.angular_velocity - parent_before.angular_velocity);
  }
  RigidState child;
  child.rotation = normalised(product(base, turn));
  child.angular_velocity = parent.angular_velocity + rotate(base, spin);
  const Vector3 anchor = parent.position + rotate(base, frame.anchor + shift - frame.parent);
  child.position = anchor + rotate(child.rotation, frame.child - frame.anchor);
  child.velocity = parent.velocity + cross(parent.angular_velocity, anchor - parent.position) +
                   rotate(base, glide) + cross(child.angular_velocity, child.position - anchor);
  return child;
}

}  // namespace eagerx::models

// Poses that engine states request at a reset.
#pragma once

#include <array>
#include <cstddef>
#include <models/engines/open_dynamics_engine/rigid_joints.hpp>
#include <models/engines/open_dynamics_engine/rotation.hpp>

namespace eagerx::models {

/// Coordinates of joints, and poses and twists of bodies that no joint holds, until clear().
/// Numbers that are not finite count as zero.
template <std::size_t Bodies, std::size_t Joints>
class ResetTargets {
 public:
  void set_joint(std::size_t joint, const JointCoordinates& coordinates) {
    coordinates_[joint] = coordinates;
    has_joint_[joint] = true;
  }
  /// The rotation need not have length 1.
  void set_pose(std::size_t body, const Pose& pose) {
    state_[body].position = {{pose[0], pose[1], pose[2]}};
    state_[body].rotation = normalised({{pose[3], pose[4], pose[5], pose[6]}});
    has_pose_[body] = true;
  }
  void set_twist(std::size_t body, const Twist& twist) {
    state_[body].velocity = {{twist[0], twist[1], twist[2]}};
    state_[body].angular_velocity = {{twist[3], twist[4], twist[5]}};
    has_twist_[body] = true;
  }
  void clear() { *this = {}; }

  bool has_joint(std::size_t joint) const { return has_joint_[joint]; }
  const JointCoordinates& joint(std::size_t joint) const { return coordinates_[joint]; }
  /// `now` with the requested values.
  RigidState state(std::size_t body, RigidState now) const {
    if (has_pose_[body]) {
      now.position = state_[body].position;
      now.rotation = state_[body].rotation;
    }
    if (has_twist_[body]) {
      now.velocity = state_[body].velocity;
      now.angular_velocity = state_[body].angular_velocity;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      now.position[i] = finite_or_zero(now.position[i]);
      now.velocity[i] = finite_or_zero(now.velocity[i]);
      now.angular_velocity[i] = finite_or_zero(now.angular_velocity[i]);
    }
    return now;
  }

 private:
  std::array<JointCoordinates, Joints> coordinates_{};
  std::array<RigidState, Bodies> state_{};
  std::array<bool, Joints> has_joint_{};
  std::array<bool, Bodies> has_pose_{}, has_twist_{};
};

}  // namespace eagerx::models

// A robot of rigid bodies, as two_link_arm.urdf describes it.
// Made by eagerx-urdf. Do not edit: change the description and convert it again.
#pragma once

#include <array>
#include <models/engines/open_dynamics_engine/scene.hpp>

namespace eagerx::models {

/// Positions are in the frame of the link `base`, which is at `origin` in the world.
template <class Io>
struct TwoLinkArmUrdf {
  using Real = typename Io::Real;
  static constexpr Vector3 kOrigin{
      {Io::Config::origin[0], Io::Config::origin[1], Io::Config::origin[2]}};
  static constexpr bool kTouchesItself = Io::Config::touches_itself;

  static constexpr std::array<RigidBody, 2> kBodies = {{
      {.name = "upper_arm",
       .mass = 1.0,
       .inertia = {{0.020833333333333332, 0.020833333333333332, 0.00020833333333333332}},
       .position = {{0.0, 0.0, 0.25}}},
      {.name = "lower_arm",
       .mass = 1.0,
       .inertia = {{0.020833333333333332, 0.020833333333333332, 0.00020833333333333332}},
       .position = {{0.0, 0.0, 0.75}}}}};
  static constexpr std::array<RigidJoint, 2> kJoints = {{
      {.name = "shoulder",
       .child = "upper_arm",
       .anchor = {{0.0, 0.0, 0.0}},
       .axis = {{0.0, 1.0, 0.0}},
       .max_torque = 20.0,
       .max_velocity = 30.0},
      {.name = "elbow",
       .parent = "upper_arm",
       .child = "lower_arm",
       .anchor = {{0.0, 0.0, 0.5}},
       .axis = {{0.0, 1.0, 0.0}},
       .max_torque = 20.0,
       .max_velocity = 30.0}}};
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};
};

}  // namespace eagerx::models

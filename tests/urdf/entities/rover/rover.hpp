// A robot of rigid bodies, as rover.urdf describes it.
// Made by eagerx-urdf. Do not edit: change the description and convert it again.
#pragma once

#include <array>
#include <models/engines/open_dynamics_engine/scene.hpp>

namespace eagerx::models {

/// Positions are in the frame of the link `chassis`, which is at `origin` in the world.
template <class Io>
struct Rover {
  using Real = typename Io::Real;
  static constexpr Vector3 kOrigin{
      {Io::Config::origin[0], Io::Config::origin[1], Io::Config::origin[2]}};
  static constexpr bool kTouchesItself = Io::Config::touches_itself;

  static constexpr std::array<RigidBody, 3> kBodies = {{
      {.name = "chassis",
       .mass = 4.0,
       .inertia = {{0.04, 0.06, 0.08}},
       .position = {{0.0, 0.0, 0.1}}},
      {.name = "left_wheel",
       .mass = 0.5,
       .inertia = {{0.0007, 0.0012, 0.0006999999999999999}},
       .position = {{0.08, 0.13, 0.07}}},
      {.name = "right_wheel",
       .mass = 0.5,
       .inertia = {{0.0007, 0.0012, 0.0006999999999999999}},
       .position = {{0.08, -0.13, 0.07}}}}};
  static constexpr std::array<RigidJoint, 2> kJoints = {{
      {.name = "left",
       .parent = "chassis",
       .child = "left_wheel",
       .anchor = {{0.08, 0.13, 0.07}},
       .axis = {{0.0, 1.0, 2.220446049250313e-16}},
       .max_torque = 2.0,
       .damping = 0.001,
       .friction = 0.01,
       .max_velocity = 20.0},
      {.name = "right",
       .parent = "chassis",
       .child = "right_wheel",
       .anchor = {{0.08, -0.13, 0.07}},
       .axis = {{0.0, 1.0, 2.220446049250313e-16}},
       .max_torque = 2.0,
       .damping = 0.001,
       .friction = 0.01,
       .max_velocity = 20.0}}};
  static constexpr std::array<RigidGeometry, 5> kGeometries = {{
      {.name = "chassis",
       .kind = ShapeKind::box,
       .body = "chassis",
       .size = {{0.3, 0.2, 0.08}},
       .position = {{0.0, 0.0, 0.01999999999999999}},
       .friction = Io::Config::friction,
       .bounce = Io::Config::bounce},
      {.name = "ball",
       .kind = ShapeKind::sphere,
       .body = "chassis",
       .size = {{0.03, 0.0, 0.0}},
       .position = {{-0.12, 0.0, -0.07}},
       .friction = Io::Config::friction,
       .bounce = Io::Config::bounce},
      {.name = "left_wheel",
       .kind = ShapeKind::cylinder,
       .body = "left_wheel",
       .size = {{0.07, 0.03, 0.0}},
       .position = {{0.0, 0.0, 0.0}},
       .friction = Io::Config::friction,
       .bounce = Io::Config::bounce,
       .rotation = {{0.7071067811865476, -0.7071067811865475, 0.0, 0.0}}},
      {.name = "right_wheel",
       .kind = ShapeKind::cylinder,
       .body = "right_wheel",
       .size = {{0.07, 0.03, 0.0}},
       .position = {{0.0, 0.0, 0.0}},
       .friction = Io::Config::friction,
       .bounce = Io::Config::bounce,
       .rotation = {{0.7071067811865476, -0.7071067811865475, 0.0, 0.0}}},
      {.name = "ground_plane", .kind = ShapeKind::plane, .position = -1.0 * kOrigin}}};
};

}  // namespace eagerx::models

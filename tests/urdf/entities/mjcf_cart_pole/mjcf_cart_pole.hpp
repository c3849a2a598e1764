// A robot of rigid bodies, as mjcf_cart_pole.xml describes it.
// Made by eagerx-urdf. Do not edit: change the description and convert it again.
#pragma once

#include <array>
#include <models/engines/open_dynamics_engine/scene.hpp>

namespace eagerx::models {

/// Positions are in the frame of the link `world`, which is at `origin` in the world.
template <class Io>
struct MjcfCartPole {
  using Real = typename Io::Real;
  static constexpr Vector3 kOrigin{
      {Io::Config::origin[0], Io::Config::origin[1], Io::Config::origin[2]}};
  static constexpr bool kTouchesItself = Io::Config::touches_itself;

  static constexpr std::array<RigidBody, 2> kBodies = {{
      {.name = "cart",
       .mass = 1.0,
       .inertia = {{0.01, 0.01, 0.01}},
       .position = {{0.0, 0.0, 0.0}}},
      {.name = "pole",
       .mass = 0.1,
       .inertia = {{0.008333333333333333, 0.008333333333333333, 8.333333333333333e-05}},
       .position = {{0.0, 0.0, 0.5}}}}};
  static constexpr std::array<RigidJoint, 2> kJoints = {{
      {.name = "rail",
       .kind = JointKind::slider,
       .child = "cart",
       .anchor = {{0.0, 0.0, 0.0}},
       .axis = {{1.0, 0.0, 0.0}},
       .low = -100.0,
       .high = 100.0,
       .max_torque = 10.0},
      {.name = "hinge",
       .parent = "cart",
       .child = "pole",
       .anchor = {{0.0, 0.0, 0.0}},
       .axis = {{0.0, 1.0, 0.0}}}}};
  static constexpr std::array<RigidGeometry, 1> kGeometries = {{
      {.name = "floor",
       .kind = ShapeKind::plane,
       .position = {{0.0, 0.0, -2.0}},
       .axis = {{0.0, 0.0, 1.0}},
       .friction = Io::Config::friction,
       .bounce = Io::Config::bounce}}};
};

}  // namespace eagerx::models

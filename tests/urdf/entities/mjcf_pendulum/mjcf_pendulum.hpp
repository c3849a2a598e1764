// A robot of rigid bodies, as mjcf_pendulum.xml describes it.
// Made by eagerx-urdf. Do not edit: change the description and convert it again.
#pragma once

#include <array>
#include <models/engines/open_dynamics_engine/scene.hpp>

namespace eagerx::models {

/// Positions are in the frame of the link `world`, which is at `origin` in the world.
template <class Io>
struct MjcfPendulum {
  using Real = typename Io::Real;
  static constexpr Vector3 kOrigin{
      {Io::Config::origin[0], Io::Config::origin[1], Io::Config::origin[2]}};
  static constexpr bool kTouchesItself = Io::Config::touches_itself;

  static constexpr std::array<RigidBody, 1> kBodies = {{
      {.name = "rod",
       .mass = 0.1,
       .inertia = {{0.008336666666666666, 0.008336666666666666, 6.6666666666666675e-06}},
       .position = {{0.0, 0.0, -0.5}}}}};
  static constexpr std::array<RigidJoint, 1> kJoints = {{
      {.name = "swing",
       .child = "rod",
       .anchor = {{0.0, 0.0, 0.0}},
       .axis = {{0.0, 1.0, 0.0}}}}};
  static constexpr std::array<RigidGeometry, 1> kGeometries = {{
      {.name = "rod",
       .kind = ShapeKind::box,
       .body = "rod",
       .size = {{0.02, 0.02, 1.0}},
       .position = {{0.0, 0.0, 0.0}},
       .friction = Io::Config::friction,
       .bounce = Io::Config::bounce}}};
};

}  // namespace eagerx::models

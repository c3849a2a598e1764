// A robot of rigid bodies, as turned_arm.urdf describes it.
// Made by eagerx-urdf. Do not edit: change the description and convert it again.
#pragma once

#include <array>
#include <models/engines/open_dynamics_engine/scene.hpp>

namespace eagerx::models {

/// Positions are in the frame of the link `world`, which is at `origin` in the world.
template <class Io>
struct TurnedArm {
  using Real = typename Io::Real;
  static constexpr Vector3 kOrigin{
      {Io::Config::origin[0], Io::Config::origin[1], Io::Config::origin[2]}};
  static constexpr bool kTouchesItself = Io::Config::touches_itself;

  static constexpr std::array<RigidBody, 2> kBodies = {{
      {.name = "upper_arm",
       .mass = 1.0,
       .inertia = {{0.020833333333333332, 0.02083333333333334, 0.0002083333333333334}},
       .position = {{5.551115123125783e-17, 0.0, 0.25}},
       .products = {{5.7777898331617076e-34, 7.2824226022142356e-34, 4.607859233063394e-18}}},
      {.name = "lower_arm",
       .mass = 1.0,
       .inertia = {{0.020833333333333336, 0.020833333333333336, 0.00020833333333333343}},
       .position = {{1.734723475976807e-16, 0.0, 0.75}},
       .products = {{4.336808689942018e-19, -6.0647559023407904e-18, 9.215718466126788e-19}}}}};
  static constexpr std::array<RigidJoint, 2> kJoints = {{
      {.name = "shoulder",
       .child = "upper_arm",
       .anchor = {{0.0, 0.0, 0.0}},
       .axis = {{2.220446049250313e-16, 1.0, 0.0}}},
      {.name = "elbow",
       .parent = "upper_arm",
       .child = "lower_arm",
       .anchor = {{1.1102230246251565e-16, 0.0, 0.5}},
       .axis = {{2.220446049250313e-16, 1.0, 0.0}}}}};
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};
};

}  // namespace eagerx::models

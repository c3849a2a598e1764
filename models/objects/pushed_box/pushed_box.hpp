// A box on a plane, on OpenDynamicsEngine.
#pragma once

#include <array>
#include <models/engines/open_dynamics_engine/scene.hpp>

namespace eagerx::models {

/// A homogeneous box that lies on the plane z = 0 and that a force in its centre pushes.
template <class Io>
struct PushedBox {
  using Real = typename Io::Real;
  static constexpr double kMass = Io::Config::mass;  // [kg]
  static constexpr Vector3 kSize{{Io::Config::size[0], Io::Config::size[1], Io::Config::size[2]}};

  static constexpr double inertia(double a, double b) { return kMass * (a * a + b * b) / 12.0; }

  static constexpr std::array<RigidBody, 1> kBodies = {
      {{.name = "box",
        .mass = kMass,
        .inertia = {{inertia(kSize[1], kSize[2]), inertia(kSize[0], kSize[2]),
                     inertia(kSize[0], kSize[1])}},
        .position = {{0.0, 0.0, 0.5 * kSize[2]}}}}};
  static constexpr std::array<RigidJoint, 0> kJoints = {};
  static constexpr std::array<RigidGeometry, 2> kGeometries = {
      {{.name = "box",
        .kind = ShapeKind::box,
        .body = "box",
        .size = kSize,
        .friction = Io::Config::friction,
        .bounce = Io::Config::bounce},
       {.name = "ground", .kind = ShapeKind::plane}}};
};

}  // namespace eagerx::models

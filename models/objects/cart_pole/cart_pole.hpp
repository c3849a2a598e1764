// A pole on a cart on OpenDynamicsEngine.
#pragma once

#include <array>
#include <models/engines/open_dynamics_engine/scene.hpp>

namespace eagerx::models {

/// A cart on a rail along x without friction, and on it a uniform pole on a hinge along y, zero
/// upright. Masses and lengths are those of Gym's CartPole-v1, whose `length` is half the pole.
template <class Io>
struct CartPole {
  using Real = typename Io::Real;
  static constexpr double kPoleMass = 0.1;                                         // [kg]
  static constexpr double kHalfLength = 0.5;                                       // [m]
  static constexpr double kInertia = kPoleMass * kHalfLength * kHalfLength / 3.0;  // [kg·m²]

  static constexpr std::array<RigidBody, 2> kBodies = {
      {{.name = "cart", .mass = 1.0, .inertia = {{0.01, 0.01, 0.01}}},
       {.name = "pole",
        .mass = kPoleMass,
        .inertia = {{kInertia, kInertia, 0.01 * kInertia}},
        .position = {{0.0, 0.0, kHalfLength}}}}};
  static constexpr std::array<RigidJoint, 2> kJoints = {
      {{.name = "rail", .kind = JointKind::slider, .child = "cart", .axis = {{1.0, 0.0, 0.0}}},
       {.name = "hinge", .parent = "cart", .child = "pole"}}};
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};
};

}  // namespace eagerx::models

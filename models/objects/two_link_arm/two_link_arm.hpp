// A planar arm of two rods on OpenDynamicsEngine.
#pragma once

#include <array>
#include <models/engines/open_dynamics_engine/scene.hpp>

namespace eagerx::models {

/// Two uniform rods in the plane y = 0 on hinges along y. Positions are zero when both stand
/// upright; that of the elbow is relative to the upper arm.
template <class Io>
struct TwoLinkArm {
  using Real = typename Io::Real;
  static constexpr double kUpperLength = Io::Config::lengths[0];  // [m]
  static constexpr double kLowerLength = Io::Config::lengths[1];

  static constexpr RigidBody rod(const char* name, double mass, double length, double base) {
    const double inertia = mass * length * length / 12.0;
    return {.name = name,
            .mass = mass,
            .inertia = {{inertia, inertia, 0.01 * inertia}},
            .position = {{0.0, 0.0, base + 0.5 * length}}};
  }

  static constexpr std::array<RigidBody, 2> kBodies = {
      {rod("upper_arm", Io::Config::masses[0], kUpperLength, 0.0),
       rod("lower_arm", Io::Config::masses[1], kLowerLength, kUpperLength)}};
  static constexpr std::array<RigidJoint, 2> kJoints = {{{.name = "shoulder", .child = "upper_arm"},
                                                         {.name = "elbow",
                                                          .parent = "upper_arm",
                                                          .child = "lower_arm",
                                                          .anchor = {{0.0, 0.0, kUpperLength}}}}};
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};
};

}  // namespace eagerx::models

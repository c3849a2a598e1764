// A four-legged robot on OpenDynamicsEngine.
#pragma once

#include <array>
#include <models/engines/open_dynamics_engine/scene.hpp>

namespace eagerx::models {

/// A trunk with four legs of two links, on the plane z = 0. Hips and knees are hinges along y: a
/// positive angle swings a leg backwards. Positions are zero with straight legs; x is forwards, y
/// to the left.
template <class Io>
struct Quadruped {
  using Real = typename Io::Real;
  static constexpr double kLink = 0.2;                // of thigh and shank [m]
  static constexpr double kFoot = 0.025;              // radius [m]
  static constexpr double kHipX = 0.2, kHipY = 0.13;  // [m]
  static constexpr double kHipZ = 2.0 * kLink + kFoot;

  static constexpr RigidBody link(const char* name, double mass, double x, double y, double z) {
    const double inertia = mass * kLink * kLink / 12.0 + 1e-4;
    return {
        .name = name, .mass = mass, .inertia = {{inertia, inertia, 2e-4}}, .position = {{x, y, z}}};
  }
  static constexpr RigidBody thigh(const char* name, double x, double y) {
    return link(name, 1.0, x, y, kHipZ - 0.5 * kLink);
  }
  static constexpr RigidBody shank(const char* name, double x, double y) {
    return link(name, 0.3, x, y, kHipZ - 1.5 * kLink);
  }
  static constexpr RigidJoint hip(const char* name, const char* thigh, double x, double y) {
    return {.name = name,
            .parent = "trunk",
            .child = thigh,
            .anchor = {{x, y, kHipZ}},
            .low = -1.5,
            .high = 1.5};
  }
  static constexpr RigidJoint knee(const char* name, const char* thigh, const char* shank, double x,
                                   double y) {
    return {.name = name,
            .parent = thigh,
            .child = shank,
            .anchor = {{x, y, kHipZ - kLink}},
            .low = -2.5,
            .high = 2.5};
  }
  static constexpr RigidGeometry foot(const char* name, const char* shank) {
    return {.name = name,
            .kind = ShapeKind::sphere,
            .body = shank,
            .size = {{kFoot, 0.0, 0.0}},
            .position = {{0.0, 0.0, -0.5 * kLink}},
            .friction = Io::Config::friction};
  }

  static constexpr std::array<RigidBody, 9> kBodies = {{{.name = "trunk",
                                                         .mass = 6.0,
                                                         .inertia = {{0.05, 0.12, 0.14}},
                                                         .position = {{0.0, 0.0, kHipZ}}},
                                                        thigh("front_left_thigh", kHipX, kHipY),
                                                        shank("front_left_shank", kHipX, kHipY),
                                                        thigh("front_right_thigh", kHipX, -kHipY),
                                                        shank("front_right_shank", kHipX, -kHipY),
                                                        thigh("rear_left_thigh", -kHipX, kHipY),
                                                        shank("rear_left_shank", -kHipX, kHipY),
                                                        thigh("rear_right_thigh", -kHipX, -kHipY),
                                                        shank("rear_right_shank", -kHipX, -kHipY)}};
  static constexpr std::array<RigidJoint, 8> kJoints = {
      {hip("front_left_hip", "front_left_thigh", kHipX, kHipY),
       knee("front_left_knee", "front_left_thigh", "front_left_shank", kHipX, kHipY),
       hip("front_right_hip", "front_right_thigh", kHipX, -kHipY),
       knee("front_right_knee", "front_right_thigh", "front_right_shank", kHipX, -kHipY),
       hip("rear_left_hip", "rear_left_thigh", -kHipX, kHipY),
       knee("rear_left_knee", "rear_left_thigh", "rear_left_shank", -kHipX, kHipY),
       hip("rear_right_hip", "rear_right_thigh", -kHipX, -kHipY),
       knee("rear_right_knee", "rear_right_thigh", "rear_right_shank", -kHipX, -kHipY)}};
  static constexpr std::array<RigidGeometry, 6> kGeometries = {
      {foot("front_left_foot", "front_left_shank"),
       foot("front_right_foot", "front_right_shank"),
       foot("rear_left_foot", "rear_left_shank"),
       foot("rear_right_foot", "rear_right_shank"),
       {.name = "trunk", .kind = ShapeKind::box, .body = "trunk", .size = {{0.45, 0.2, 0.1}}},
       {.name = "ground", .kind = ShapeKind::plane}}};
};

}  // namespace eagerx::models

// Robots of the tests. The walker: twelve joints with the dimensions of a Unitree A1, rounded: hip,
// thigh and shank of four legs, feet of spheres.
#pragma once

#include <array>
#include <models/engines/open_dynamics_engine/scene.hpp>
#include <models/objects/pushed_box/pushed_box.hpp>

#include "tests/unit/multibody/multibody_io.hpp"

namespace eagerx::models::testing {

template <class Io>
struct Walker {
  using Real = typename Io::Real;
  static constexpr double kHipX = 0.1805, kHipY = 0.047, kThighY = 0.0838, kLink = 0.2;
  static constexpr double kFoot = 0.02;
  static constexpr const char* kNames[4][8] = {
      {"fl_hip", "fl_thigh", "fl_shank", "fl_foot", "fl_1", "fl_2", "fl_3", ""},
      {"fr_hip", "fr_thigh", "fr_shank", "fr_foot", "fr_1", "fr_2", "fr_3", ""},
      {"rl_hip", "rl_thigh", "rl_shank", "rl_foot", "rl_1", "rl_2", "rl_3", ""},
      {"rr_hip", "rr_thigh", "rr_shank", "rr_foot", "rr_1", "rr_2", "rr_3", ""}};

  static constexpr double front(std::size_t leg) { return leg < 2 ? 1.0 : -1.0; }
  static constexpr double left(std::size_t leg) { return leg % 2 == 0 ? 1.0 : -1.0; }
  static constexpr Vector3 anchor(std::size_t leg, std::size_t joint) {
    const double y = left(leg) * (joint == 0 ? kHipY : kHipY + kThighY);
    return {{front(leg) * kHipX, y, joint == 2 ? -kLink : 0.0}};
  }

  static constexpr std::array<RigidBody, 13> kBodies = [] {
    std::array<RigidBody, 13> bodies{};
    bodies[0] = {.name = "trunk",
                 .mass = 6.0,
                 .inertia = {{0.0158, 0.0377, 0.0457}},
                 .position = {{0.0, 0.0041, -0.0005}},
                 .products = {{-3.66e-5, -6.11e-5, -2.75e-5}}};
    for (std::size_t leg = 0; leg < 4; ++leg) {
      const double x = front(leg), y = left(leg);
      RigidBody* const body = &bodies[1 + 3 * leg];
      body[0] = {.mass = 0.696,
                 .inertia = {{4.69e-4, 8.07e-4, 5.53e-4}},
                 .position = {{-0.0033 * x, 0.00064 * y, 0.0}},
                 .products = {{-9.41e-6 * x * y, 0.0, 0.0}}};
      body[1] = {.mass = 1.013,
                 .inertia = {{5.53e-3, 5.14e-3, 1.37e-3}},
                 .position = {{-0.00324, -0.0223 * y, -0.0273}},
                 .products = {{-4.8e-6 * y, 3.43e-4, -2.2e-5 * y}}};
      body[2] = {.mass = 0.226,
                 .inertia = {{2.95e-3, 2.97e-3, 3.3e-5}},
                 .position = {{0.00435, 0.0, -0.088}},
                 .products = {{0.0, -1.4e-4, 0.0}}};
      for (std::size_t i = 0; i < 3; ++i) {
        body[i].name = kNames[leg][i];
        body[i].position = body[i].position + anchor(leg, i);
      }
    }
    return bodies;
  }();
  static constexpr std::array<RigidJoint, 12> kJoints = [] {
    std::array<RigidJoint, 12> joints{};
    constexpr double kLow[3] = {-0.8, -1.05, -2.7}, kHigh[3] = {0.8, 4.19, -0.6};
    for (std::size_t leg = 0; leg < 4; ++leg) {
      for (std::size_t i = 0; i < 3; ++i) {
        joints[3 * leg + i] = {.name = kNames[leg][4 + i],
                               .parent = i == 0 ? "trunk" : kNames[leg][i - 1],
                               .child = kNames[leg][i],
                               .anchor = anchor(leg, i),
                               .axis = {{i == 0 ? 1.0 : 0.0, i == 0 ? 0.0 : 1.0, 0.0}},
                               .low = kLow[i],
                               .high = kHigh[i],
                               .max_torque = 33.5,
                               .damping = 0.1,
                               .armature = 0.01};
      }
    }
    return joints;
  }();
  static constexpr std::array<RigidGeometry, 5> kGeometries = [] {
    std::array<RigidGeometry, 5> geometries{};
    for (std::size_t leg = 0; leg < 4; ++leg) {
      geometries[leg] = {
          .name = kNames[leg][3],
          .body = kNames[leg][2],
          .size = {{kFoot, 0.0, 0.0}},
          .position = anchor(leg, 2) + Vector3{{0.0, 0.0, -kLink}} - kBodies[3 + 3 * leg].position,
          .friction = 0.8};
    }
    geometries[4] = {.name = "ground", .kind = ShapeKind::plane};
    return geometries;
  }();
};
template <class Real>
using WalkerOf = Walker<ModelIo<Real, NoConfig>>;

/// A walker without dampers, servos, motors' inertia and ground, thrown into weightless space.
template <class Real>
struct FloatingWalker : WalkerOf<Real> {
  static constexpr std::array<RigidJoint, 12> kJoints = [] {
    auto joints = WalkerOf<Real>::kJoints;
    for (RigidJoint& joint : joints)
      joint.damping = 0.0, joint.armature = 0.0, joint.low = -1e9, joint.high = 1e9;
    return joints;
  }();
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};
};

struct BoxConfig {
  static constexpr double mass = 2.0;
  static constexpr std::array<double, 3> size = {0.2, 0.2, 0.1};
  static constexpr double friction = 0.5;
  static constexpr double bounce = 0.0;
};
template <class Real>
using BoxOf = PushedBox<ModelIo<Real, BoxConfig>>;

}  // namespace eagerx::models::testing

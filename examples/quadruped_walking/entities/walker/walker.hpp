// A quadruped of twelve joints on MultibodyEngine and OpenDynamicsEngine.
#pragma once

#include <array>
#include <cstddef>
#include <models/engines/open_dynamics_engine/scene.hpp>

#include "terrain.hpp"

namespace walking {

/// A trunk and four legs of hip, thigh and calf on the plane z = 0 or terrain; see the manifest.
/// The bodies stand on straight legs in the reference pose.
template <class Io>
struct Walker : Floor<typename Io::Real, Io::Config::terrain> {
  using Real = typename Io::Real;
  static constexpr double kLink = 0.2;                    // length of thigh and calf [m]
  static constexpr double kFoot = 0.02;                   // radius [m]
  static constexpr double kHipX = 0.1805, kHipY = 0.047;  // of the hip from the trunk [m]
  static constexpr double kThighY = 0.0838;               // of the thigh from the hip [m]
  static constexpr double kHeight = 2.0 * kLink + kFoot;  // of the hips [m]

  /// Where a leg is: x and y have these signs.
  struct Leg {
    double x, y;
    const char *hip, *thigh, *calf, *foot;
    const char *hip_link, *thigh_link, *calf_link;
  };
  static constexpr std::array<Leg, 4> kLegs = {
      {{1.0, 1.0, "front_left_hip", "front_left_thigh", "front_left_calf", "front_left_foot",
        "front_left_hip_link", "front_left_thigh_link", "front_left_calf_link"},
       {1.0, -1.0, "front_right_hip", "front_right_thigh", "front_right_calf", "front_right_foot",
        "front_right_hip_link", "front_right_thigh_link", "front_right_calf_link"},
       {-1.0, 1.0, "rear_left_hip", "rear_left_thigh", "rear_left_calf", "rear_left_foot",
        "rear_left_hip_link", "rear_left_thigh_link", "rear_left_calf_link"},
       {-1.0, -1.0, "rear_right_hip", "rear_right_thigh", "rear_right_calf", "rear_right_foot",
        "rear_right_hip_link", "rear_right_thigh_link", "rear_right_calf_link"}}};

  static constexpr eagerx::models::Vector3 hip_at(const Leg& leg) {
    return {{leg.x * kHipX, leg.y * kHipY, kHeight}};
  }
  static constexpr eagerx::models::Vector3 thigh_at(const Leg& leg) {
    return {{leg.x * kHipX, leg.y * (kHipY + kThighY), kHeight}};
  }
  static constexpr eagerx::models::Vector3 knee_at(const Leg& leg) {
    return {{leg.x * kHipX, leg.y * (kHipY + kThighY), kHeight - kLink}};
  }
  static constexpr eagerx::models::Vector3 sum(const eagerx::models::Vector3& a,
                                               const eagerx::models::Vector3& b) {
    return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}};
  }

  static constexpr std::array<eagerx::models::RigidBody, 13> bodies() {
    std::array<eagerx::models::RigidBody, 13> all{};
    all[0] = {.name = "trunk",
              .mass = 6.0,
              .inertia = {{0.0158, 0.0377, 0.0457}},
              .position = {{0.0, 0.0041, kHeight - 0.0005}},
              .products = {{-3.66e-5, -6.11e-5, -2.75e-5}}};
    for (std::size_t i = 0; i < 4; ++i) {
      const Leg& leg = kLegs[i];
      all[3 * i + 1] = {.name = leg.hip_link,
                        .mass = 0.696,
                        .inertia = {{4.69e-4, 8.07e-4, 5.53e-4}},
                        .position = sum(hip_at(leg), {{leg.x * -0.0033, leg.y * 0.00064, 0.0}}),
                        .products = {{leg.x * leg.y * -9.41e-6, 0.0, 0.0}}};
      all[3 * i + 2] = {.name = leg.thigh_link,
                        .mass = 1.013,
                        .inertia = {{5.53e-3, 5.14e-3, 1.37e-3}},
                        .position = sum(thigh_at(leg), {{-0.00324, leg.y * -0.0223, -0.0273}}),
                        .products = {{leg.y * -4.8e-6, 3.43e-4, leg.y * -2.2e-5}}};
      all[3 * i + 3] = {.name = leg.calf_link,
                        .mass = 0.226,
                        .inertia = {{2.95e-3, 2.97e-3, 3.3e-5}},
                        .position = sum(knee_at(leg), {{0.00435, 0.0, -0.088}}),
                        .products = {{0.0, -1.4e-4, 0.0}}};
    }
    return all;
  }

  static constexpr eagerx::models::RigidJoint joint(const char* name, const char* parent,
                                                    const char* child,
                                                    const eagerx::models::Vector3& anchor,
                                                    double low, double high) {
    return {.name = name,
            .parent = parent,
            .child = child,
            .anchor = anchor,
            .low = low,
            .high = high,
            .damping = 0.1,
            .armature = 0.01};
  }
  static constexpr std::array<eagerx::models::RigidJoint, 12> joints() {
    std::array<eagerx::models::RigidJoint, 12> all{};
    for (std::size_t i = 0; i < 4; ++i) {
      const Leg& leg = kLegs[i];
      all[3 * i] = joint(leg.hip, "trunk", leg.hip_link, hip_at(leg), -0.8, 0.8);
      all[3 * i].axis = {{1.0, 0.0, 0.0}};
      all[3 * i + 1] = joint(leg.thigh, leg.hip_link, leg.thigh_link, thigh_at(leg), -1.05, 4.19);
      all[3 * i + 2] = joint(leg.calf, leg.thigh_link, leg.calf_link, knee_at(leg), -2.7, -0.6);
    }
    return all;
  }

  static constexpr std::array<eagerx::models::RigidGeometry, 5> geometries() {
    std::array<eagerx::models::RigidGeometry, 5> all{};
    for (std::size_t i = 0; i < 4; ++i)
      all[i] = {.name = kLegs[i].foot,
                .kind = eagerx::models::ShapeKind::sphere,
                .body = kLegs[i].calf_link,
                .size = {{kFoot, 0.0, 0.0}},
                .position = {{-0.00435, 0.0, 0.088 - kLink}}};
    all[4] = {.name = "ground", .kind = eagerx::models::ShapeKind::plane};
    return all;
  }

  static constexpr auto kBodies = bodies();
  static constexpr auto kJoints = joints();
  static constexpr auto kGeometries = geometries();
};

}  // namespace walking

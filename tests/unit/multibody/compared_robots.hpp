// Robots whose accelerations are compared with MuJoCo's: a humanoid and a hand, whose dimensions
// are those of public URDFs (Unitree H1, Allegro), rounded; an arm and a quadruped without stops.
#pragma once

#include <array>
#include <cstddef>
#include <examples/arm_circle/entities/seven_joint_arm/seven_joint_arm.hpp>
#include <limits>

#include "tests/unit/multibody/robots.hpp"

namespace eagerx::models::testing {

/// A joint and the body that it moves; places are from the joint.
struct LinkRow {
  const char* name;    // of body and joint
  const char* parent;  // empty: the world
  Vector3 offset;      // of the joint, from the parent's joint [m]
  Vector3 axis;
  double mass;       // [kg]
  Vector3 center;    // of mass [m]
  Vector3 inertia;   // [kg·m²]
  Vector3 products;  // Ixy, Ixz, Iyz
};

template <std::size_t N>
constexpr Vector3 anchor_of(const std::array<LinkRow, N>& rows, const char* name) {
  const std::size_t row = scene::find(rows, name);
  return row == N ? Vector3{} : anchor_of(rows, rows[row].parent) + rows[row].offset;
}
/// Bodies of the rows, after those of `base`.
template <std::size_t Base, std::size_t N>
constexpr auto bodies_of(const std::array<RigidBody, Base>& base,
                         const std::array<LinkRow, N>& rows) {
  std::array<RigidBody, Base + N> bodies{};
  for (std::size_t b = 0; b < Base; ++b) bodies[b] = base[b];
  for (std::size_t i = 0; i < N; ++i)
    bodies[Base + i] = {.name = rows[i].name,
                        .mass = rows[i].mass,
                        .inertia = rows[i].inertia,
                        .position = anchor_of(rows, rows[i].name) + rows[i].center,
                        .products = rows[i].products};
  return bodies;
}
template <std::size_t N>
constexpr auto joints_of(const std::array<LinkRow, N>& rows, double damping, double armature) {
  std::array<RigidJoint, N> joints{};
  for (std::size_t i = 0; i < N; ++i)
    joints[i] = {.name = rows[i].name,
                 .parent = rows[i].parent,
                 .child = rows[i].name,
                 .anchor = anchor_of(rows, rows[i].name),
                 .axis = rows[i].axis,
                 .damping = damping,
                 .armature = armature};
  return joints;
}

/// The row in a frame that is turned by q.
constexpr LinkRow turned(const Quaternion& q, LinkRow row) {
  row.axis = rotate(q, row.axis);
  row.center = rotate(q, row.center);
  // q·I·qᵀ by the columns of q.
  std::array<Vector3, 3> column{};
  for (std::size_t k = 0; k < 3; ++k) {
    Vector3 unit{};
    unit[k] = 1.0;
    column[k] = rotate(q, unit);
  }
  const Vector3 i = row.inertia, p = row.products;
  const double matrix[3][3] = {{i[0], p[0], p[1]}, {p[0], i[1], p[2]}, {p[1], p[2], i[2]}};
  const auto element = [&](std::size_t a, std::size_t b) {
    double sum = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t l = 0; l < 3; ++l) sum += column[k][a] * matrix[k][l] * column[l][b];
    }
    return sum;
  };
  row.inertia = {{element(0, 0), element(1, 1), element(2, 2)}};
  row.products = {{element(0, 1), element(0, 2), element(1, 2)}};
  return row;
}

/// A pelvis with two legs of five joints, and a torso with two arms of four, whose shoulders are
/// tilted.
template <class RealType>
struct Humanoid {
  using Real = RealType;
  static constexpr Vector3 kX{{1.0, 0.0, 0.0}}, kY{{0.0, 1.0, 0.0}}, kZ{{0.0, 0.0, 1.0}};
  static constexpr std::array<RigidBody, 1> kPelvis = {{{.name = "pelvis",
                                                         .mass = 6.0,
                                                         .inertia = {{0.0492, 0.009, 0.0532}},
                                                         .position = {{0.0, 0.0, -0.047}},
                                                         .products = {{-2e-5, -4.8e-5, 3e-6}}}}};
  static constexpr const char* kNames[2][9] = {
      {"left_hip_yaw", "left_hip_roll", "left_hip_pitch", "left_knee", "left_ankle",
       "left_shoulder_pitch", "left_shoulder_roll", "left_shoulder_yaw", "left_elbow"},
      {"right_hip_yaw", "right_hip_roll", "right_hip_pitch", "right_knee", "right_ankle",
       "right_shoulder_pitch", "right_shoulder_roll", "right_shoulder_yaw", "right_elbow"}};

  static constexpr auto kRows = [] {
    std::array<LinkRow, 19> rows{};
    rows[10] = {"torso",
                "",
                {},
                kZ,
                17.8,
                {{5e-4, 0.0028, 0.205}},
                {{0.487, 0.41, 0.128}},
                {{-5e-4, 2e-3, -7e-4}}};
    for (std::size_t side = 0; side < 2; ++side) {
      const double s = side == 0 ? 1.0 : -1.0;
      const char* const* const name = kNames[side];
      LinkRow* const leg = &rows[5 * side];
      leg[0] = {name[0],
                "",
                {{0.0, 0.0875 * s, -0.174}},
                kZ,
                2.97,
                {{-0.061, 0.0, 0.008}},
                {{5.32e-3, 5.02e-3, 4.1e-3}},
                {{0.0, -8.8e-4, 0.0}}};
      leg[1] = {name[1],
                name[0],
                {{0.0395, 0.0, 0.0}},
                kX,
                2.72,
                {{-0.005, -0.0136 * s, 0.0}},
                {{3.08e-3, 4.37e-3, 3.48e-3}},
                {{1.7e-4 * s, 0.0, 0.0}}};
      leg[2] = {name[2],
                name[1],
                {{0.0, 0.1154 * s, 0.0}},
                kY,
                4.95,
                {{0.0076, -0.0293 * s, -0.0827}},
                {{0.0963, 0.0953, 0.0083}},
                {{-8.5e-4 * s, 4.5e-3, 0.0107 * s}}};
      leg[3] = {name[3],
                name[2],
                {{0.0, 0.0, -0.4}},
                kY,
                2.82,
                {{0.0034, -0.0053 * s, -0.1437}},
                {{0.0238, 0.0245, 0.0032}},
                {{-2e-4 * s, 1.35e-3, 3.4e-4 * s}}};
      leg[4] = {name[4],
                name[3],
                {{0.0, 0.0, -0.4}},
                kY,
                0.725,
                {{0.0425, 0.0, -0.0417}},
                {{2.37e-4, 3.3e-3, 3.15e-3}},
                {{0.0, 1.97e-4, 0.0}}};
      LinkRow* const arm = &rows[11 + 4 * side];
      arm[0] = {name[5],
                "torso",
                {{0.0055, 0.155 * s, 0.43}},
                rotate(rotation(kX, 0.436 * s), kY),
                1.14,
                {{0.005, 0.0537 * s, -0.0157}},
                {{1.3e-3, 8.7e-4, 9.7e-4}},
                {{-1.7e-5 * s, 9e-6, 4e-5 * s}}};
      arm[1] = {name[6],
                name[5],
                {{-0.0055, 0.0565 * s, -0.0165}},
                kX,
                0.85,
                {{7e-4, 0.0012 * s, -0.094}},
                {{1.57e-3, 1.7e-3, 1.02e-3}},
                {{2e-6 * s, -7.2e-5, -6.4e-5 * s}}};
      arm[2] = {name[7],
                name[6],
                {{0.0, 0.0, -0.134}},
                kZ,
                0.86,
                {{0.0137, 0.0028 * s, -0.1627}},
                {{3.66e-3, 4.08e-3, 6.6e-4}},
                {{-1.1e-5 * s, 3.5e-4, 7e-5 * s}}};
      arm[3] = {name[8],
                name[7],
                {{0.0185, 0.0, -0.198}},
                kY,
                0.745,
                {{0.165, 0.0, -0.0157}},
                {{4.2e-4, 6.0e-3, 6.0e-3}},
                {{-3.6e-5 * s, 2.9e-4, 5e-6 * s}}};
    }
    return rows;
  }();
  static constexpr auto kBodies = bodies_of(kPelvis, kRows);
  static constexpr auto kJoints = [] {
    auto joints = joints_of(kRows, 0.2, 0.01);
    for (RigidJoint& joint : joints) {
      if (*joint.parent == '\0') joint.parent = "pelvis";
    }
    return joints;
  }();
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};
};

/// Three fingers, two of them spread, and a thumb, of four joints each, on a palm that is the
/// world.
template <class RealType>
struct Hand {
  using Real = RealType;
  static constexpr const char* kNames[4][4] = {{"index_0", "index_1", "index_2", "index_3"},
                                               {"middle_0", "middle_1", "middle_2", "middle_3"},
                                               {"ring_0", "ring_1", "ring_2", "ring_3"},
                                               {"thumb_0", "thumb_1", "thumb_2", "thumb_3"}};
  static constexpr Vector3 kX{{1.0, 0.0, 0.0}}, kY{{0.0, 1.0, 0.0}}, kZ{{0.0, 0.0, 1.0}};

  /// A rod of a rectangular cross section along z.
  static constexpr LinkRow rod(const char* name, const char* parent, const Vector3& axis,
                               double mass, double length) {
    constexpr double kWide = 0.0275, kThick = 0.0196;
    const auto square = [&](double a, double b) { return mass * (a * a + b * b) / 12.0; };
    return {name,
            parent,
            {},
            axis,
            mass,
            {{0.0, 0.0, 0.5 * length}},
            {{square(kWide, length), square(kThick, length), square(kWide, kThick)}},
            {}};
  }
  static constexpr auto kRows = [] {
    std::array<LinkRow, 16> rows{};
    constexpr double kLength[2][4] = {{0.0164, 0.054, 0.0384, 0.0487},
                                      {0.04, 0.0177, 0.0514, 0.06}};
    constexpr double kMass[2][4] = {{0.012, 0.065, 0.0355, 0.0264}, {0.0176, 0.012, 0.038, 0.0556}};
    for (std::size_t f = 0; f < 4; ++f) {
      const bool thumb = f == 3;
      const double side = 1.0 - static_cast<double>(f);
      const Vector3 axes[4] = {thumb ? -1.0 * kX : kZ, thumb ? kZ : kY, kY, kY};
      const Quaternion turn =
          thumb ? product(rotation(kZ, -1.57), rotation(kY, -1.66)) : rotation(kX, -0.087 * side);
      for (std::size_t i = 0; i < 4; ++i) {
        LinkRow& row = rows[4 * f + i];
        row = turned(turn, rod(kNames[f][i], i == 0 ? "" : kNames[f][i - 1], axes[i],
                               kMass[thumb][i], kLength[thumb][i]));
        if (i > 0) row.offset = rotate(turn, {{0.0, 0.0, kLength[thumb][i - 1]}});
      }
      rows[4 * f].offset = thumb ? Vector3{{-0.018, 0.019, -0.046}}
                                 : Vector3{{0.0, 0.0435 * side, -0.0015 * side * side}};
    }
    return rows;
  }();
  static constexpr auto kBodies = bodies_of(std::array<RigidBody, 0>{}, kRows);
  static constexpr auto kJoints = joints_of(kRows, 1e-3, 1e-5);
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};
};

/// Any state is inside.
template <class Joints>
constexpr Joints without_stops(Joints joints) {
  for (RigidJoint& joint : joints) {
    joint.high = joint.max_torque = std::numeric_limits<double>::infinity();
    joint.low = -joint.high;
  }
  return joints;
}
struct ArmConfig {
  static constexpr double load = 0.5;  // [kg]
};
template <class RealType>
struct FreeArm : arm_circle::SevenJointArm<ModelIo<RealType, ArmConfig>> {
  using Arm = arm_circle::SevenJointArm<ModelIo<RealType, ArmConfig>>;
  static constexpr auto kJoints = without_stops(Arm::kJoints);
};
template <class RealType>
struct FreeQuadruped : WalkerOf<RealType> {
  static constexpr auto kJoints = without_stops(WalkerOf<RealType>::kJoints);
  static constexpr std::array<RigidGeometry, 0> kGeometries = {};
};

}  // namespace eagerx::models::testing

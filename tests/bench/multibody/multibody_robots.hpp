// Many robots on MultibodyEngine, LANES in a SIMD vector, which stand on their servos. LEGS and
// JOINTS of a leg: without them, the walker of the tests.
#pragma once

#include <array>
#include <cstring>
#include <eagerx/simd.hpp>
#include <vector>

#include "tests/unit/multibody/compared_robots.hpp"

namespace bench {

using namespace eagerx::models;
using namespace eagerx::models::testing;

#if defined(LEGS)
/// A trunk on LEGS legs, two in a row, of 3 or 5 joints: one or two of the hip, then links of 0.2
/// m.
template <class RealType>
struct Robot {
  using Real = RealType;
  static constexpr std::size_t kOfLeg = JOINTS, kHips = kOfLeg == 3 ? 1 : 2;
  static_assert(kOfLeg == 3 || kOfLeg == 5);
  static constexpr double kStiffness = 300.0, kMostTorque = 200.0;
  static constexpr double kStart = kOfLeg == 3 ? 0.28 : 0.48;  // height [m]
  static constexpr double home(std::size_t j) {
    constexpr double kOfThree[3] = {0.9, -1.8, 0.9};
    return j % kOfLeg < kHips ? 0.0 : kOfThree[j % kOfLeg - kHips];
  }

  static constexpr auto kNames = [] {
    std::array<std::array<char, 3>, LEGS * kOfLeg> names{};
    for (std::size_t i = 0; i < names.size(); ++i)
      names[i] = {static_cast<char>('0' + i / 10), static_cast<char>('0' + i % 10), '\0'};
    return names;
  }();
  static constexpr LinkRow row(std::size_t leg, std::size_t i) {
    const double side = leg % 2 == 0 ? 1.0 : -1.0;
    const double place = 0.2 - 0.2 * static_cast<double>(leg / 2);
    LinkRow link = {.name = kNames[leg * kOfLeg + i].data(),
                    .parent = i == 0 ? "trunk" : kNames[leg * kOfLeg + i - 1].data(),
                    .offset = {{0.0, 0.0, -0.2}},
                    .axis = {{0.0, 1.0, 0.0}},
                    .mass = i + 1 == kOfLeg ? 0.226 : 1.013,
                    .center = {{-0.003, -0.02 * side, i + 1 == kOfLeg ? -0.088 : -0.027}},
                    .inertia = {{5.5e-3, 5.1e-3, 1.4e-3}},
                    .products = {{-4.8e-6 * side, 3.4e-4, -2.2e-5 * side}}};
    if (i < kHips) {
      link.axis = {{0.0, 0.0, 0.0}};
      link.axis[i + 1 < kHips ? 2 : 0] = 1.0;
      link.mass = 0.696;
      link.center = {{-0.0033, 6.4e-4 * side, 0.0}};
      link.offset = i == 0 ? Vector3{{place, 0.047 * side, 0.0}} : Vector3{};
    } else if (i == kHips) {
      link.offset = {{0.0, 0.0838 * side, 0.0}};
    }
    return link;
  }
  static constexpr auto kRows = [] {
    std::array<LinkRow, LEGS * kOfLeg> rows{};
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = row(i / kOfLeg, i % kOfLeg);
    return rows;
  }();
  static constexpr auto kBodies =
      bodies_of(std::array<RigidBody, 1>{{WalkerOf<Real>::kBodies[0]}}, kRows);
  static constexpr auto kJoints = [] {
    auto joints = joints_of(kRows, 0.1, 0.01);
    for (RigidJoint& joint : joints)
      joint.low = -3.0, joint.high = 3.0, joint.max_torque = kMostTorque;
    return joints;
  }();
  static constexpr auto kGeometries = [] {
    std::array<RigidGeometry, LEGS + 1> geometries{};
    for (std::size_t leg = 0; leg < LEGS; ++leg) {
      const std::size_t calf = leg * kOfLeg + kOfLeg - 1;
      geometries[leg] = {.name = kNames[calf].data(),
                         .body = kNames[calf].data(),
                         .size = {{0.02, 0.0, 0.0}},
                         .position = Vector3{{0.0, 0.0, -0.2}} - kRows[calf].center,
                         .friction = 0.8};
    }
    geometries[LEGS] = {.name = "ground", .kind = ShapeKind::plane};
    return geometries;
  }();
};
#else
template <class Real>
struct Robot : WalkerOf<Real> {
  static constexpr double kStart = 0.28, kStiffness = 40.0, kMostTorque = 33.5;
  static constexpr double home(std::size_t j) { return j % 3 == 0 ? 0.0 : j % 3 == 1 ? 0.9 : -1.8; }
};
#endif

constexpr std::size_t kRobots = 64;
#if LANES == 1
using Real = float;
#else
using Real = eagerx::Simd<float, LANES>;
#endif
using One = MultibodySimulator<Robot<float>>;
using Group = MultibodySimulator<Robot<Real>>;

/// In a function of its own, so that instructions are those of a step.
[[gnu::noinline]] inline void step_group(Group& group) {
  constexpr multibody::ContactSettings<float> kSettings{2e4F, 400.0F, 0.005F, 0.2F, 0.005F};
  group.step(kSettings, 4);
}

struct Robots {
  std::vector<Group> groups = std::vector<Group>(kRobots / LANES);

  Robots() {
    for (std::size_t e = 0; e < kRobots; ++e) {
      One one{};
      one.start({{0.0, 0.0, -9.81}});
      const double height = Robot<float>::kStart + 0.001 * static_cast<double>(e % 50);
      one.want_pose(0, {{0.0, 0.0, height, 1.0, 0.0, 0.0, 0.0}});
      for (std::size_t j = 0; j < One::kJoints; ++j) {
        const auto home = Robot<float>::home(j);
        const auto off = static_cast<float>((e * 5 + j) % 13) * 0.01F - 0.06F;
        one.want_joint(j, {{home, 0.0}, {0.0, 0.0}});
        one.set_joint_servo(
            j, {static_cast<float>(home) + off, static_cast<float>(Robot<float>::kStiffness), 1.0F,
                static_cast<float>(Robot<float>::kMostTorque)});
      }
      one.begin_episode();
      static_assert(sizeof(Group) == LANES * sizeof(One));
      auto* const to = reinterpret_cast<char*>(&groups[e / LANES]);
      for (std::size_t word = 0; word < sizeof(One) / 4; ++word)
        std::memcpy(to + 4 * (word * LANES + e % LANES), reinterpret_cast<char*>(&one) + 4 * word,
                    4);
    }
  }
  void step() {
    for (Group& group : groups) step_group(group);
  }
  double height() {
    double sum = 0.0;
    for (std::size_t e = 0; e < kRobots; ++e)
      sum += static_cast<double>(
          eagerx::lane(groups[e / LANES].numbers().position.z, static_cast<int>(e % LANES)));
    return sum / kRobots;
  }
};

}  // namespace bench

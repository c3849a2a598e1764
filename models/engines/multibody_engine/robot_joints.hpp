// The joints in the model of a robot's controller, and the motion of its links.
#pragma once

#include <array>
#include <cstddef>
#include <models/engines/multibody_engine/constants.hpp>
#include <models/engines/multibody_engine/mimic.hpp>
#include <models/engines/open_dynamics_engine/scene.hpp>

namespace eagerx::models::multibody {

/// Coordinate of a link = factor · (position of joint `owner` of the list) + offset [rad, m].
struct Following {
  std::size_t owner = kNone;  // kNone: it stands at `offset`
  double factor = 0.0, offset = 0.0;
};

/// Hinges and sliders that mimic no other joint, in the order of the model: the default for an
/// empty list.
template <class Model>
constexpr bool leads(const RigidJoint& joint) {
  return moves(joint.kind) && *joint.mimics == '\0';
}
template <class Model>
constexpr std::size_t count_leaders() {
  std::size_t count = 0;
  for (const auto& joint : Model::kJoints) count += leads<Model>(joint) ? 1 : 0;
  return count;
}

/// `Names::joints` lists names of a model's joints, separated by blanks; empty: all that move.
/// Joints that mimic one of them follow it; all others stay at 0.
template <class Model, class Names>
struct RobotJoints {
  static constexpr std::size_t kLinks = kTree<Model>.links.size();
  static constexpr std::size_t kListed = scene::count_names(Names::joints);
  static constexpr std::size_t kCount = kListed == 0 ? count_leaders<Model>() : kListed;
  /// Positions in the model's kJoints.
  static constexpr std::array<std::size_t, kCount> kJoints = [] {
    if constexpr (kListed > 0) {
      return scene::find_all<kCount>(Model::kJoints, Names::joints);
    } else {
      std::array<std::size_t, kCount> all{};
      std::size_t next = 0;
      for (std::size_t j = 0; j < Model::kJoints.size(); ++j) {
        if (leads<Model>(Model::kJoints[j])) all[next++] = j;
      }
      return all;
    }
  }();
  static constexpr bool kExist = scene::all_below(kJoints, Model::kJoints.size());
  static_assert(kExist, "`joints` names a joint that the robot does not have");
  static constexpr bool kLead = [] {
    for (const std::size_t joint : kJoints) {
      if (kExist && !leads<Model>(Model::kJoints[joint])) return false;
    }
    return true;
  }();
  static_assert(kLead, "`joints` are hinges and sliders, and mimic no other joint");

  static constexpr std::array<Following, kLinks> kFollowing = [] {
    std::array<Following, kLinks> result{};
    for (std::size_t l = 0; l < kLinks; ++l) {
      for (std::size_t i = 0; i < kCount; ++i) {
        if (kTree<Model>.links[l].joint == kJoints[i])
          result[l] = {.owner = i, .factor = kTree<Model>.links[l].sign, .offset = 0.0};
      }
    }
    for (const Mimicry& mimicry : kMimics<Model>) {
      const Following& leader = result[mimicry.leader];
      result[mimicry.follower] = {
          .owner = leader.owner, .factor = mimicry.ratio * leader.factor, .offset = mimicry.offset};
    }
    return result;
  }();
};

/// Of all links of a robot, in the tree's order and sign.
template <class Model, class Real>
struct LinkNumbers {
  static constexpr std::size_t kLinks = kTree<Model>.links.size();
  Real of[kLinks == 0 ? 1 : kLinks];
};

/// Coordinates of links from positions of joints; of velocities and accelerations without offsets.
template <class Model, class Joints, class Real>
inline LinkNumbers<Model, Real> of_links(const std::array<Real, Joints::kCount>& x,
                                         bool with_offsets) {
  using Lane = LaneOf<Real>;
  LinkNumbers<Model, Real> result;
  for (std::size_t l = 0; l < Joints::kLinks; ++l) {
    const Following& following = Joints::kFollowing[l];
    result.of[l] = Real(static_cast<Lane>(with_offsets ? following.offset : 0.0));
    if (following.owner != kNone)
      result.of[l] = result.of[l] + Real(static_cast<Lane>(following.factor)) * x[following.owner];
  }
  return result;
}
/// The sum of the links' torques for each joint.
template <class Model, class Joints, class Real>
inline std::array<Real, Joints::kCount> of_joints(const LinkNumbers<Model, Real>& torque) {
  std::array<Real, Joints::kCount> sum;
  for (auto& element : sum) element = Real(LaneOf<Real>(0));
  for (std::size_t l = 0; l < Joints::kLinks; ++l) {
    const Following& following = Joints::kFollowing[l];
    if (following.owner == kNone) continue;
    sum[following.owner] += Real(static_cast<LaneOf<Real>>(following.factor)) * torque.of[l];
  }
  return sum;
}

}  // namespace eagerx::models::multibody

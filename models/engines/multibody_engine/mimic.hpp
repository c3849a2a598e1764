// Joints that follow others: position = ratio · (position of the leader) + offset.
//
// Each is an equation of the velocities of the end of the step, v_follower = ratio · v_leader. The
// torques that keep it are found without iterations, from the factors of the mass matrix: G =
// J·M⁻¹·Jᵀ is as large as there are such joints. Positions then are set by the leader's, so nothing
// drifts.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/math.hpp>
#include <models/engines/multibody_engine/constants.hpp>
#include <models/engines/multibody_engine/contact.hpp>

namespace eagerx::models::multibody {

/// Of links, in their coordinates.
struct Mimicry {
  std::size_t follower = 0, leader = 0;
  double ratio = 1.0, offset = 0.0;
};

template <class Model>
constexpr std::size_t count_mimics() {
  std::size_t count = 0;
  for (const auto& joint : Model::kJoints) count += *joint.mimics == '\0' ? 0 : 1;
  return count;
}

/// Whether every follower is a hinge or slider, and follows one that follows none.
template <class Model>
constexpr bool has_leaders() {
  for (const auto& joint : Model::kJoints) {
    if (*joint.mimics == '\0') continue;
    const std::size_t leader = scene::find(Model::kJoints, joint.mimics);
    if (!moves(joint.kind) || leader == Model::kJoints.size()) return false;
    if (!moves(Model::kJoints[leader].kind) || *Model::kJoints[leader].mimics != '\0') return false;
  }
  return true;
}

template <class Model>
inline constexpr auto kMimics = [] {
  std::array<Mimicry, count_mimics<Model>()> result{};
  const auto link_of = [](std::size_t joint) {
    std::size_t l = 0;
    while (kTree<Model>.links[l].joint != joint) ++l;
    return l;
  };
  std::size_t next = 0;
  for (std::size_t j = 0; j < Model::kJoints.size(); ++j) {
    const RigidJoint& joint = Model::kJoints[j];
    if (*joint.mimics == '\0') continue;
    Mimicry& mimicry = result[next++];
    mimicry.follower = link_of(j);
    mimicry.leader = link_of(scene::find(Model::kJoints, joint.mimics));
    const double sign = kTree<Model>.links[mimicry.follower].sign;
    mimicry.ratio = sign * kTree<Model>.links[mimicry.leader].sign * joint.ratio;
    mimicry.offset = sign * joint.offset;
  }
  return result;
}();

/// Sets the motion of followers from that of their leaders.
template <class Model, class Motion>
[[gnu::always_inline]] inline void follow_leaders(Motion& motion) {
  using Real = typename Model::Real;
  using Lane = LaneOf<Real>;
  for (const Mimicry& mimicry : kMimics<Model>) {
    const Real ratio(static_cast<Lane>(mimicry.ratio));
    motion.q[mimicry.follower] =
        ratio * motion.q[mimicry.leader] + Real(static_cast<Lane>(mimicry.offset));
    motion.v[mimicry.follower] = ratio * motion.v[mimicry.leader];
  }
}

/// The equations of a step. Rows are Jᵀ after the elimination of the mass matrix, like those of
/// contacts: the velocity that impulses of links and base add is the product with `weighted`.
template <class Model>
struct MimicRows {
  using Real = typename Model::Real;
  using Lane = LaneOf<Real>;
  static constexpr std::size_t kCount = count_mimics<Model>();
  static constexpr std::size_t kSize = kCount == 0 ? 1 : kCount;
  static constexpr std::size_t kLinks =
      kTree<Model>.links.size() == 0 ? 1 : kTree<Model>.links.size();

  Real row[kSize][kLinks], weighted[kSize][kLinks];
  Real base[kSize][6], weighted_base[kSize][6];
  Real velocity[kSize];       // without torques; that is to become 0
  Real factor[kSize][kSize];  // L of G = L·D·Lᵀ below the diagonal, 1/D on it
  Real impulse[kSize];

  void clear() {
    const Real zero(Lane(0));
    for (std::size_t m = 0; m < kCount; ++m) {
      for (auto& element : row[m]) element = zero;
      for (auto& element : base[m]) element = zero;
      for (auto& element : weighted_base[m]) element = zero;
      row[m][kMimics<Model>[m].follower] = Real(Lane(1));
      row[m][kMimics<Model>[m].leader] = Real(static_cast<Lane>(-kMimics<Model>[m].ratio));
    }
  }

  /// After rows and velocities.
  void decompose() {
    for (std::size_t i = 0; i < kCount; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        Real sum(Lane(0));
        for (std::size_t l = 0; l < kTree<Model>.links.size(); ++l)
          sum += row[i][l] * weighted[j][l];
        for (std::size_t b = 0; b < 6; ++b) sum += base[i][b] * weighted_base[j][b];
        factor[i][j] = sum;
      }
    }
    // Row by row; element (i, j) holds L·D until D of its column has been divided out.
    for (std::size_t i = 0; i < kCount; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < j; ++k) factor[i][j] -= factor[i][k] * factor[j][k];
      }
      for (std::size_t j = 0; j < i; ++j) {
        const Real scaled = factor[i][j];
        factor[i][j] = scaled * factor[j][j];
        factor[i][i] -= scaled * factor[i][j];
      }
      factor[i][i] = Real(Lane(1)) / factor[i][i];
    }
  }

  /// Impulses that make these velocities 0.
  void solve(const Real (&velocities)[kSize]) {
    for (std::size_t i = 0; i < kCount; ++i) {
      impulse[i] = -velocities[i];
      for (std::size_t j = 0; j < i; ++j) impulse[i] -= factor[i][j] * impulse[j];
    }
    for (std::size_t i = 0; i < kCount; ++i) impulse[i] *= factor[i][i];
    for (std::size_t i = kCount; i-- > 0;) {
      for (std::size_t j = i + 1; j < kCount; ++j) impulse[i] -= factor[j][i] * impulse[j];
    }
  }
};

}  // namespace eagerx::models::multibody

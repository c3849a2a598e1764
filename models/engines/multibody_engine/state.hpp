// What a step of MultibodyEngine reads and writes: numbers alone, a lane of a pack for each
// environment.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/pack.hpp>
#include <models/engines/multibody_engine/constants.hpp>
#include <models/engines/multibody_engine/joint_torques.hpp>
#include <models/engines/multibody_engine/limb.hpp>

namespace eagerx::models::multibody {

/// An array of no elements would be a byte between words.
constexpr std::size_t at_least_one(std::size_t n) {
  return n == 0 ? 1 : n;
}

template <class Model>
struct Motion {
  using Real = typename Model::Real;
  static constexpr std::size_t kLinks = kTree<Model>.links.size();

  // Of the base: its reference point in the world [m], rotation from the reference pose,
  // velocities.
  Vec<Real> position;
  Turn<Real> rotation;
  Vec<Real> velocity, spin;
  // Of the links, in the tree's order and sign [rad, m].
  Real q[at_least_one(kLinks)];
  Real v[at_least_one(kLinks)];
};

template <class Model>
struct State : Motion<Model> {
  using Real = typename Model::Real;
  using Lane = LaneOf<Real>;
  using Motion<Model>::kLinks;
  static constexpr std::size_t kBodies = Model::kBodies.size();
  static constexpr std::size_t kPoints = kTree<Model>.points.size();
  static constexpr std::size_t kGeometries = Model::kGeometries.size();

  JointDrive<Real> drive[at_least_one(kLinks)];
  Vec<Real> force[at_least_one(kPoints)];  // of the plane on points in the last step [N]
  // Parameters of the environment.
  Vec<Real> gravity;
  Real mass_scale[kBodies];  // mass, in masses of the model
  Real friction[at_least_one(kGeometries)];
  // Forces on the centres of bodies, in the world's axes [N], and whether there is one.
  Vec<Real> outer[kBodies];
  CountOf<Real> pushed;

  [[gnu::always_inline]] bool is_pushed() const { return any(pushed != CountOf<Real>(0U)); }
  /// Selected lane by lane: what other environments do must not even change the sign of a zero.
  [[gnu::always_inline]] void push_body(std::size_t body, Moving<Real>& link) const {
    const auto here = pushed != CountOf<Real>(0U);
    const Vector3& place = kTree<Model>.place_of_body[body];
    const Vec<Real> from{Real(static_cast<Lane>(place[0])), Real(static_cast<Lane>(place[1])),
                         Real(static_cast<Lane>(place[2]))};
    const Vec<Real>& push = outer[body];
    link.force = selected(here, link.force - push, link.force);
    link.torque = selected(here, link.torque - cross(link.axes * from, push), link.torque);
  }
  template <class Truth>
  [[gnu::always_inline]] static Vec<Real> selected(const Truth& where, const Vec<Real>& a,
                                                   const Vec<Real>& b) {
    return {eagerx::select(where, a.x, b.x), eagerx::select(where, a.y, b.y),
            eagerx::select(where, a.z, b.z)};
  }
};

/// A point of the list, of limb k or of the base.
template <class Model>
struct PointTable {
  using Real = typename Model::Real;
  using Lane = LaneOf<Real>;
  static constexpr std::size_t kPoints = State<Model>::kPoints;
  static constexpr std::size_t kSize = at_least_one(kPoints);
  struct Entry {
    Lane x, y, z, radius;
    std::size_t geometry;
  };
  static constexpr auto kEntries = [] {
    std::array<Entry, kSize> entries{};
    for (std::size_t p = 0; p < kPoints; ++p) {
      const Point& point = kTree<Model>.points[p];
      entries[p] = {static_cast<Lane>(point.position[0]), static_cast<Lane>(point.position[1]),
                    static_cast<Lane>(point.position[2]), static_cast<Lane>(point.radius),
                    point.geometry};
    }
    return entries;
  }();
  [[gnu::always_inline]] static Vec<Real> place(std::size_t p) {
    return {Real(kEntries[p].x), Real(kEntries[p].y), Real(kEntries[p].z)};
  }
  [[gnu::always_inline]] static Real radius(std::size_t p) { return Real(kEntries[p].radius); }
  /// Coefficient of friction: the product of both geometries', as on OpenDynamicsEngine.
  [[gnu::always_inline]] static Real friction(const State<Model>& state, std::size_t p) {
    constexpr std::size_t kPlane = find_plane<Model>();
    if constexpr (kPlane < Model::kGeometries.size()) {
      return state.friction[kEntries[p].geometry] * state.friction[kPlane];
    } else {
      return static_cast<void>(state), static_cast<void>(p), Real(Lane(0));
    }
  }
};

}  // namespace eagerx::models::multibody

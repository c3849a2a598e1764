// Inputs and outputs of a step of MultibodyEngine: numbers alone, a lane of a SIMD vector for each
// environment.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/simd.hpp>
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
  Vec<Real> pair_force[at_least_one(count_pairs<Model>())];  // on the first of each pair [N]
  // Parameters of the environment.
  Vec<Real> gravity;
  Real mass_scale[kBodies];  // mass, in masses of the model
  Real friction[at_least_one(kGeometries)];
  Vec<Real> shift;        // of the centre of mass of the free body, in its axes [m]
  CountOf<Real> shifted;  // whether there is one
  Real roughness;         // factor of the heights of the ground
  // Forces on the centres of bodies, in the world's axes [N], and whether there is one.
  Vec<Real> outer[kBodies];
  CountOf<Real> pushed;

  [[gnu::always_inline]] bool is_pushed() const { return any(pushed != CountOf<Real>(0U)); }
  /// Selected lane by lane: other environments must not change even the sign of a zero.
  [[gnu::always_inline]] void push_body(std::size_t body, Moving<Real>& link) const {
    const auto here = pushed != CountOf<Real>(0U);
    const Vector3& place = kTree<Model>.place_of_body[body];
    const Vec<Real> from{Real(static_cast<Lane>(place[0])), Real(static_cast<Lane>(place[1])),
                         Real(static_cast<Lane>(place[2]))};
    const Vec<Real>& push = outer[body];
    link.force = selected(here, link.force - push, link.force);
    link.torque = selected(here, link.torque - cross(link.axes * from, push), link.torque);
  }
  /// The free body with its centre of mass moved by `shift`; lane by lane, too.
  [[gnu::always_inline]] void shift_base(Moving<Real>& base) const {
    if (!any(shifted != CountOf<Real>(0U))) return;
    const auto here = shifted != CountOf<Real>(0U);
    const Vec<Real> r = base.axes * shift;
    constexpr std::size_t kFree = free_body<Model>();
    const Real mass = Real(static_cast<Lane>(Model::kBodies[kFree].mass)) * mass_scale[kFree];
    // Its centre is the reference point, so that nothing but m·r² is added.
    const Vec<Real> s = r * mass;
    const Real xx = s.x * r.x, yy = s.y * r.y, zz = s.z * r.z;
    Sym<Real>& i = base.inertia;
    base.moment = selected(here, base.moment + s, base.moment);
    i.xx = eagerx::select(here, i.xx + (yy + zz), i.xx);
    i.yy = eagerx::select(here, i.yy + (xx + zz), i.yy);
    i.zz = eagerx::select(here, i.zz + (xx + yy), i.zz);
    i.xy = eagerx::select(here, i.xy - s.x * r.y, i.xy);
    i.xz = eagerx::select(here, i.xz - s.x * r.z, i.xz);
    i.yz = eagerx::select(here, i.yz - s.y * r.z, i.yz);
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
    Lane place[3], radius, bounce;
    Lane rim, axis[3], across[3], cosine, sine;
    std::size_t geometry;
  };
  static constexpr auto kEntries = [] {
    std::array<Entry, kSize> entries{};
    for (std::size_t p = 0; p < kPoints; ++p) {
      const Point& point = kTree<Model>.points[p];
      double bounce = Model::kGeometries[point.geometry].bounce;
      if (find_plane<Model>() < Model::kGeometries.size())
        bounce = eagerx::max(bounce, Model::kGeometries[find_plane<Model>()].bounce);
      Entry& entry = entries[p];
      for (std::size_t i = 0; i < 3; ++i) {
        entry.place[i] = static_cast<Lane>(point.position[i]);
        entry.axis[i] = static_cast<Lane>(point.axis[i]);
        entry.across[i] = static_cast<Lane>(point.across[i]);
      }
      entry.radius = static_cast<Lane>(point.radius);
      entry.bounce = static_cast<Lane>(bounce);
      entry.rim = static_cast<Lane>(point.rim);
      entry.cosine = static_cast<Lane>(eagerx::cos(point.phase));
      entry.sine = static_cast<Lane>(eagerx::sin(point.phase));
      entry.geometry = point.geometry;
    }
    return entries;
  }();
  static constexpr bool kHasRims = [] {
    for (const Entry& entry : kEntries) {
      if (entry.rim != Lane(0)) return true;
    }
    return false;
  }();
  [[gnu::always_inline]] static Vec<Real> vector(const Lane (&v)[3]) {
    return {Real(v[0]), Real(v[1]), Real(v[2])};
  }
  /// Where it may touch the plane, from the link's joint.
  [[gnu::always_inline]] static Vec<Real> offset(std::size_t p, const Mat<Real>& axes) {
    const Entry& entry = kEntries[p];
    Vec<Real> at = axes * vector(entry.place);
    at.z -= Real(entry.radius);
    if constexpr (kHasRims) {
      if (entry.rim != Lane(0)) at = at + on_rim(entry, axes);  // the same in all lanes
    }
    return at;
  }
  /// From the centre of a rim: the lowest point, turned by the phase. A rim that lies flat has
  /// none, so it begins with a direction of the body.
  [[gnu::always_inline]] static Vec<Real> on_rim(const Entry& entry, const Mat<Real>& axes) {
    const Real one(Lane(1)), flat(Lane(1e-4));
    const Vec<Real> axis = axes * vector(entry.axis), across = axes * vector(entry.across);
    const Real square = one - axis.z * axis.z;
    const auto lies = square < flat;
    const Real scale = one / eagerx::sqrt(eagerx::max(square, flat));
    const Vec<Real> down{axis.x * axis.z * scale, axis.y * axis.z * scale, -(square * scale)};
    const Vec<Real> first = State<Model>::selected(lies, across, down);
    return first * Real(entry.rim * entry.cosine) +
           cross(axis, first) * Real(entry.rim * entry.sine);
  }
  /// The same on ground with the normal n.
  [[gnu::always_inline]] static Vec<Real> on_rim(const Entry& entry, const Mat<Real>& axes,
                                                 const Vec<Real>& n) {
    const Real one(Lane(1)), flat(Lane(1e-4));
    const Vec<Real> axis = axes * vector(entry.axis), across = axes * vector(entry.across);
    const Real up = dot(axis, n), square = one - up * up;
    const Real scale = one / eagerx::sqrt(eagerx::max(square, flat));
    const Vec<Real> down = (axis * up - n) * scale;
    const Vec<Real> first = State<Model>::selected(square < flat, across, down);
    return first * Real(entry.rim * entry.cosine) +
           cross(axis, first) * Real(entry.rim * entry.sine);
  }
  static constexpr bool kBounces = [] {
    for (const Entry& entry : kEntries) {
      if (entry.bounce > Lane(0)) return true;
    }
    return false;
  }();
  /// Share of the normal speed that is left: the larger of both geometries'.
  [[gnu::always_inline]] static Real bounce(std::size_t p) { return Real(kEntries[p].bounce); }
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

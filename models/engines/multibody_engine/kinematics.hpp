// Pose and motion of a body, for sensors and drawings.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/bounded.hpp>
#include <eagerx/math.hpp>
#include <models/engines/multibody_engine/state.hpp>

namespace eagerx::models::multibody {

/// A body's centre of mass in the world, and its rotation from the reference pose.
template <class Real>
struct Placed {
  Vec<Real> position;
  Turn<Real> rotation;
  Vec<Real> velocity, spin;
};

/// The vector of constants `v`.
template <class Real>
[[gnu::always_inline]] inline Vec<Real> constant(const Vector3& v) {
  using Lane = LaneOf<Real>;
  return {Real(static_cast<Lane>(v[0])), Real(static_cast<Lane>(v[1])),
          Real(static_cast<Lane>(v[2]))};
}

template <class Real>
inline Vec<Real> rotated(const Turn<Real>& q, const Vec<Real>& v) {
  const Vec<Real> u{q.x, q.y, q.z};
  const Vec<Real> t = cross(u, v) * Real(LaneOf<Real>(2));
  return v + t * q.w + cross(u, t);
}
template <class Real>
inline Turn<Real> opposite(const Turn<Real>& q) {
  return {q.w, -q.x, -q.y, -q.z};
}

/// From a link to the next that hangs on it.
template <class Real>
inline void follow_joint(const Link& link, const Real& q, const Real& v, Placed<Real>& at) {
  const Real half(LaneOf<Real>(0.5));
  Vec<Real> arm = rotated(at.rotation, constant<Real>(link.position));
  const Vec<Real> axis = rotated(at.rotation, constant<Real>(link.direction));
  if (link.slides) arm = arm + axis * q;
  at.position = at.position + arm;
  at.velocity = at.velocity + cross(at.spin, arm);
  if (link.slides) {
    at.velocity = at.velocity + axis * v;
    return;
  }
  const auto turn = eagerx::sincos(q * half);
  const Vec<Real> along = constant<Real>(link.direction) * turn.sin;
  at.rotation = at.rotation * Turn<Real>{turn.cos, along.x, along.y, along.z};
  at.spin = at.spin + axis * v;
}

/// The most links from the base to a body: the limit of the loops in placed().
template <class Model>
inline constexpr std::size_t kDepth = [] {
  constexpr auto& kLinks = kTree<Model>.links;
  std::size_t most = 0;
  for (std::size_t l = 0; l < kLinks.size(); ++l) {
    std::size_t depth = 1;
    for (std::size_t at = l; kLinks[at].parent != kNone; at = kLinks[at].parent) ++depth;
    most = depth > most ? depth : most;
  }
  return most;
}();

template <class Model, class Real = typename Model::Real>
Placed<Real> placed(const Motion<Model>& motion, std::size_t body) {
  constexpr auto& kLinks = kTree<Model>.links;
  constexpr std::size_t kMost = at_least_one(kDepth<Model>);
  std::array<std::size_t, kMost> path{};
  std::uint32_t length = 0;
  std::size_t l = kTree<Model>.link_of_body[body];
  for (const std::uint32_t i : bounded<kMost>()) {
    if (l == kNone) break;
    path[i] = l;
    length = i + 1;
    l = kLinks[l].parent;
  }
  Placed<Real> at{motion.position, motion.rotation, motion.velocity, motion.spin};
  // All places: the compiler knows that `length` is at most their number, and leaves a limit out.
  for (std::size_t i = kMost; i-- > 0;) {
    if (i >= length) continue;
    l = path[i];
    follow_joint(kLinks[l], motion.q[l], motion.v[l], at);
  }
  const Vec<Real> arm = rotated(at.rotation, constant<Real>(kTree<Model>.place_of_body[body]));
  at.position = at.position + arm;
  at.velocity = at.velocity + cross(at.spin, arm);
  return at;
}

}  // namespace eagerx::models::multibody

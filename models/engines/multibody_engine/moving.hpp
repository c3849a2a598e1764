// A link during assembly of the equations: its motion, and the mass of its subtree.
#pragma once

#include <eagerx/math.hpp>
#include <models/engines/multibody_engine/constants.hpp>
#include <models/engines/multibody_engine/spatial.hpp>

namespace eagerx::models::multibody {

/// A link or the base. Vectors are in the axes of the world.
template <class Real>
struct Moving {
  Mat<Real> axes;
  Vec<Real> arm;   // of its joint from the parent's
  Vec<Real> at;    // of its joint from the base's reference point
  Vec<Real> axis;  // of its joint
  Vec<Real> velocity, spin;
  // With all accelerations of joints and base 0, upwards in free fall: the acceleration without
  // gravity.
  Vec<Real> acceleration, spin_acceleration;
  Real mass;         // of all links that hang on it, as what follows
  Vec<Real> moment;  // mass times place of the centre
  Sym<Real> inertia;
  Vec<Real> force, torque;  // that this motion takes
};

/// Mass, moment and inertia of a body more, `scale` times as heavy as its model.
template <class Part, class Real>
[[gnu::always_inline]] inline void add_body(std::size_t k, const Real& scale, Moving<Real>& to) {
  using Known1 = typename Part::template Inertia<1>;
  using Known2 = typename Part::template Inertia<2>;
  using Known3 = typename Part::template Inertia<3>;
  to.mass += value<Real, typename Part::template Inertia<0>>(k) * scale;
  to.moment = to.moment + turned_by<Known1, Known2, Known3>(k, to.axes) * scale;
  to.inertia = to.inertia + inertia_turned_by<Part::template Inertia>(k, to.axes) * scale;
}
template <class Real>
[[gnu::always_inline]] inline void forget_mass(Moving<Real>& link) {
  const Real zero(LaneOf<Real>(0));
  link.mass = zero;
  link.moment = all(zero);
  link.inertia = {zero, zero, zero, zero, zero, zero};
}
/// Newton's and Euler's equations.
template <class Real>
[[gnu::always_inline]] inline void set_forces(Moving<Real>& link) {
  const Vec<Real>&w = link.spin, &al = link.spin_acceleration, &h = link.moment;
  link.force = link.acceleration * link.mass + cross(al, h) + cross(w, cross(w, h));
  link.torque = link.inertia * al + cross(w, link.inertia * w) + cross(h, link.acceleration);
}

/// Adds the subtree of `link` to `to`, by the parallel axis theorem.
template <class Real>
[[gnu::always_inline]] inline void hand_on(const Moving<Real>& link, Moving<Real>& to) {
  const Vec<Real>& r = link.arm;
  const Vec<Real> s = link.moment + link.moment + r * link.mass;
  const Real half(LaneOf<Real>(0.5));
  const Real xx = s.x * r.x, yy = s.y * r.y, zz = s.z * r.z;
  to.inertia.xx += link.inertia.xx + (yy + zz);
  to.inertia.yy += link.inertia.yy + (xx + zz);
  to.inertia.zz += link.inertia.zz + (xx + yy);
  to.inertia.xy += link.inertia.xy - half * (s.x * r.y + s.y * r.x);
  to.inertia.xz += link.inertia.xz - half * (s.x * r.z + s.z * r.x);
  to.inertia.yz += link.inertia.yz - half * (s.y * r.z + s.z * r.y);
  to.moment = to.moment + link.moment + r * link.mass;
  to.mass += link.mass;
  to.torque = to.torque + link.torque + cross(r, link.force);
  to.force = to.force + link.force;
}

}  // namespace eagerx::models::multibody

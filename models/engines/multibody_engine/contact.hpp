// Contacts of points with the plane: compliant contacts, which are part of the step's one
// factorization, and solved contacts, whose impulses a fixed number of sweeps finds (Hwangbo, Lee,
// Hutter 2018).
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/simd.hpp>
#include <models/engines/multibody_engine/spatial.hpp>

namespace eagerx::models::multibody {

using eagerx::detail::unrolled;

template <class Lane>
struct ContactSettings {
  Lane stiffness, damping;  // of compliant contacts [N/m, N·s/m]
  Lane slip_speed;          // below which their friction is viscous [m/s]
  Lane correction;          // part of a penetration that a step undoes, of solved contacts
  Lane dt;                  // [s]
};

/// The facts of a point before the step.
template <class Real>
struct PointMotion {
  Vec<Real> at;        // from the base's reference point, at the bottom of the sphere
  Vec<Real> velocity;  // of the material there
  Vec<Real> bias;      // its acceleration with all accelerations of joints and base 0
  Real depth;          // of the penetration; negative above the plane
};

/// A point of a limb of n links during a step.
template <class Real, std::size_t n>
struct PointRecord {
  static constexpr std::size_t kLinks = n == 0 ? 1 : n;
  PointMotion<Real> motion;
  Vec<Real> jacobian[kLinks];  // motion of the point for each joint; compliant points
  Vec<Real> force;             // compliant: at the velocity now
  Vec<Real> impedance;         // compliant: less force for each m/s² more
  // Solved: a row for x, y, z. Row · M⁻¹ · rowᵀ is the product of `row` and `weighted`.
  Real row[3][kLinks], row_base[3][6];
  Real weighted[3][kLinks], weighted_base[3][6];
  Vec<Real> free;                // velocity at the end of the step without an impulse
  Real target;                   // least normal velocity at the end of the step
  Real per_normal, per_tangent;  // impulse for each m/s
  Real cross_x, cross_y;         // tangential velocity of a normal impulse
};

/// The compliant law. Normal force k·depth − (dt·k + d)·vz, never pulling; friction
/// −μ·fz'/max(|vt|, vs)·vt with the normal force fz' of the last step. Both act at the velocity of
/// the end of the step: v' = v + dt·a.
template <class Real, std::size_t n>
[[gnu::always_inline]] inline void set_compliant(const ContactSettings<LaneOf<Real>>& settings,
                                                 const Real& friction, const Real& last_normal,
                                                 PointRecord<Real, n>& point) {
  using Lane = LaneOf<Real>;
  const Real zero(Lane(0)), dt(settings.dt);
  const Real viscous(settings.dt * settings.stiffness + settings.damping);
  const Vec<Real>& v = point.motion.velocity;
  const Real normal = Real(settings.stiffness) * point.motion.depth - viscous * v.z;
  const auto touches = (point.motion.depth > zero) & (normal > zero);
  const Real speed = eagerx::max(eagerx::sqrt(v.x * v.x + v.y * v.y), Real(settings.slip_speed));
  const Real drag = eagerx::select(touches, friction * last_normal / speed, zero);
  point.force = {-(drag * v.x), -(drag * v.y), eagerx::select(touches, normal, zero)};
  point.impedance = {dt * drag, dt * drag, eagerx::select(touches, dt * viscous, zero)};
}

/// The equation of the base, A·[linear, angular acceleration] = rhs; lower triangle.
template <class Real>
struct BaseEquation {
  Real a[6][6];
  Real rhs[6];

  [[gnu::always_inline]] void add_force(const Vec<Real>& at, const Vec<Real>& force) {
    const Vec<Real> torque = cross(at, force);
    rhs[0] += force.x, rhs[1] += force.y, rhs[2] += force.z;
    rhs[3] += torque.x, rhs[4] += torque.y, rhs[5] += torque.z;
  }
  /// Jᵀ·C·J of a point, C diagonal.
  [[gnu::always_inline]] void add_impedance(const Vec<Real>& p, const Vec<Real>& c) {
    a[0][0] += c.x, a[1][1] += c.y, a[2][2] += c.z;
    const Real zy = p.z * c.y, yz = p.y * c.z, zx = p.z * c.x;
    const Real xz = p.x * c.z, yx = p.y * c.x, xy = p.x * c.y;
    a[3][1] -= zy, a[3][2] += yz;
    a[4][0] += zx, a[4][2] -= xz;
    a[5][0] -= yx, a[5][1] += xy;
    a[3][3] += p.z * zy + p.y * yz;
    a[4][4] += p.z * zx + p.x * xz;
    a[5][5] += p.y * yx + p.x * xy;
    a[4][3] -= p.x * yz;
    a[5][3] -= p.x * zy;
    a[5][4] -= p.y * zx;
  }
};

/// The motion of the base for a force along x, y, z at a point.
template <class Real>
[[gnu::always_inline]] inline void set_base_rows(const Vec<Real>& p, Real (&rows)[3][6]) {
  using Lane = LaneOf<Real>;
  const Real zero(Lane(0)), one(Lane(1));
  unrolled<3>([&](auto d) __attribute__((always_inline)) {
    unrolled<3>([&](auto i) __attribute__((always_inline)) { rows[d][i] = i == d ? one : zero; });
  });
  rows[0][3] = zero, rows[0][4] = p.z, rows[0][5] = -p.y;
  rows[1][3] = -p.z, rows[1][4] = zero, rows[1][5] = p.x;
  rows[2][3] = p.y, rows[2][4] = -p.x, rows[2][5] = zero;
}

/// The ground near a point.
template <class Real>
struct Touch {
  Mat<Real> frame;   // axes of the contact: two along the ground, then its normal
  Vec<Real> at;      // from the link's joint
  Vec<Real> center;  // of the sphere or rim, which `at` goes along with
  Real depth;        // negative above the ground
};

/// Contacts on a level plane have the axes of the world.
template <class Real>
struct WorldAxes {
  [[gnu::always_inline]] const Vec<Real>& from_world(const Vec<Real>& v) const { return v; }
  [[gnu::always_inline]] const Vec<Real>& to_world(const Vec<Real>& v) const { return v; }
  [[gnu::always_inline]] void turn_rows(Real (&/*rows*/)[3][6]) const {}
  [[gnu::always_inline]] void add_impedance(const Vec<Real>& at, const Vec<Real>& c,
                                            BaseEquation<Real>& to) const {
    to.add_impedance(at, c);
  }
};
/// Others have their own.
template <class Real>
struct ContactAxes {
  Mat<Real> frame;

  [[gnu::always_inline]] Vec<Real> from_world(const Vec<Real>& v) const {
    return in_axes_of(frame, v);
  }
  [[gnu::always_inline]] Vec<Real> to_world(const Vec<Real>& v) const { return frame * v; }
  void turn_rows(Real (&rows)[3][6]) const {
    for (std::size_t j = 0; j < 6; ++j) {
      const Vec<Real> turned = from_world({rows[0][j], rows[1][j], rows[2][j]});
      rows[0][j] = turned.x, rows[1][j] = turned.y, rows[2][j] = turned.z;
    }
  }
  void add_impedance(const Vec<Real>& at, const Vec<Real>& c, BaseEquation<Real>& to) const {
    Real rows[3][6];
    set_base_rows(at, rows);
    turn_rows(rows);
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t k = 0; k <= i; ++k)
        to.a[i][k] += c.x * rows[0][i] * rows[0][k] + c.y * rows[1][i] * rows[1][k] +
                      c.z * rows[2][i] * rows[2][k];
    }
  }
};

/// How fast a penetration is undone at most [m/s]: a reset may have put a foot far below the plane.
template <class Lane>
inline constexpr Lane kContactSpeed = Lane(1);

/// Slower points do not bounce [m/s]: those at rest fall by gravity·dt in each step.
template <class Lane>
inline constexpr Lane kBounceSpeed = Lane(0.1);

/// Computes the data for the sweeps, after `row`, `weighted` and `free`. The target is speculative:
/// a point above the plane may move up to the plane, so contacts are not switched on and off.
template <class Real, std::size_t n, bool kFloating>
[[gnu::always_inline]] inline void finish_rows(const ContactSettings<LaneOf<Real>>& settings,
                                               PointRecord<Real, n>& point) {
  using Lane = LaneOf<Real>;
  const auto product = [&](std::size_t d, std::size_t e) __attribute__((always_inline)) {
    Real sum(Lane(0));
    if constexpr (kFloating) {
      unrolled<6>([&](auto j) __attribute__((always_inline)) {
        sum += point.row_base[d][j] * point.weighted_base[e][j];
      });
    }
    unrolled<n>([&](auto j) __attribute__((always_inline)) {
      sum += point.row[d][j] * point.weighted[e][j];
    });
    return sum;
  };
  const Real zero(Lane(0)), one(Lane(1));
  const Real& depth = point.motion.depth;
  const Real part = eagerx::select(depth > zero, Real(settings.correction / settings.dt),
                                   Real(Lane(1) / settings.dt));
  point.target = eagerx::min(depth * part, Real(kContactSpeed<Lane>));
  // On a fixed base, no joint may move the point in a direction. Nothing pushes it there.
  const auto inverse = [&](const Real& x) __attribute__((always_inline)) {
    if constexpr (kFloating) {
      return one / x;
    } else {
      return eagerx::select(x > Real(Lane(1e-12)), one / x, zero);
    }
  };
  point.per_normal = inverse(product(2, 2));
  const Real xy = eagerx::abs(product(0, 1));
  point.per_tangent = inverse(eagerx::max(product(0, 0), product(1, 1)) + xy);
  point.cross_x = product(0, 2);
  point.cross_y = product(1, 2);
}

/// A point that arrives at the plane in this step leaves it with a share of its normal speed.
template <class Real, std::size_t n>
[[gnu::always_inline]] inline void let_bounce(const ContactSettings<LaneOf<Real>>& settings,
                                              const Real& bounce, PointRecord<Real, n>& point) {
  using Lane = LaneOf<Real>;
  const Real& v = point.motion.velocity.z;
  const auto arrives =
      (v < Real(-kBounceSpeed<Lane>)) & (v < point.motion.depth * Real(Lane(1) / settings.dt));
  point.target = eagerx::select(arrives, eagerx::max(point.target, -(bounce * v)), point.target);
}

/// Adds an impulse of a point to links and base.
template <class Real, std::size_t n, bool kFloating>
[[gnu::always_inline]] inline void push(const PointRecord<Real, n>& point, const Vec<Real>& impulse,
                                        Real* links, Real (&base)[6]) {
  const auto along = [&](const auto& rows, std::size_t j) __attribute__((always_inline)) {
    return rows[0][j] * impulse.x + rows[1][j] * impulse.y + rows[2][j] * impulse.z;
  };
  unrolled<n>([&](auto j) __attribute__((always_inline)) { links[j] += along(point.row, j); });
  if constexpr (kFloating) {
    unrolled<6>([&](auto j)
                    __attribute__((always_inline)) { base[j] += along(point.row_base, j); });
  }
}

/// One sweep over one point: the normal impulse that makes its velocity the target's or larger,
/// then the tangential one that stops it, scaled into the friction cone.
template <class Real, std::size_t n, bool kFloating>
[[gnu::always_inline]] inline void sweep(const PointRecord<Real, n>& point, const Real& friction,
                                         Vec<Real>& impulse, Real* links, Real (&base)[6]) {
  using Lane = LaneOf<Real>;
  const auto velocity = [&](std::size_t d, Real v) __attribute__((always_inline)) {
    unrolled<n>([&](auto j)
                    __attribute__((always_inline)) { v += point.weighted[d][j] * links[j]; });
    if constexpr (kFloating) {
      unrolled<6>([&](auto j)
                      __attribute__((always_inline)) { v += point.weighted_base[d][j] * base[j]; });
    }
    return v;
  };
  const Real zero(Lane(0)), one(Lane(1)), tiny(Lane(1e-20));
  const Real vx = velocity(0, point.free.x), vy = velocity(1, point.free.y);
  const Real vz = velocity(2, point.free.z);
  Vec<Real> next;
  next.z = eagerx::max(impulse.z - (vz - point.target) * point.per_normal, zero);
  const Real more = next.z - impulse.z;
  const Real x = impulse.x - (vx + point.cross_x * more) * point.per_tangent;
  const Real y = impulse.y - (vy + point.cross_y * more) * point.per_tangent;
  const Real most = friction * next.z;
  const Real size = eagerx::sqrt(x * x + y * y);
  const Real scale = eagerx::select(size > most, most / eagerx::max(size, tiny), one);
  next.x = x * scale;
  next.y = y * scale;
  push<Real, n, kFloating>(point, next - impulse, links, base);
  impulse = next;
}

}  // namespace eagerx::models::multibody

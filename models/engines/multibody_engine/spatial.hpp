// Vectors and matrices in space, of numbers or SIMD vectors.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>

namespace eagerx::models::multibody {

template <class Real>
struct Vec {
  Real x, y, z;
};
template <class Real>
[[gnu::always_inline]] inline Vec<Real> operator+(const Vec<Real>& a, const Vec<Real>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Real>
[[gnu::always_inline]] inline Vec<Real> operator-(const Vec<Real>& a, const Vec<Real>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Real>
[[gnu::always_inline]] inline Vec<Real> operator*(const Vec<Real>& a, const Real& s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <class Real>
[[gnu::always_inline]] inline Vec<Real> cross(const Vec<Real>& a, const Vec<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class Real>
[[gnu::always_inline]] inline Real dot(const Vec<Real>& a, const Vec<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// Element by element.
template <class Real>
[[gnu::always_inline]] inline Vec<Real> scaled(const Vec<Real>& a, const Vec<Real>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
/// The same number three times.
template <class Real>
[[gnu::always_inline]] inline Vec<Real> all(const Real& s) {
  return {s, s, s};
}

/// A rotation by its columns: the axes of a link in those of the world.
template <class Real>
struct Mat {
  Vec<Real> column[3];
};
template <class Real>
[[gnu::always_inline]] inline Vec<Real> operator*(const Mat<Real>& m, const Vec<Real>& v) {
  return m.column[0] * v.x + m.column[1] * v.y + m.column[2] * v.z;
}

/// A symmetric matrix.
template <class Real>
struct Sym {
  Real xx, yy, zz, xy, xz, yz;
};
template <class Real>
[[gnu::always_inline]] inline Vec<Real> operator*(const Sym<Real>& m, const Vec<Real>& v) {
  return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
          m.xz * v.x + m.yz * v.y + m.zz * v.z};
}
template <class Real>
[[gnu::always_inline]] inline Sym<Real> operator+(const Sym<Real>& a, const Sym<Real>& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.xz + b.xz, a.yz + b.yz};
}
template <class Real>
[[gnu::always_inline]] inline Sym<Real> operator*(const Sym<Real>& a, const Real& s) {
  return {a.xx * s, a.yy * s, a.zz * s, a.xy * s, a.xz * s, a.yz * s};
}

/// A quaternion of length 1.
template <class Real>
struct Turn {
  Real w, x, y, z;
};
/// First b, then a.
template <class Real>
[[gnu::always_inline]] inline Turn<Real> operator*(const Turn<Real>& a, const Turn<Real>& b) {
  return {
      a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
      a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
template <class Real>
[[gnu::always_inline]] inline Mat<Real> matrix(const Turn<Real>& q) {
  using Lane = LaneOf<Real>;
  const Real two(Lane(2)), one(Lane(1));
  return {{{one - two * (q.y * q.y + q.z * q.z), two * (q.x * q.y + q.w * q.z),
            two * (q.x * q.z - q.w * q.y)},
           {two * (q.x * q.y - q.w * q.z), one - two * (q.x * q.x + q.z * q.z),
            two * (q.y * q.z + q.w * q.x)},
           {two * (q.x * q.z + q.w * q.y), two * (q.y * q.z - q.w * q.x),
            one - two * (q.x * q.x + q.y * q.y)}}};
}
/// `m` in the link's axes, given in the world's.
template <class Real>
[[gnu::always_inline]] inline Vec<Real> in_axes_of(const Mat<Real>& m, const Vec<Real>& v) {
  return {dot(m.column[0], v), dot(m.column[1], v), dot(m.column[2], v)};
}

/// After `dt` with the angular velocity w, in the world's axes. The length is put right, so that
/// the error is that of the tangent, w³·dt³/12.
template <class Real>
[[gnu::always_inline]] inline Turn<Real> turned(const Turn<Real>& q, const Vec<Real>& w,
                                                LaneOf<Real> dt) {
  using Lane = LaneOf<Real>;
  const Vec<Real> h = w * Real(Lane(0.5) * dt);
  const Turn<Real> d = Turn<Real>{Real(Lane(0)), h.x, h.y, h.z} * q;
  const Turn<Real> n{q.w + d.w, q.x + d.x, q.y + d.y, q.z + d.z};
  const Real scale = Real(Lane(1)) / eagerx::sqrt(n.w * n.w + n.x * n.x + n.y * n.y + n.z * n.z);
  return {n.w * scale, n.x * scale, n.y * scale, n.z * scale};
}

}  // namespace eagerx::models::multibody

// Vectors and rotations of rigid bodies, in double as the Open Dynamics Engine has them.
#pragma once

#include <eagerx/math.hpp>
#include <eagerx/message.hpp>

namespace eagerx::models {

using Vector3 = Array<double, 3>;
using Quaternion = Array<double, 4>;  // [w, x, y, z]
using Pose = Array<double, 7>;        // position, then quaternion
using Twist = Array<double, 6>;       // velocity of the centre of mass, then angular velocity

constexpr Twist joined(const Vector3& a, const Vector3& b) {
  return {{a[0], a[1], a[2], b[0], b[1], b[2]}};
}

constexpr Vector3 operator+(const Vector3& a, const Vector3& b) {
  return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}};
}
constexpr Vector3 operator-(const Vector3& a, const Vector3& b) {
  return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
}
constexpr Vector3 operator*(double s, const Vector3& a) {
  return {{s * a[0], s * a[1], s * a[2]}};
}
constexpr double dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
constexpr Vector3 cross(const Vector3& a, const Vector3& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

inline constexpr Quaternion kNoRotation{{1.0, 0.0, 0.0, 0.0}};

/// First b, then a.
constexpr Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {{a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
           a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
           a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
           a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]}};
}
constexpr Quaternion inverse(const Quaternion& q) {
  return {{q[0], -q[1], -q[2], -q[3]}};
}
constexpr Vector3 rotate(const Quaternion& q, const Vector3& v) {
  const Vector3 u{{q[1], q[2], q[3]}};
  const Vector3 t = 2.0 * cross(u, v);
  return v + q[0] * t + cross(u, t);
}
/// A turn of `angle` [rad] about an axis of length 1.
constexpr Quaternion rotation(const Vector3& axis, double angle) {
  const double s = eagerx::sin(0.5 * angle);
  return {{eagerx::cos(0.5 * angle), s * axis[0], s * axis[1], s * axis[2]}};
}
/// Length 1; no rotation if it has no length to speak of or is not finite.
constexpr Quaternion normalised(const Quaternion& q) {
  const double square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  if (!(square > 1e-12) || !eagerx::isfinite(square)) return kNoRotation;
  const double scale = 1.0 / eagerx::sqrt(square);
  return {{scale * q[0], scale * q[1], scale * q[2], scale * q[3]}};
}
/// Angle [rad, in ±2π] of a rotation about `axis`.
constexpr double angle_about(const Quaternion& q, const Vector3& axis) {
  return 2.0 * eagerx::atan2(q[1] * axis[0] + q[2] * axis[1] + q[3] * axis[2], q[0]);
}

}  // namespace eagerx::models

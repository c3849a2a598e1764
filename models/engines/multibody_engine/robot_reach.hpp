// Position and Jacobian of a point of a robot, and inverse kinematics.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/math.hpp>
#include <models/engines/multibody_engine/kinematics.hpp>
#include <models/engines/multibody_engine/robot_joints.hpp>

namespace eagerx::models::multibody {

/// Links from the base to a body.
template <class Model>
struct LinkPath {
  std::array<std::size_t, kTree<Model>.links.size() + 1> link{};
  std::size_t length = 0;

  static constexpr LinkPath to(std::size_t body) {
    LinkPath path;
    for (std::size_t l = kTree<Model>.link_of_body[body]; l != kNone;
         l = kTree<Model>.links[l].parent)
      path.link[path.length++] = l;
    for (std::size_t i = 0; i < path.length / 2; ++i) {
      const std::size_t other = path.length - 1 - i, kept = path.link[i];
      path.link[i] = path.link[other];
      path.link[other] = kept;
    }
    return path;
  }
};

/// Where the base's reference point is: in the world if the base is fixed to it; a free body is at
/// its own origin.
template <class Model>
constexpr Vector3 base_of_robot() {
  if constexpr (count_free<Model>() == 0) {
    if constexpr (requires { Model::kOrigin; }) return Model::kOrigin;
  }
  return {};
}

/// A point of a body, `place` from its center of mass in its axes, while the joints are at q. The
/// axes are the world's, or those of the free body.
template <class Model, class Joints, class Real, std::size_t kBody>
class Reach {
 public:
  static constexpr auto kPath = LinkPath<Model>::to(kBody);
  static constexpr std::size_t kJoints = Joints::kCount;
  /// Linear, then angular velocity for each joint [6][joints].
  using Jacobian = std::array<std::array<Real, kJoints>, 6>;

  Reach(const LinkNumbers<Model, Real>& q, const Vec<Real>& place) {
    const Real half(Lane(0.5)), zero(Lane(0)), one(Lane(1));
    position = constant<Real>(base_of_robot<Model>());
    rotation = {one, zero, zero, zero};
    for (std::size_t i = 0; i < kPath.length; ++i) {
      const Link& link = kTree<Model>.links[kPath.link[i]];
      const Real& angle = q.of[kPath.link[i]];
      axis_[i] = rotated(rotation, constant<Real>(link.direction));
      position = position + rotated(rotation, constant<Real>(link.position));
      if (link.slides) position = position + axis_[i] * angle;
      joint_[i] = position;
      if (link.slides) continue;
      const auto turn = eagerx::sincos(angle * half);
      const Vec<Real> along = constant<Real>(link.direction) * turn.sin;
      rotation = rotation * Turn<Real>{turn.cos, along.x, along.y, along.z};
    }
    const Vec<Real> from = constant<Real>(kTree<Model>.place_of_body[kBody]) + place;
    position = position + rotated(rotation, from);
  }

  [[nodiscard]] Jacobian jacobian() const {
    Jacobian result;
    for (auto& row : result) row.fill(Real(Lane(0)));
    for (std::size_t i = 0; i < kPath.length; ++i) {
      const std::size_t l = kPath.link[i];
      const Following& following = Joints::kFollowing[l];
      if (following.owner == kNone) continue;
      const bool slides = kTree<Model>.links[l].slides;
      const Vec<Real> linear = slides ? axis_[i] : cross(axis_[i], position - joint_[i]);
      const Real factor(static_cast<Lane>(following.factor));
      add(result, 0, following.owner, linear * factor);
      if (!slides) add(result, 3, following.owner, axis_[i] * factor);
    }
    return result;
  }

  /// Linear and angular acceleration of the point with all accelerations of joints 0.
  [[nodiscard]] std::array<Vec<Real>, 2> bias(const LinkNumbers<Model, Real>& v) const {
    const Real two(Lane(2));
    Vec<Real> spin = all(Real(Lane(0))), turning = spin, a = spin, from = spin;
    for (std::size_t i = 0; i <= kPath.length; ++i) {
      const Vec<Real> at = i == kPath.length ? position : joint_[i];
      const Vec<Real> arm = at - (i == 0 ? at : from);
      a = a + cross(turning, arm) + cross(spin, cross(spin, arm));
      from = at;
      if (i == kPath.length) break;
      const std::size_t l = kPath.link[i];
      const Vec<Real> along = axis_[i] * v.of[l];
      if (kTree<Model>.links[l].slides) {
        a = a + cross(spin, along) * two;
      } else {
        turning = turning + cross(spin, along);
        spin = spin + along;
      }
    }
    return {a, turning};
  }

  Vec<Real> position;   // [m]
  Turn<Real> rotation;  // of the body from the reference pose

 private:
  using Lane = LaneOf<Real>;
  static void add(Jacobian& to, std::size_t row, std::size_t column, const Vec<Real>& v) {
    to[row][column] += v.x, to[row + 1][column] += v.y, to[row + 2][column] += v.z;
  }

  static constexpr std::size_t kSize = kPath.length == 0 ? 1 : kPath.length;
  Vec<Real> axis_[kSize], joint_[kSize];
};

/// The rotation from b to a as a vector [rad], the shorter way round; of quaternions of any length
/// but 0.
template <class Real>
inline Vec<Real> rotation_between(const Turn<Real>& a, const Turn<Real>& b) {
  using Lane = LaneOf<Real>;
  const Turn<Real> d = a * opposite(b);
  const Real one(Lane(1)), tiny(Lane(1e-12));
  const Real side = eagerx::select(d.w < Real(Lane(0)), -one, one);
  const Vec<Real> v = Vec<Real>{d.x, d.y, d.z} * side;
  const Real sine = eagerx::sqrt(dot(v, v));
  const Real angle = Real(Lane(2)) * eagerx::atan2(sine, d.w * side);
  return v * (angle / eagerx::max(sine, tiny));
}

}  // namespace eagerx::models::multibody

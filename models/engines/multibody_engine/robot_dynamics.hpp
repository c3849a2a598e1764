// Inverse dynamics of a robot's joints: recursive Newton-Euler, and the mass matrix by composite
// rigid bodies (Featherstone, Rigid Body Dynamics Algorithms, 2008, sections 5.3 and 6.2), with the
// base at rest. In loops over the links, so that the code is short on boards.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/math.hpp>
#include <models/engines/multibody_engine/constants.hpp>
#include <models/engines/multibody_engine/kinematics.hpp>
#include <models/engines/multibody_engine/moving.hpp>
#include <models/engines/multibody_engine/robot_joints.hpp>

namespace eagerx::models::multibody {

/// Constants of a link for loops.
template <class Lane>
struct LinkConstants {
  Lane position[3], direction[3];
  Lane mass, moment[3], inertia[6];  // about the joint: xx, yy, zz, xy, xz, yz
  Lane armature, damping;
};
template <class Model, class Lane>
inline constexpr auto kLinkConstants = [] {
  std::array<LinkConstants<Lane>, kTree<Model>.links.size()> result{};
  for (std::size_t l = 0; l < result.size(); ++l) {
    const Link& link = kTree<Model>.links[l];
    LinkConstants<Lane>& to = result[l];
    InertiaAbout sum{};
    for (std::size_t b = 0; b < Model::kBodies.size(); ++b) {
      if (kTree<Model>.link_of_body[b] != l) continue;
      const InertiaAbout one = inertia_about(Model::kBodies[b], kTree<Model>.place_of_body[b]);
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += one[i];
    }
    to.mass = static_cast<Lane>(sum[0]);
    for (std::size_t i = 0; i < 3; ++i) {
      to.position[i] = static_cast<Lane>(link.position[i]);
      to.direction[i] = static_cast<Lane>(link.direction[i]);
      to.moment[i] = static_cast<Lane>(sum[1 + i]);
    }
    for (std::size_t i = 0; i < 6; ++i) to.inertia[i] = static_cast<Lane>(sum[4 + i]);
    to.armature = static_cast<Lane>(Model::kJoints[link.joint].armature);
    to.damping = static_cast<Lane>(Model::kJoints[link.joint].damping);
  }
  return result;
}();

/// A robot while its joints are at q. Accelerations of the base are those of `gravity`.
template <class Model, class Joints, class RealType>
class RobotDynamics {
 public:
  using Real = RealType;
  using Numbers = LinkNumbers<Model, Real>;
  static constexpr std::size_t kLinks = Joints::kLinks;
  static constexpr std::size_t kJoints = Joints::kCount;
  using Torques = std::array<Real, kJoints>;
  using Matrix = std::array<std::array<Real, kJoints>, kJoints>;

  explicit RobotDynamics(const Numbers& q) {
    const Real zero(Lane(0)), one(Lane(1));
    base_.axes = {{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}};
    base_.velocity = base_.spin = base_.spin_acceleration = all(zero);
    for (std::size_t l = 0; l < kLinks; ++l) place(l, q.of[l]);
  }

  /// Torques of the joints that make the links move like this, with those that armature and damping
  /// take.
  [[nodiscard]] Torques torques(const Numbers& v, const Numbers& a, const Vec<Real>& gravity) {
    base_.acceleration = gravity * Real(Lane(-1));
    for (std::size_t l = 0; l < kLinks; ++l) move(l, v.of[l], a.of[l]);
    Numbers result;
    for (std::size_t l = kLinks; l-- > 0;) {
      const Moving<Real>& link = link_[l];
      const Constants& known = kLinkConstants<Model, Lane>[l];
      result.of[l] = (kTree<Model>.links[l].slides ? dot(link.axis, link.force)
                                                   : dot(link.axis, link.torque)) +
                     Real(known.armature) * a.of[l] + Real(known.damping) * v.of[l];
      if (kTree<Model>.links[l].parent == kNone) continue;
      Moving<Real>& up = link_[kTree<Model>.links[l].parent];
      up.torque = up.torque + link.torque + cross(link.arm, link.force);
      up.force = up.force + link.force;
    }
    return of_joints<Model, Joints>(result);
  }

  /// With the armatures; the lower triangle.
  [[nodiscard]] Matrix masses() const {
    Matrix result;
    for (auto& row : result) row.fill(Real(Lane(0)));
    RobotDynamics whole = *this;  // of which links become what hangs on them
    for (auto& link : whole.link_) link.force = link.torque = all(Real(Lane(0)));
    for (std::size_t l = kLinks; l-- > 0;) {
      whole.add_masses(l, result);
      const std::size_t parent = kTree<Model>.links[l].parent;
      if (parent != kNone) hand_on(whole.link_[l], whole.link_[parent]);
    }
    return result;
  }

 private:
  using Lane = LaneOf<Real>;
  using Constants = LinkConstants<Lane>;

  [[nodiscard]] const Moving<Real>& above(std::size_t l) const {
    const std::size_t parent = kTree<Model>.links[l].parent;
    return parent == kNone ? base_ : link_[parent];
  }
  static Vec<Real> vector(const Lane (&v)[3]) { return {Real(v[0]), Real(v[1]), Real(v[2])}; }

  void place(std::size_t l, const Real& q) {
    const Constants& known = kLinkConstants<Model, Lane>[l];
    const Mat<Real>& from = above(l).axes;
    Moving<Real>& link = link_[l];
    link.arm = from * vector(known.position);
    link.axis = from * vector(known.direction);
    link.axes = from;
    if (kTree<Model>.links[l].slides) {
      link.arm = link.arm + link.axis * q;
    } else {
      turn(link, kTree<Model>.links[l].axis, known, q);
    }
    link.mass = Real(known.mass);
    link.moment = link.axes * vector(known.moment);
    set_inertia(known, link);
  }
  static void turn(Moving<Real>& link, std::size_t axis, const Constants& known, const Real& q) {
    const auto turn = eagerx::sincos(q);
    Vec<Real>* const column = link.axes.column;
    if (axis == kTurned) {  // Rodrigues' formula
      const Real rest = Real(Lane(1)) - turn.cos;
      for (std::size_t i = 0; i < 3; ++i)
        column[i] = column[i] * turn.cos + cross(link.axis, column[i]) * turn.sin +
                    link.axis * (rest * Real(known.direction[i]));
    } else {
      const std::size_t b = (axis + 1) % 3, c = (axis + 2) % 3;
      const Vec<Real> second = column[b];
      column[b] = second * turn.cos + column[c] * turn.sin;
      column[c] = column[c] * turn.cos - second * turn.sin;
    }
  }
  /// m·I·mᵀ
  static void set_inertia(const Constants& known, Moving<Real>& link) {
    const Lane(&i)[6] = known.inertia;
    const Mat<Real>& m = link.axes;
    const Vec<Real> x = m * Vec<Real>{Real(i[0]), Real(i[3]), Real(i[4])};
    const Vec<Real> y = m * Vec<Real>{Real(i[3]), Real(i[1]), Real(i[5])};
    const Vec<Real> z = m * Vec<Real>{Real(i[4]), Real(i[5]), Real(i[2])};
    const Vec<Real>&a = m.column[0], &b = m.column[1], &c = m.column[2];
    link.inertia = {x.x * a.x + y.x * b.x + z.x * c.x, x.y * a.y + y.y * b.y + z.y * c.y,
                    x.z * a.z + y.z * b.z + z.z * c.z, x.y * a.x + y.y * b.x + z.y * c.x,
                    x.z * a.x + y.z * b.x + z.z * c.x, x.z * a.y + y.z * b.y + z.z * c.y};
  }

  void move(std::size_t l, const Real& v, const Real& a) {
    const Moving<Real>& up = above(l);
    Moving<Real>& link = link_[l];
    const Vec<Real>&w = up.spin, &r = link.arm, along = link.axis * v;
    link.acceleration = up.acceleration + cross(up.spin_acceleration, r) + cross(w, cross(w, r));
    link.spin = w;
    link.spin_acceleration = up.spin_acceleration;
    if (kTree<Model>.links[l].slides) {
      link.acceleration = link.acceleration + cross(w, along) * Real(Lane(2)) + link.axis * a;
    } else {
      link.spin = link.spin + along;
      link.spin_acceleration = link.spin_acceleration + cross(w, along) + link.axis * a;
    }
    set_forces(link);
  }

  /// Momentum of the subtree of joint l at unit speed, along each joint that carries it.
  void add_masses(std::size_t l, Matrix& to) const {
    const Moving<Real>& link = link_[l];
    const bool slides = kTree<Model>.links[l].slides;
    const Vec<Real> linear = slides ? link.axis * link.mass : cross(link.axis, link.moment);
    Vec<Real> angular = slides ? cross(link.moment, link.axis) : link.inertia * link.axis;
    for (std::size_t up = l; up != kNone; up = kTree<Model>.links[up].parent) {
      Real mass = kTree<Model>.links[up].slides ? dot(link_[up].axis, linear)
                                                : dot(link_[up].axis, angular);
      if (up == l) mass += Real(kLinkConstants<Model, Lane>[l].armature);
      add_mass(Joints::kFollowing[l], Joints::kFollowing[up], up == l, mass, to);
      angular = angular + cross(link_[up].arm, linear);
    }
  }
  static void add_mass(const Following& one, const Following& other, bool same, const Real& mass,
                       Matrix& to) {
    if (one.owner == kNone || other.owner == kNone) return;
    const Real product = mass * Real(static_cast<Lane>(one.factor * other.factor));
    const std::size_t row = one.owner > other.owner ? one.owner : other.owner;
    const std::size_t column = one.owner > other.owner ? other.owner : one.owner;
    // Elements off the diagonal of links are twice in the matrix.
    to[row][column] += !same && row == column ? product + product : product;
  }

  Moving<Real> base_;
  Moving<Real> link_[kLinks == 0 ? 1 : kLinks];
};

}  // namespace eagerx::models::multibody

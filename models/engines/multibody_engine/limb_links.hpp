// The links of a limb: their poses, their motion, and the motion of points on them.
//
// Newton-Euler's recursion (Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 5), in the
// world's axes. Everything of a link is about its own joint, so that numbers stay small where float
// is used.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <models/engines/multibody_engine/constants.hpp>
#include <models/engines/multibody_engine/contact.hpp>
#include <models/engines/multibody_engine/moving.hpp>
#include <models/engines/multibody_engine/spatial.hpp>
#include <type_traits>

namespace eagerx::models::multibody {

/// The links of limb k of group g.
template <class Model, std::size_t g>
class LimbLinks {
 public:
  using Real = typename Model::Real;
  using Lane = LaneOf<Real>;
  using Group = GroupOf<Model, g>;
  static constexpr std::size_t n = Group::kSize;

  /// Where links are and how they move, from the base to the tips.
  template <class State>
  [[gnu::always_inline]] void move(std::size_t k, const Moving<Real>& base, const State& state) {
    unrolled<n>([&](auto j) __attribute__((always_inline)) { move_link<j>(k, base, state); });
  }

  /// f(link, first point, end): for each link with points.
  template <class F>
  [[gnu::always_inline]] static void each_link_with_points(const F& f) {
    unrolled<n>([&](auto j) __attribute__((always_inline)) {
      constexpr std::size_t first = Group::points_before(j);
      constexpr std::size_t end = Group::points_before(j + 1);
      if constexpr (first < end) f(j, first, end);
    });
  }

  /// How a point of link j moves that is at offset(axes of the link).
  template <std::size_t j, class Offset>
  [[gnu::always_inline]] PointMotion<Real> point_motion(const Offset& offset, const Real& height,
                                                        const Vec<Real>& gravity) const {
    const Moving<Real>& link = link_[j];
    const Vec<Real> d = offset(link.axes);
    PointMotion<Real> motion;
    motion.at = link.at + d;
    motion.depth = -(height + motion.at.z);
    motion.velocity = link.velocity + cross(link.spin, d);
    motion.bias = bias<j>(d, gravity);
    return motion;
  }
  /// The same of a point that touches as `touch` says; velocity and bias in the frame's axes. The
  /// point stays at the ground while its sphere or rim turns, so the bias is that of the center.
  template <std::size_t j>
  [[gnu::always_inline]] PointMotion<Real> point_motion(const Touch<Real>& touch,
                                                        const Vec<Real>& gravity) const {
    const Moving<Real>& link = link_[j];
    return {
        .at = link.at + touch.at,
        .velocity = in_axes_of(touch.frame, link.velocity + cross(link.spin, touch.at)),
        .bias = in_axes_of(touch.frame, bias<j>(touch.center, gravity)),
        .depth = touch.depth,
    };
  }
  template <std::size_t j>
  [[nodiscard]] const Moving<Real>& link() const {
    return link_[j];
  }
  template <std::size_t j>
  [[gnu::always_inline]] Vec<Real> bias(const Vec<Real>& d, const Vec<Real>& gravity) const {
    const Moving<Real>& link = link_[j];
    return link.acceleration + gravity + cross(link.spin_acceleration, d) +
           cross(link.spin, cross(link.spin, d));
  }
  /// The velocity of a point of link j for each rad/s of link i, which carries it.
  template <std::size_t i>
  [[gnu::always_inline]] Vec<Real> jacobian(const Vec<Real>& at) const {
    if constexpr (Group::link(0, i).slides) return link_[i].axis;
    return cross(link_[i].axis, at - link_[i].at);
  }

 protected:
  template <std::size_t j>
  static constexpr bool kSlides = Group::link(0, j).slides;
  template <std::size_t j>
  static constexpr std::size_t kAxis = Group::link(0, j).axis;

  Moving<Real> link_[n];

 private:
  template <std::size_t j, class State>
  [[gnu::always_inline]] void move_link(std::size_t k, const Moving<Real>& base,
                                        const State& state) {
    constexpr std::size_t kUp = Group::parent(j);
    const Moving<Real>& up = *(kUp == kNone ? &base : &link_[kUp == kNone ? 0 : kUp]);
    const std::size_t index = Group::index(k, j);
    const Real &q = state.q[index], &v = state.v[index];
    Moving<Real>& link = link_[j];
    link.arm =
        turned_by<typename Group::template Position<j, 0>, typename Group::template Position<j, 1>,
                  typename Group::template Position<j, 2>>(k, up.axes);
    set_axes<j>(k, up, q, link);
    const Vec<Real> along = link.axis * v;
    if constexpr (kSlides<j>) link.arm = link.arm + link.axis * q;
    const Vec<Real>&w = up.spin, &r = link.arm;
    link.at = kUp == kNone ? r : up.at + r;
    link.velocity = up.velocity + cross(w, r);
    link.acceleration = up.acceleration + cross(w, cross(w, r));
    if constexpr (kUp != kNone)
      link.acceleration = link.acceleration + cross(up.spin_acceleration, r);
    if constexpr (kSlides<j>) {
      link.velocity = link.velocity + along;
      link.acceleration = link.acceleration + cross(w, along) * Real(Lane(2));
      link.spin = w;
      link.spin_acceleration = up.spin_acceleration;
    } else {
      link.spin = w + along;
      link.spin_acceleration =
          kUp == kNone ? cross(w, along) : up.spin_acceleration + cross(w, along);
    }
    forget_mass(link);
    unrolled<bodies_on<Model>(Group::index(0, j))>([&](auto part) __attribute__((always_inline)) {
      using Part = typename Group::template Part<j, part>;
      add_body<Part>(k, state.mass_scale[Part::body(k)], link);
    });
    set_forces(link);
    add_outer_forces<j>(k, state, link);
  }

  /// Forces on bodies from outside, which nearly never are.
  template <std::size_t j, class State>
  [[gnu::always_inline]] void add_outer_forces(std::size_t k, const State& state,
                                               Moving<Real>& link) {
    if (!state.is_pushed()) return;
    unrolled<bodies_on<Model>(Group::index(0, j))>([&](auto part) __attribute__((always_inline)) {
      state.push_body(Group::template Part<j, part>::body(k), link);
    });
  }

  template <std::size_t j>
  [[gnu::always_inline]] static void set_axes(std::size_t k, const Moving<Real>& up, const Real& q,
                                              Moving<Real>& link) {
    using X = typename Group::template Direction<j, 0>;
    using Y = typename Group::template Direction<j, 1>;
    using Z = typename Group::template Direction<j, 2>;
    constexpr std::size_t kAxis = LimbLinks::kAxis<j>;
    const Mat<Real>& from = up.axes;
    if constexpr (kAxis == kTurned) {
      link.axis = turned_by<X, Y, Z>(k, from);
    } else {
      link.axis = from.column[kAxis];
    }
    if constexpr (kSlides<j>) {
      link.axes = from;
    } else if constexpr (kAxis == kTurned) {  // Rodrigues' formula
      const auto turn = eagerx::sincos(q);
      const Real rest = Real(Lane(1)) - turn.cos;
      const Real along[3] = {value<Real, X>(k), value<Real, Y>(k), value<Real, Z>(k)};
      unrolled<3>([&](auto i) __attribute__((always_inline)) {
        link.axes.column[i] = from.column[i] * turn.cos +
                              cross(link.axis, from.column[i]) * turn.sin +
                              link.axis * (rest * along[i]);
      });
    } else {
      const auto turn = eagerx::sincos(q);
      constexpr std::size_t b = (kAxis + 1) % 3, c = (kAxis + 2) % 3;
      link.axes.column[kAxis] = from.column[kAxis];
      link.axes.column[b] = from.column[b] * turn.cos + from.column[c] * turn.sin;
      link.axes.column[c] = from.column[c] * turn.cos - from.column[b] * turn.sin;
    }
  }
};

}  // namespace eagerx::models::multibody

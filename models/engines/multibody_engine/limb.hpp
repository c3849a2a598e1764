// The equations of a limb, and the base's equations without it.
//
// Composite rigid bodies (Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 6), in the
// world's axes. The mass matrix is factored as LᵀDL from the tips on, which keeps the zeros of a
// tree (section 6.5); a limb is eliminated into the base's six equations.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <limits>
#include <models/engines/multibody_engine/constants.hpp>
#include <models/engines/multibody_engine/contact.hpp>
#include <models/engines/multibody_engine/joint_torques.hpp>
#include <models/engines/multibody_engine/limb_links.hpp>
#include <models/engines/multibody_engine/moving.hpp>
#include <models/engines/multibody_engine/spatial.hpp>
#include <type_traits>

namespace eagerx::models::multibody {

/// The results for a limb that are kept until the base is known.
template <class Real, std::size_t n, std::size_t P>
struct LimbRecord {
  Real inverse[n];     // of D
  Real lower[n][n];    // L within the limb
  Real to_base[n][6];  // L towards the base
  Real rhs[n];
  JointTorque<Real> drive[n];  // of actuators, for sensors
  Real pushed[n];              // impulses of contacts
  PointRecord<Real, n> points[P == 0 ? 1 : P];
};

/// f(j) for n links, from the tips on.
template <std::size_t n, class F>
[[gnu::always_inline]] inline void each_back(const F& f) {
  unrolled<n>([&](auto back) __attribute__((always_inline)) {
    f(std::integral_constant<std::size_t, n - 1 - back>{});
  });
}

/// f(i) for link j of a limb and all that carry it, from the base on; each_above() without j.
template <class Group, std::size_t j, class F>
[[gnu::always_inline]] inline void each_carrier(const F& f) {
  unrolled<j + 1>([&](auto i) __attribute__((always_inline)) {
    if constexpr (Group::carries(i, j)) f(i);
  });
}
template <class Group, std::size_t j, class F>
[[gnu::always_inline]] inline void each_above(const F& f) {
  unrolled<j>([&](auto i) __attribute__((always_inline)) {
    if constexpr (Group::carries(i, j)) f(i);
  });
}

/// Limb k of group g while its equations are made.
template <class Model, std::size_t g, bool kFloating>
class Limb : public LimbLinks<Model, g> {
  using Links = LimbLinks<Model, g>;

 public:
  using Links::n;
  using typename Links::Group;
  using typename Links::Lane;
  using typename Links::Real;
  using Record = LimbRecord<Real, n, Group::kPoints>;

  /// Mass matrix and right-hand side, from the tips to the base.
  template <class State>
  [[gnu::always_inline]] void gather(std::size_t k, const State& state, const Real* held, Lane dt,
                                     Moving<Real>& base, Record& record) {
    unrolled<n>([&](auto back) __attribute__((always_inline)) {
      constexpr std::size_t j = n - 1 - back;
      set_masses<j>();
      add_torques<j>(k, state, held, dt, record);
      if constexpr (constexpr std::size_t up = Group::parent(j); up != kNone) {
        hand_on(this->link_[j], this->link_[up]);
      } else if constexpr (kFloating) {
        hand_on(this->link_[j], base);
      }
    });
  }

  /// A compliant point of link j, whose force and impedance are known. `axes` are those of the
  /// contact.
  template <std::size_t j, class Axes>
  [[gnu::always_inline]] void add_compliant(PointRecord<Real, n>& point, const Axes& axes,
                                            BaseEquation<Real>& base, Record& record) {
    const Vec<Real>& c = point.impedance;
    const Vec<Real> force = point.force - scaled(c, point.motion.bias);
    each_carrier<Group, j>([&](auto i) __attribute__((always_inline)) {
      point.jacobian[i] = axes.from_world(this->template jacobian<i>(point.motion.at));
    });
    each_carrier<Group, j>([&](auto i) __attribute__((always_inline)) {
      const Vec<Real> push = scaled(c, point.jacobian[i]);
      each_carrier<Group, i>([&](auto up) __attribute__((always_inline)) {
        mass_[i][up] += dot(push, point.jacobian[up]);
      });
      if constexpr (kFloating) {
        const Vec<Real> pushed = axes.to_world(push);
        const Vec<Real> turn = cross(point.motion.at, pushed);
        coupling_[i][0] += pushed.x, coupling_[i][1] += pushed.y, coupling_[i][2] += pushed.z;
        coupling_[i][3] += turn.x, coupling_[i][4] += turn.y, coupling_[i][5] += turn.z;
      }
      record.rhs[i] += dot(force, point.jacobian[i]);
    });
    if constexpr (kFloating) {
      axes.add_impedance(point.motion.at, c, base);
      base.add_force(point.motion.at, axes.to_world(force));
    }
  }

  /// L and D of the limb; the base's equation without the limb.
  [[gnu::always_inline]] void eliminate(BaseEquation<Real>& base, Record& record) {
    unrolled<n>([&](auto back) __attribute__((always_inline)) {
      constexpr std::size_t j = n - 1 - back;
      const Real inverse = Real(Lane(1)) / mass_[j][j];
      record.inverse[j] = inverse;
      if constexpr (kFloating) {
        unrolled<6>([&](auto b) __attribute__((always_inline)) {
          record.to_base[j][b] = coupling_[j][b] * inverse;
        });
      }
      each_above<Group, j>([&](auto i) __attribute__((always_inline)) {
        const Real l = mass_[j][i] * inverse;
        record.lower[j][i] = l;
        each_carrier<Group, i>([&](auto up) __attribute__((always_inline)) {
          mass_[i][up] -= l * mass_[j][up];
        });
        if constexpr (kFloating) {
          unrolled<6>([&](auto b) __attribute__((always_inline)) {
            coupling_[i][b] -= l * coupling_[j][b];
          });
        }
        record.rhs[i] -= l * record.rhs[j];
      });
    });
    if constexpr (kFloating) {  // once for each element, which is in memory
      unrolled<6>([&](auto b) __attribute__((always_inline)) {
        unrolled<b + 1>([&](auto c) __attribute__((always_inline)) {
          Real sum = base.a[b][c];
          each_back<n>([&](auto j) __attribute__((always_inline)) {
            sum -= record.to_base[j][b] * coupling_[j][c];
          });
          base.a[b][c] = sum;
        });
        Real sum = base.rhs[b];
        each_back<n>([&](auto j) __attribute__((always_inline)) {
          sum -= record.to_base[j][b] * record.rhs[j];
        });
        base.rhs[b] = sum;
      });
    }
  }

  /// The rows of a solved point of link j, without the base's factors: L⁻ᵀJᵀ.
  template <std::size_t j, class Axes>
  [[gnu::always_inline]] void set_rows(PointRecord<Real, n>& point, const Axes& axes, Lane dt,
                                       const Record& record) const {
    const Real zero(Lane(0)), step(dt);
    unrolled<3>([&](auto d) __attribute__((always_inline)) {
      unrolled<n>([&](auto i) __attribute__((always_inline)) { point.row[d][i] = zero; });
    });
    each_carrier<Group, j>([&](auto i) __attribute__((always_inline)) {
      const Vec<Real> along = axes.from_world(this->template jacobian<i>(point.motion.at));
      point.row[0][i] = along.x, point.row[1][i] = along.y, point.row[2][i] = along.z;
    });
    set_base_rows(point.motion.at, point.row_base);
    axes.turn_rows(point.row_base);
    point.free = point.motion.velocity + point.motion.bias * step;
    Real* const free[3] = {&point.free.x, &point.free.y, &point.free.z};
    unrolled<3>([&](auto d) __attribute__((always_inline)) {
      Real(&row)[n] = point.row[d];
      unrolled<n>([&](auto i) __attribute__((always_inline)) { point.weighted[d][i] = zero; });
      unrolled<n>([&](auto back) __attribute__((always_inline)) {
        constexpr std::size_t i = n - 1 - back;
        if constexpr (Group::carries(i, j)) {
          each_above<Group, i>([&](auto up) __attribute__((always_inline)) {
            row[up] -= record.lower[i][up] * row[i];
          });
          if constexpr (kFloating) {
            unrolled<6>([&](auto b) __attribute__((always_inline)) {
              point.row_base[d][b] -= record.to_base[i][b] * row[i];
            });
          }
          point.weighted[d][i] = row[i] * record.inverse[i];
          *free[d] += step * (point.weighted[d][i] * record.rhs[i]);
        }
      });
    });
  }

  /// L⁻ᵀ·row of any row over the limb's links, without the base's factors.
  [[gnu::always_inline]] static void reduce(const Record& record, Real* row, Real (&row_base)[6]) {
    unrolled<n>([&](auto back) __attribute__((always_inline)) {
      constexpr std::size_t i = n - 1 - back;
      each_above<Group, i>([&](auto up) __attribute__((always_inline)) {
        row[up] -= record.lower[i][up] * row[i];
      });
      if constexpr (kFloating) {
        unrolled<6>([&](auto b) __attribute__((always_inline)) {
          row_base[b] -= record.to_base[i][b] * row[i];
        });
      }
    });
  }

 private:
  template <std::size_t j>
  static constexpr bool kSlides = Links::template kSlides<j>;

  /// Row j of the mass matrix: momentum of the subtree of joint j at unit speed, along each joint
  /// that carries it and along the base.
  template <std::size_t j>
  [[gnu::always_inline]] void set_masses() {
    const Moving<Real>& link = this->link_[j];
    Vec<Real> linear, angular;
    if constexpr (kSlides<j>) {
      linear = link.axis * link.mass;
      angular = cross(link.moment, link.axis);
      mass_[j][j] = dot(link.axis, linear);
    } else {
      linear = cross(link.axis, link.moment);
      angular = link.inertia * link.axis;
      mass_[j][j] = dot(link.axis, angular);
    }
    angular = angular + cross(link.arm, linear);
    unrolled<j>([&](auto back) __attribute__((always_inline)) {
      constexpr std::size_t i = j - 1 - back;
      if constexpr (Group::carries(i, j)) {
        mass_[j][i] =
            kSlides<i> ? dot(this->link_[i].axis, linear) : dot(this->link_[i].axis, angular);
        if constexpr (kFloating || Group::parent(i) != kNone)
          angular = angular + cross(this->link_[i].arm, linear);
      }
    });
    if constexpr (kFloating) {
      coupling_[j][0] = linear.x, coupling_[j][1] = linear.y, coupling_[j][2] = linear.z;
      coupling_[j][3] = angular.x, coupling_[j][4] = angular.y, coupling_[j][5] = angular.z;
    }
  }

  /// Torques on joint j, and the inertial torques of the motion.
  template <std::size_t j, class State>
  [[gnu::always_inline]] void add_torques(std::size_t k, const State& state, const Real* held,
                                          Lane dt, Record& record) {
    const std::size_t index = Group::index(k, j);
    const Real &q = state.q[index], &v = state.v[index];
    const JointDrive<Real>& drive = state.drive[index];
    const Moving<Real>& link = this->link_[j];
    const Real inertia = mass_[j][j] + value<Real, typename Group::template Armature<j>>(k);
    const Real zero(Lane(0));
    const JointTorque<Real> servo = servo_torque(drive, q, v, dt);
    const auto has_servo = drive.most > zero;
    record.drive[j] =
        JointTorque<Real>{eagerx::select(has_servo, servo.now, drive.torque), servo.slope} *
        drive.strength;
    const Real needed = kSlides<j> ? dot(link.axis, link.force) : dot(link.axis, link.torque);
    JointTorque<Real> sum = record.drive[j];
    using Damping = typename Group::template Damping<j>;
    if constexpr (!Constant<Damping, Lane>::is(Lane(0)))
      sum = sum + damping_torque(value<Real, Damping>(k), v);
    using Stiffness = typename Group::template Stiffness<j>;
    if constexpr (!Constant<Stiffness, Lane>::is(Lane(0)))
      sum = sum + spring_torque(value<Real, Stiffness>(k),
                                value<Real, typename Group::template Rest<j>>(k), q, v, dt);
    const FreeJoint<Real> free = free_joint(v, inertia, sum, needed, dt);
    // Two divisions that nearly no joint needs; lane by lane, so that others change no sign of a 0.
    if (const auto has_motor = drive.motor_torque > zero; any(has_motor)) {
      const JointTorque<Real> more =
          sum + motor_torque(drive.motor_velocity, drive.motor_torque, v, free, dt);
      sum = {eagerx::select(has_motor, more.now, sum.now),
             eagerx::select(has_motor, more.slope, sum.slope)};
    }
    constexpr Lane kUnlimited = std::numeric_limits<Lane>::infinity();
    using Low = typename Group::template Low<j>;
    using High = typename Group::template High<j>;
    using MaxVelocity = typename Group::template MaxVelocity<j>;
    if constexpr (!Constant<Low, Lane>::is(-kUnlimited))
      sum = sum + stop_torque(value<Real, Low>(k), Lane(-1), q, v, free, dt);
    if constexpr (!Constant<High, Lane>::is(kUnlimited))
      sum = sum + stop_torque(value<Real, High>(k), Lane(1), q, v, free, dt);
    if constexpr (!Constant<MaxVelocity, Lane>::is(kUnlimited)) {
      sum = sum + speed_limit_torque(value<Real, MaxVelocity>(k), v, free, dt);
      if (const auto is_held = held[index] != zero; any(is_held)) {
        const JointTorque<Real> torque = held_torque(held[index], v, free, dt);
        sum = {eagerx::select(is_held, torque.now, sum.now),
               eagerx::select(is_held, torque.slope, sum.slope)};
      }
    }
    record.rhs[j] = sum.now - needed;
    mass_[j][j] = inertia + Real(dt) * sum.slope;
  }

  Real mass_[n][n];      // lower triangle
  Real coupling_[n][6];  // with the base
};

}  // namespace eagerx::models::multibody

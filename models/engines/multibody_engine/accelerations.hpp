// Accelerations of a robot in a step, with the forces of its contacts.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <models/engines/multibody_engine/contact.hpp>
#include <models/engines/multibody_engine/ground.hpp>
#include <models/engines/multibody_engine/impulses.hpp>
#include <models/engines/multibody_engine/limb.hpp>
#include <models/engines/multibody_engine/pair_contacts.hpp>
#include <models/engines/multibody_engine/state.hpp>
#include <type_traits>

namespace eagerx::models::multibody {

template <class Model>
class Accelerations : public PairContacts<Model> {
  using Base = PairContacts<Model>;
  using Base::base_, Base::pairs_;
  using Base::each_group, Base::kGroups, Base::kMimicking;
  template <std::size_t g>
  using LimbOf = typename Base::template LimbOf<g>;

 public:
  using Real = typename Model::Real;
  using Lane = LaneOf<Real>;
  using State = multibody::State<Model>;
  using Settings = ContactSettings<Lane>;
  static constexpr bool kFloating = kFloats<Model>;
  static constexpr std::size_t kLimbPoints = kTree<Model>.limb_points;
  static constexpr std::size_t kBasePoints = kFloating ? State::kPoints - kLimbPoints : 0;
  static constexpr bool kBaseSolved = State::kLinks == 0;

 protected:
  using Base::kPairCount;

  Accelerations(State& state, const Settings& settings, const Real& height)
      : Base(state, settings), height_(height) {}

  /// Of base (kFloating) and links.
  [[gnu::always_inline]] void solve(int sweeps) {
    start_base();
    each_group([&](auto g) __attribute__((always_inline)) { make_equations<g>(); });
    if constexpr (kFloating) finish_base();
    if constexpr (kHasSolved || kMimicking || kPairCount > 0) solve_impulses(sweeps);
    if constexpr (kFloating) accelerate_base();
    each_group([&](auto g) __attribute__((always_inline)) { accelerate_limbs<g>(); });
    if constexpr (kBasePoints > 0 && !kBaseSolved) keep_base_forces();
  }

  // The velocity at which Step holds a joint; 0: it does not. Not set without limits of speed.
  Real held_[at_least_one(State::kLinks)];

 private:
  using Points = PointTable<Model>;
  static constexpr bool kHasSolved = kBaseSolved ? kBasePoints > 0 : kLimbPoints > 0;

  static constexpr bool is_solved(std::size_t g, std::size_t link) {
    const Group& group = kTree<Model>.groups[g];
    for (std::size_t p = 0; p < group.points; ++p) {
      const Point& point = kTree<Model>.points[group.first_point + p];
      if (point.link == group.first + link) return point.solved;
    }
    return false;
  }

  [[gnu::noinline]] void start_base() {
    const Real zero(Lane(0)), one(Lane(1));
    base_.at = base_.arm = all(zero);
    base_.acceleration = this->state_.gravity * Real(Lane(-1));
    base_.spin_acceleration = all(zero);
    forget_mass(base_);
    base_.force = base_.torque = all(zero);
    if constexpr (kFloating) {
      base_.axes = matrix(this->state_.rotation);
      base_.velocity = this->state_.velocity;
      base_.spin = this->state_.spin;
      unrolled<bodies_on<Model>(kNone)>([&](auto part) __attribute__((always_inline)) {
        using Part = typename BaseOf<Model>::template Part<part>;
        add_body<Part>(0, this->state_.mass_scale[Part::body(0)], base_);
      });
      this->state_.shift_base(base_);
      set_forces(base_);
      if (this->state_.is_pushed()) {
        unrolled<bodies_on<Model>(kNone)>([&](auto part) __attribute__((always_inline)) {
          this->state_.push_body(BaseOf<Model>::template Part<part>::body(0), base_);
        });
      }
      for (auto& row : this->equation_.a) {
        for (auto& element : row) element = zero;
      }
      for (auto& element : this->equation_.rhs) element = zero;
    } else {
      base_.axes = {{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}};
      base_.velocity = base_.spin = all(zero);
    }
  }

  /// A loop over limbs, not unrolled: code in proportion to the robot is slow when vectorized, and
  /// large on boards.
  template <std::size_t g>
  [[gnu::noinline]] void make_equations() {
    auto& records = this->template records<g>();
#pragma GCC unroll 1
    for (std::size_t k = 0; k < GroupOf<Model, g>::kCount; ++k) {
      LimbOf<g> limb;
      auto& record = records[k];
      limb.move(k, base_, this->state_);
      limb.gather(k, this->state_, held_, this->settings_.dt, base_, record);
      add_points<g, false>(k, limb, record);
      limb.eliminate(this->equation_, record);
      add_points<g, true>(k, limb, record);
      if constexpr (kPairCount > 0) {
        unrolled<LimbOf<g>::n>([&](auto j) __attribute__((always_inline)) {
          pairs_.link[GroupOf<Model, g>::index(k, j)] = limb.template link<j>();
        });
      }
    }
  }

  /// The compliant points of a limb before its elimination, the solved ones after it.
  template <std::size_t g, bool kSolved, class Record>
  [[gnu::always_inline]] void add_points(std::size_t k, LimbOf<g>& limb, Record& record) {
    LimbOf<g>::each_link_with_points([&](auto j, std::size_t first,
                                         std::size_t end) __attribute__((always_inline)) {
      if constexpr (is_solved(g, j) == kSolved) {
#pragma GCC unroll 1
        for (std::size_t p = first; p < end; ++p) {
          const std::size_t index = GroupOf<Model, g>::point(k, p);
          auto& point = record.points[p];
          place_point<j>(limb, index, point);
          if constexpr (kSolved) {
            limb.template set_rows<j>(point, axes_of(index), this->settings_.dt, record);
          } else {
            set_compliant(this->settings_, Points::friction(this->state_, index),
                          axes_of(index).from_world(this->state_.force[index]).z, point);
            limb.template add_compliant<j>(point, axes_of(index), this->equation_, record);
          }
        }
      }
    });
  }

  template <std::size_t j, class Limb, class Record>
  [[gnu::always_inline]] void place_point(const Limb& limb, std::size_t index, Record& point) {
    if constexpr (kIsLevel<Model>) {
      const auto offset = [index](const auto& axes) __attribute__((always_inline)) {
        return Points::offset(index, axes);
      };
      point.motion = limb.template point_motion<j>(offset, height_, this->state_.gravity);
    } else {
      const Moving<Real>& link = limb.template link<j>();
      const Touch<Real> touch = touch_of(index, link.axes, link.at);
      point.motion = limb.template point_motion<j>(touch, this->state_.gravity);
    }
  }
  /// Where a point touches ground that is not level; keeps its axes.
  Touch<Real> touch_of(std::size_t index, const Mat<Real>& axes, const Vec<Real>& joint) {
    const Vec<Real> base = this->state_.position - constant<Real>(plane_point<Model>());
    const Touch<Real> touch = Ground<Model>::touch(this->state_, index, axes, base + joint);
    contact_axes_[index] = {touch.frame};
    return touch;
  }
  [[gnu::always_inline]] auto axes_of(std::size_t index) const {
    if constexpr (kIsLevel<Model>) {
      return static_cast<void>(index), WorldAxes<Real>{};
    } else {
      return contact_axes_[index];
    }
  }

  [[gnu::noinline]] void finish_base() {
    add_base_points();
    auto& a = this->equation_.a;
    const Real& m = base_.mass;
    const Vec<Real>& h = base_.moment;
    const Sym<Real>& i = base_.inertia;
    a[0][0] += m, a[1][1] += m, a[2][2] += m;
    a[3][1] -= h.z, a[3][2] += h.y;
    a[4][0] += h.z, a[4][2] -= h.x;
    a[5][0] -= h.y, a[5][1] += h.x;
    a[3][3] += i.xx, a[4][4] += i.yy, a[5][5] += i.zz;
    a[4][3] += i.xy, a[5][3] += i.xz, a[5][4] += i.yz;
    const Real needed[6] = {base_.force.x,  base_.force.y,  base_.force.z,
                            base_.torque.x, base_.torque.y, base_.torque.z};
    unrolled<6>([&](auto j)
                    __attribute__((always_inline)) { this->equation_.rhs[j] -= needed[j]; });
    factor_base();
  }
  /// LᵀDL as of limbs, from the angular end; L replaces A.
  [[gnu::always_inline]] void factor_base() {
    auto& a = this->equation_.a;
    unrolled<6>([&](auto back) __attribute__((always_inline)) {
      constexpr std::size_t j = 5 - back;
      this->base_inverse_[j] = Real(Lane(1)) / a[j][j];
      unrolled<j>([&](auto i) __attribute__((always_inline)) {
        const Real l = a[j][i] * this->base_inverse_[j];
        unrolled<i + 1>([&](auto up) __attribute__((always_inline)) { a[i][up] -= l * a[j][up]; });
        this->equation_.rhs[i] -= l * this->equation_.rhs[j];
      });
      unrolled<j>([&](auto i)
                      __attribute__((always_inline)) { a[j][i] *= this->base_inverse_[j]; });
    });
  }

  [[gnu::always_inline]] void add_base_points() {
#pragma GCC unroll 1
    for (std::size_t p = 0; p < kBasePoints; ++p) {
      const std::size_t index = kLimbPoints + p;
      auto& point = base_points_[p];
      Vec<Real> d,
          center;  // of a sphere or rim on ground that is not level, which `d` goes along with
      Real depth;
      if constexpr (kIsLevel<Model>) {
        d = center = Points::offset(index, base_.axes);
        depth = -(height_ + d.z);
      } else {
        const Touch<Real> touch = touch_of(index, base_.axes, all(Real(Lane(0))));
        d = touch.at;
        center = touch.center;
        depth = touch.depth;
      }
      const auto axes = axes_of(index);
      point.motion = {.at = d,
                      .velocity = axes.from_world(base_.velocity + cross(base_.spin, d)),
                      .bias = axes.from_world(cross(base_.spin, cross(base_.spin, center))),
                      .depth = depth};
      if constexpr (kBaseSolved) {
        set_base_rows(d, point.row_base);
        axes.turn_rows(point.row_base);
        point.free = point.motion.velocity + point.motion.bias * Real(this->settings_.dt);
      } else {
        set_compliant(this->settings_, Points::friction(this->state_, index),
                      axes.from_world(this->state_.force[index]).z, point);
        axes.add_impedance(d, point.impedance, this->equation_);
        this->equation_.add_force(
            d, axes.to_world(point.force - scaled(point.impedance, point.motion.bias)));
      }
    }
  }

  // ---- solved contacts
  /// f(record of the point, index, impulses on its links) for each, in a fixed order.
  template <class F>
  [[gnu::always_inline]] void each_solved(const F& f) {
    if constexpr (kBaseSolved) {
#pragma GCC unroll 1
      for (std::size_t p = 0; p < kBasePoints; ++p)
        f(base_points_[p], kLimbPoints + p, static_cast<Real*>(nullptr));
    }
    each_group([&](auto g) __attribute__((always_inline)) {
      auto& records = this->template records<g>();
#pragma GCC unroll 1
      for (std::size_t k = 0; k < GroupOf<Model, g>::kCount; ++k) {
        auto& record = records[k];
        LimbOf<g>::each_link_with_points([&](auto j, std::size_t first,
                                             std::size_t end) __attribute__((always_inline)) {
          if constexpr (is_solved(g, j)) {
#pragma GCC unroll 1
            for (std::size_t p = first; p < end; ++p)
              f(record.points[p], GroupOf<Model, g>::point(k, p), record.pushed);
          }
        });
      }
    });
  }

  /// Projected Gauss-Seidel on the velocities of the end of the step, from the last step's
  /// impulses.
  [[gnu::noinline]] void solve_impulses(int sweeps) {
    const Real zero(Lane(0)), dt(this->settings_.dt), per_step(Lane(1) / this->settings_.dt);
    for (auto& element : this->base_pushed_) element = zero;
    each_group([&](auto g) __attribute__((always_inline)) {
      for (auto& record : this->template records<g>()) {
        for (auto& element : record.pushed) element = zero;
      }
    });
    each_solved([&]<std::size_t n>(PointRecord<Real, n> & point, std::size_t index, Real * links)
                    __attribute__((always_inline)) {
                      if constexpr (kFloating) this->finish_base_rows(point);
                      finish_rows<Real, n, kFloating>(this->settings_, point);
                      if constexpr (Points::kBounces)
                        let_bounce(this->settings_, Points::bounce(index), point);
                      Vec<Real>& impulse = this->state_.force[index];
                      impulse = axes_of(index).from_world(impulse) * dt;
                      push<Real, n, kFloating>(point, impulse, links, this->base_pushed_);
                    });
    if constexpr (kPairCount > 0) this->make_pair_rows();
    if constexpr (kMimicking) {
      this->make_mimic_rows();
      this->solve_mimics();
    }
#pragma GCC unroll 1
    for (int i = 0; (kHasSolved || kPairCount > 0) && i < sweeps; ++i) {
      each_solved([&]<std::size_t n>(PointRecord<Real, n> & point, std::size_t index,
                                     Real * links) __attribute__((always_inline)) {
        sweep<Real, n, kFloating>(point, Points::friction(this->state_, index),
                                  this->state_.force[index], links, this->base_pushed_);
      });
      if constexpr (kPairCount > 0) this->sweep_pairs();
      if constexpr (kMimicking) this->solve_mimics();
    }
    if constexpr (kPairCount > 0) this->keep_pair_forces(per_step);
    each_solved([&]<std::size_t n>(PointRecord<Real, n>&, std::size_t index,
                                   Real*) __attribute__((always_inline)) {
      this->state_.force[index] = axes_of(index).to_world(this->state_.force[index]) * per_step;
    });
    if constexpr (kFloating) {
      unrolled<6>([&](auto j) __attribute__((always_inline)) {
        this->equation_.rhs[j] += this->base_pushed_[j] * per_step;
      });
    }
    each_group([&](auto g) __attribute__((always_inline)) {
      for (auto& record : this->template records<g>()) {
        unrolled<LimbOf<g>::n>([&](auto j) __attribute__((always_inline)) {
          record.rhs[j] += record.pushed[j] * per_step;
        });
      }
    });
  }
  // ---- accelerations
  [[gnu::always_inline]] void accelerate_base() {
    unrolled<6>([&](auto j) __attribute__((always_inline)) {
      Real sum = this->equation_.rhs[j] * this->base_inverse_[j];
      unrolled<j>([&](auto i) __attribute__((always_inline)) {
        sum -= this->equation_.a[j][i] * this->base_acceleration[i];
      });
      this->base_acceleration[j] = sum;
    });
  }
  template <std::size_t g>
  [[gnu::noinline]] void accelerate_limbs() {
    auto& records = this->template records<g>();
#pragma GCC unroll 1
    for (std::size_t k = 0; k < GroupOf<Model, g>::kCount; ++k) {
      auto& record = records[k];
      Real along[LimbOf<g>::n];
      unrolled<LimbOf<g>::n>([&](auto j) __attribute__((always_inline)) {
        Real sum = record.rhs[j] * record.inverse[j];
        if constexpr (kFloating) {
          unrolled<6>([&](auto b) __attribute__((always_inline)) {
            sum -= record.to_base[j][b] * this->base_acceleration[b];
          });
        }
        each_above<typename LimbOf<g>::Group, j>([&](auto i) __attribute__((always_inline)) {
          sum -= record.lower[j][i] * along[i];
        });
        along[j] = sum;
        const std::size_t index = GroupOf<Model, g>::index(k, j);
        this->acceleration[index] = sum;
        this->state_.drive[index].applied =
            record.drive[j].now - Real(this->settings_.dt) * record.drive[j].slope * sum;
      });
      keep_limb_forces<g>(k, record, along);
    }
  }
  /// Of compliant points, for the next step's friction and for sensors.
  template <std::size_t g, class Record>
  [[gnu::always_inline]] void keep_limb_forces(std::size_t k, const Record& record,
                                               const Real (&along)[LimbOf<g>::n]) {
    LimbOf<g>::each_link_with_points([&](auto j, std::size_t first,
                                         std::size_t end) __attribute__((always_inline)) {
      if constexpr (!is_solved(g, j)) {
#pragma GCC unroll 1
        for (std::size_t p = first; p < end; ++p) {
          const auto& point = record.points[p];
          Vec<Real> a = point.motion.bias;
          const std::size_t index = GroupOf<Model, g>::point(k, p);
          if constexpr (kFloating) a = a + axes_of(index).from_world(of_base(point.motion.at));
          each_carrier<typename LimbOf<g>::Group, j>([&](auto i) __attribute__((always_inline)) {
            a = a + point.jacobian[i] * along[i];
          });
          keep_force(point, axes_of(index), a, this->state_.force[index]);
        }
      }
    });
  }
  [[gnu::always_inline]] void keep_base_forces() {
#pragma GCC unroll 1
    for (std::size_t p = 0; p < kBasePoints; ++p) {
      const auto& point = base_points_[p];
      const auto axes = axes_of(kLimbPoints + p);
      keep_force(point, axes, point.motion.bias + axes.from_world(of_base(point.motion.at)),
                 this->state_.force[kLimbPoints + p]);
    }
  }
  [[gnu::always_inline]] Vec<Real> of_base(const Vec<Real>& at) const {
    const Vec<Real> turn{this->base_acceleration[3], this->base_acceleration[4],
                         this->base_acceleration[5]};
    return Vec<Real>{this->base_acceleration[0], this->base_acceleration[1],
                     this->base_acceleration[2]} +
           cross(turn, at);
  }
  template <std::size_t n, class Axes>
  [[gnu::always_inline]] static void keep_force(const PointRecord<Real, n>& point, const Axes& axes,
                                                const Vec<Real>& a, Vec<Real>& force) {
    force = point.force - scaled(point.impedance, a);
    force.z = eagerx::max(force.z, Real(Lane(0)));
    force = axes.to_world(force);
  }

  const Real height_;  // of the base's reference point above the plane
  PointRecord<Real, 0> base_points_[at_least_one(kBasePoints)];
  static constexpr std::size_t kAxes = kIsLevel<Model> ? 1 : at_least_one(State::kPoints);
  std::conditional_t<kIsLevel<Model>, WorldAxes<Real>, ContactAxes<Real>> contact_axes_[kAxes];
};

}  // namespace eagerx::models::multibody

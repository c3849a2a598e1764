// A step of a robot: accelerations, contacts, and the semi-implicit Euler method.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <models/engines/multibody_engine/contact.hpp>
#include <models/engines/multibody_engine/limb.hpp>
#include <models/engines/multibody_engine/mimic.hpp>
#include <models/engines/multibody_engine/state.hpp>
#include <type_traits>
#include <utility>

namespace eagerx::models::multibody {

template <class Model>
inline constexpr bool kFloats = count_free<Model>() == 1;

/// Records of the limbs of group g, and of all groups.
template <class Model, std::size_t g>
struct GroupRecords {
  typename Limb<Model, g, kFloats<Model>>::Record limb[GroupOf<Model, g>::kCount];
};
template <class Model, class Groups>
struct Records;
template <class Model, std::size_t... g>
struct Records<Model, std::index_sequence<g...>> : GroupRecords<Model, g>... {};

template <class Model>
class Step {
 public:
  using Real = typename Model::Real;
  using Lane = LaneOf<Real>;
  using State = multibody::State<Model>;
  using Settings = ContactSettings<Lane>;
  static constexpr bool kFloating = kFloats<Model>;
  static constexpr std::size_t kGroups = kTree<Model>.group_count;
  static constexpr std::size_t kLimbPoints = kTree<Model>.limb_points;
  static constexpr std::size_t kBasePoints = kFloating ? State::kPoints - kLimbPoints : 0;
  static constexpr bool kBaseSolved = State::kLinks == 0;

  Step(State& state, const Settings& settings, const Real& height)
      : state_(state), settings_(settings), height_(height) {}

  /// Velocities, then positions.
  [[gnu::always_inline]] void advance(int sweeps) {
    set_accelerations(sweeps);
    move();
  }

  /// Of base (kFloating) and links, with the forces of contacts.
  [[gnu::always_inline]] void set_accelerations(int sweeps) {
    start_base();
    each_group([&](auto g) __attribute__((always_inline)) { make_equations<g>(); });
    if constexpr (kFloating) finish_base();
    if constexpr (kHasSolved || kMimicking) solve_impulses(sweeps);
    if constexpr (kFloating) accelerate_base();
    each_group([&](auto g) __attribute__((always_inline)) { accelerate_limbs<g>(); });
    if constexpr (kBasePoints > 0 && !kBaseSolved) keep_base_forces();
  }

  Real acceleration[at_least_one(State::kLinks)];
  Real base_acceleration[6];  // linear, angular

 private:
  using Points = PointTable<Model>;
  template <std::size_t g>
  using LimbOf = Limb<Model, g, kFloating>;
  static constexpr bool kHasSolved = kBaseSolved ? kBasePoints > 0 : kLimbPoints > 0;
  static constexpr bool kMimicking = count_mimics<Model>() > 0;

  template <class F>
  [[gnu::always_inline]] static void each_group(const F& f) {
    unrolled<kGroups>(f);
  }
  template <std::size_t g>
  [[gnu::always_inline]] auto& records() {
    return static_cast<GroupRecords<Model, g>&>(records_).limb;
  }
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
    base_.acceleration = state_.gravity * Real(Lane(-1));
    base_.spin_acceleration = all(zero);
    forget_mass(base_);
    base_.force = base_.torque = all(zero);
    if constexpr (kFloating) {
      base_.axes = matrix(state_.rotation);
      base_.velocity = state_.velocity;
      base_.spin = state_.spin;
      unrolled<bodies_on<Model>(kNone)>([&](auto part) __attribute__((always_inline)) {
        using Part = typename BaseOf<Model>::template Part<part>;
        add_body<Part>(0, state_.mass_scale[Part::body(0)], base_);
      });
      state_.shift_base(base_);
      set_forces(base_);
      if (state_.is_pushed()) {
        unrolled<bodies_on<Model>(kNone)>([&](auto part) __attribute__((always_inline)) {
          state_.push_body(BaseOf<Model>::template Part<part>::body(0), base_);
        });
      }
      for (auto& row : equation_.a) {
        for (auto& element : row) element = zero;
      }
      for (auto& element : equation_.rhs) element = zero;
    } else {
      base_.axes = {{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}};
      base_.velocity = base_.spin = all(zero);
    }
  }

  /// A loop over limbs, not one after the other: code that is as long as the robot is slow in packs
  /// and large on boards.
  template <std::size_t g>
  [[gnu::noinline]] void make_equations() {
    auto& records = this->records<g>();
#pragma GCC unroll 1
    for (std::size_t k = 0; k < GroupOf<Model, g>::kCount; ++k) {
      LimbOf<g> limb;
      auto& record = records[k];
      limb.move(k, base_, state_);
      limb.gather(k, state_, settings_.dt, base_, record);
      add_points<g, false>(k, limb, record);
      limb.eliminate(equation_, record);
      add_points<g, true>(k, limb, record);
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
          const auto offset = [index](const auto& axes) __attribute__((always_inline)) {
            return Points::offset(index, axes);
          };
          point.motion = limb.template point_motion<j>(offset, height_, state_.gravity);
          if constexpr (kSolved) {
            limb.template set_rows<j>(point, settings_.dt, record);
          } else {
            set_compliant(settings_, Points::friction(state_, index), state_.force[index].z, point);
            limb.template add_compliant<j>(point, equation_, record);
          }
        }
      }
    });
  }

  [[gnu::noinline]] void finish_base() {
    add_base_points();
    auto& a = equation_.a;
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
    unrolled<6>([&](auto j) __attribute__((always_inline)) { equation_.rhs[j] -= needed[j]; });
    factor_base();
  }
  /// LᵀDL as of limbs, from the angular end; L in place of A.
  [[gnu::always_inline]] void factor_base() {
    auto& a = equation_.a;
    unrolled<6>([&](auto back) __attribute__((always_inline)) {
      constexpr std::size_t j = 5 - back;
      base_inverse_[j] = Real(Lane(1)) / a[j][j];
      unrolled<j>([&](auto i) __attribute__((always_inline)) {
        const Real l = a[j][i] * base_inverse_[j];
        unrolled<i + 1>([&](auto up) __attribute__((always_inline)) { a[i][up] -= l * a[j][up]; });
        equation_.rhs[i] -= l * equation_.rhs[j];
      });
      unrolled<j>([&](auto i) __attribute__((always_inline)) { a[j][i] *= base_inverse_[j]; });
    });
  }

  [[gnu::always_inline]] void add_base_points() {
#pragma GCC unroll 1
    for (std::size_t p = 0; p < kBasePoints; ++p) {
      const std::size_t index = kLimbPoints + p;
      auto& point = base_points_[p];
      const Vec<Real> d = Points::offset(index, base_.axes);
      point.motion = {.at = d,
                      .velocity = base_.velocity + cross(base_.spin, d),
                      .bias = cross(base_.spin, cross(base_.spin, d)),
                      .depth = -(height_ + d.z)};
      if constexpr (kBaseSolved) {
        set_base_rows(d, point.row_base);
        point.free = point.motion.velocity + point.motion.bias * Real(settings_.dt);
      } else {
        set_compliant(settings_, Points::friction(state_, index), state_.force[index].z, point);
        equation_.add_impedance(d, point.impedance);
        equation_.add_force(d, point.force - scaled(point.impedance, point.motion.bias));
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
      auto& records = this->records<g>();
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
    const Real zero(Lane(0)), dt(settings_.dt), per_step(Lane(1) / settings_.dt);
    for (auto& element : base_pushed_) element = zero;
    each_group([&](auto g) __attribute__((always_inline)) {
      for (auto& record : this->records<g>()) {
        for (auto& element : record.pushed) element = zero;
      }
    });
    each_solved([&]<std::size_t n>(PointRecord<Real, n> & point, std::size_t index, Real * links)
                    __attribute__((always_inline)) {
                      if constexpr (kFloating) finish_base_rows(point);
                      finish_rows<Real, n, kFloating>(settings_, point);
                      if constexpr (Points::kBounces)
                        let_bounce(settings_, Points::bounce(index), point);
                      Vec<Real>& impulse = state_.force[index];
                      impulse = impulse * dt;
                      push<Real, n, kFloating>(point, impulse, links, base_pushed_);
                    });
    if constexpr (kMimicking) {
      make_mimic_rows();
      solve_mimics();
    }
#pragma GCC unroll 1
    for (int i = 0; kHasSolved && i < sweeps; ++i) {
      each_solved([&]<std::size_t n>(PointRecord<Real, n> & point, std::size_t index, Real * links)
                      __attribute__((always_inline)) {
                        sweep<Real, n, kFloating>(point, Points::friction(state_, index),
                                                  state_.force[index], links, base_pushed_);
                      });
      if constexpr (kMimicking) solve_mimics();
    }
    each_solved([&]<std::size_t n>(PointRecord<Real, n>&, std::size_t index, Real*) __attribute__((
        always_inline)) { state_.force[index] = state_.force[index] * per_step; });
    if constexpr (kFloating) {
      unrolled<6>([&](auto j) __attribute__((always_inline)) {
        equation_.rhs[j] += base_pushed_[j] * per_step;
      });
    }
    each_group([&](auto g) __attribute__((always_inline)) {
      for (auto& record : this->records<g>()) {
        unrolled<LimbOf<g>::n>([&](auto j) __attribute__((always_inline)) {
          record.rhs[j] += record.pushed[j] * per_step;
        });
      }
    });
  }
  // ---- joints that follow others
  [[gnu::noinline]] void make_mimic_rows() {
    mimics_.clear();
    const Real dt(settings_.dt);
    for (std::size_t m = 0; m < kMimics<Model>.size(); ++m) {
      const Mimicry& mimicry = kMimics<Model>[m];
      mimics_.velocity[m] = state_.v[mimicry.follower] -
                            Real(static_cast<Lane>(mimicry.ratio)) * state_.v[mimicry.leader];
    }
    each_limb([&]<std::size_t g>(std::size_t k, auto& record) __attribute__((always_inline)) {
      const std::size_t first = GroupOf<Model, g>::index(k, 0);
      for (std::size_t m = 0; m < kMimics<Model>.size(); ++m) {
        Real* const row = mimics_.row[m] + first;
        LimbOf<g>::reduce(record, row, mimics_.base[m]);
        for (std::size_t j = 0; j < LimbOf<g>::n; ++j) {
          const Real weighted = row[j] * record.inverse[j];
          mimics_.weighted[m][first + j] = weighted;
          mimics_.velocity[m] += dt * (weighted * record.rhs[j]);
        }
      }
    });
    for (std::size_t m = 0; kFloating && m < kMimics<Model>.size(); ++m) {
      Real(&row)[6] = mimics_.base[m];
      for (std::size_t j = 6; j-- > 0;) {
        for (std::size_t i = 0; i < j; ++i) row[i] -= equation_.a[j][i] * row[j];
        mimics_.weighted_base[m][j] = row[j] * base_inverse_[j];
        mimics_.velocity[m] += dt * (mimics_.weighted_base[m][j] * equation_.rhs[j]);
      }
    }
    mimics_.decompose();
  }
  /// After what contacts have pushed.
  [[gnu::noinline]] void solve_mimics() {
    Real velocity[MimicRows<Model>::kSize];
    for (std::size_t m = 0; m < kMimics<Model>.size(); ++m) {
      velocity[m] = mimics_.velocity[m];
      for (std::size_t b = 0; kFloating && b < 6; ++b)
        velocity[m] += mimics_.weighted_base[m][b] * base_pushed_[b];
    }
    each_limb([&]<std::size_t g>(std::size_t k, auto& record) __attribute__((always_inline)) {
      const std::size_t first = GroupOf<Model, g>::index(k, 0);
      for (std::size_t m = 0; m < kMimics<Model>.size(); ++m) {
        for (std::size_t j = 0; j < LimbOf<g>::n; ++j)
          velocity[m] += mimics_.weighted[m][first + j] * record.pushed[j];
      }
    });
    mimics_.solve(velocity);
    each_limb([&]<std::size_t g>(std::size_t k, auto& record) __attribute__((always_inline)) {
      const std::size_t first = GroupOf<Model, g>::index(k, 0);
      for (std::size_t m = 0; m < kMimics<Model>.size(); ++m) {
        for (std::size_t j = 0; j < LimbOf<g>::n; ++j)
          record.pushed[j] += mimics_.row[m][first + j] * mimics_.impulse[m];
      }
    });
    for (std::size_t m = 0; kFloating && m < kMimics<Model>.size(); ++m) {
      for (std::size_t b = 0; b < 6; ++b)
        base_pushed_[b] += mimics_.base[m][b] * mimics_.impulse[m];
    }
  }
  /// f<group>(limb, its record).
  template <class F>
  [[gnu::always_inline]] void each_limb(const F& f) {
    each_group([&](auto g) __attribute__((always_inline)) {
      auto& records = this->records<g>();
#pragma GCC unroll 1
      for (std::size_t k = 0; k < GroupOf<Model, g>::kCount; ++k)
        f.template operator()<g>(k, records[k]);
    });
  }

  /// The base's part of L⁻ᵀJᵀ.
  template <std::size_t n>
  [[gnu::always_inline]] void finish_base_rows(PointRecord<Real, n>& point) {
    Real* const free[3] = {&point.free.x, &point.free.y, &point.free.z};
    const Real dt(settings_.dt);
    unrolled<3>([&](auto d) __attribute__((always_inline)) {
      Real(&row)[6] = point.row_base[d];
      unrolled<6>([&](auto back) __attribute__((always_inline)) {
        constexpr std::size_t j = 5 - back;
        unrolled<j>([&](auto i)
                        __attribute__((always_inline)) { row[i] -= equation_.a[j][i] * row[j]; });
        point.weighted_base[d][j] = row[j] * base_inverse_[j];
        *free[d] += dt * (point.weighted_base[d][j] * equation_.rhs[j]);
      });
    });
  }

  // ---- accelerations
  [[gnu::always_inline]] void accelerate_base() {
    unrolled<6>([&](auto j) __attribute__((always_inline)) {
      Real sum = equation_.rhs[j] * base_inverse_[j];
      unrolled<j>([&](auto i) __attribute__((always_inline)) {
        sum -= equation_.a[j][i] * base_acceleration[i];
      });
      base_acceleration[j] = sum;
    });
  }
  template <std::size_t g>
  [[gnu::noinline]] void accelerate_limbs() {
    auto& records = this->records<g>();
#pragma GCC unroll 1
    for (std::size_t k = 0; k < GroupOf<Model, g>::kCount; ++k) {
      auto& record = records[k];
      Real along[LimbOf<g>::n];
      unrolled<LimbOf<g>::n>([&](auto j) __attribute__((always_inline)) {
        Real sum = record.rhs[j] * record.inverse[j];
        if constexpr (kFloating) {
          unrolled<6>([&](auto b) __attribute__((always_inline)) {
            sum -= record.to_base[j][b] * base_acceleration[b];
          });
        }
        LimbOf<g>::template each_above<j>([&](auto i) __attribute__((always_inline)) {
          sum -= record.lower[j][i] * along[i];
        });
        along[j] = sum;
        const std::size_t index = GroupOf<Model, g>::index(k, j);
        acceleration[index] = sum;
        state_.drive[index].applied =
            record.drive[j].now - Real(settings_.dt) * record.drive[j].slope * sum;
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
          if constexpr (kFloating) a = a + of_base(point.motion.at);
          LimbOf<g>::template each_carrier<j>([&](auto i) __attribute__((always_inline)) {
            a = a + point.jacobian[i] * along[i];
          });
          keep_force(point, a, state_.force[GroupOf<Model, g>::point(k, p)]);
        }
      }
    });
  }
  [[gnu::always_inline]] void keep_base_forces() {
#pragma GCC unroll 1
    for (std::size_t p = 0; p < kBasePoints; ++p) {
      const auto& point = base_points_[p];
      keep_force(point, point.motion.bias + of_base(point.motion.at),
                 state_.force[kLimbPoints + p]);
    }
  }
  [[gnu::always_inline]] Vec<Real> of_base(const Vec<Real>& at) const {
    const Vec<Real> turn{base_acceleration[3], base_acceleration[4], base_acceleration[5]};
    return Vec<Real>{base_acceleration[0], base_acceleration[1], base_acceleration[2]} +
           cross(turn, at);
  }
  template <std::size_t n>
  [[gnu::always_inline]] static void keep_force(const PointRecord<Real, n>& point,
                                                const Vec<Real>& a, Vec<Real>& force) {
    force = point.force - scaled(point.impedance, a);
    force.z = eagerx::max(force.z, Real(Lane(0)));
  }

  [[gnu::always_inline]] void move() {
    const Real dt(settings_.dt);
    for (std::size_t j = 0; j < State::kLinks; ++j) {
      state_.v[j] += dt * acceleration[j];
      state_.q[j] += dt * state_.v[j];
    }
    follow_leaders<Model>(state_);
    if constexpr (kFloating) {
      const Real* const a = base_acceleration;
      state_.velocity = state_.velocity + Vec<Real>{a[0], a[1], a[2]} * dt;
      state_.spin = state_.spin + Vec<Real>{a[3], a[4], a[5]} * dt;
      state_.position = state_.position + state_.velocity * dt;
      state_.rotation = turned(state_.rotation, state_.spin, settings_.dt);
    }
  }

  State& state_;
  const Settings settings_;
  const Real height_;  // of the base's reference point above the plane
  Moving<Real> base_;
  BaseEquation<Real> equation_;
  Real base_inverse_[6], base_pushed_[6];
  Records<Model, std::make_index_sequence<kGroups>> records_;
  PointRecord<Real, 0> base_points_[at_least_one(kBasePoints)];
  struct None {};
  std::conditional_t<kMimicking, MimicRows<Model>, None> mimics_;
};

}  // namespace eagerx::models::multibody

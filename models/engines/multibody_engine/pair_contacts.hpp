// Contacts of chosen pairs of shapes of one object, as impulses of a step.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/math.hpp>
#include <models/engines/multibody_engine/contact.hpp>
#include <models/engines/multibody_engine/impulses.hpp>
#include <models/engines/multibody_engine/limb.hpp>
#include <models/engines/multibody_engine/pairs.hpp>
#include <models/engines/multibody_engine/state.hpp>
#include <type_traits>

namespace eagerx::models::multibody {

template <class Model>
class PairContacts : public Impulses<Model> {
  using Base = Impulses<Model>;

 public:
  using Base::kFloating;
  using typename Base::Lane, typename Base::Real, typename Base::Settings, typename Base::State;

 protected:
  template <std::size_t g>
  using LimbOf = typename Base::template LimbOf<g>;
  static constexpr std::size_t kPairCount = count_pairs<Model>();
  static constexpr std::size_t kPairLinks = at_least_one(State::kLinks);
  using PairRecord = PointRecord<Real, kPairLinks>;
  struct Pairs {
    Moving<Real> link[kPairLinks];
    PairRecord record[at_least_one(kPairCount)];
    ContactAxes<Real> axes[at_least_one(kPairCount)];
  };
  struct NoPairs {};

  PairContacts(State& state, const Settings& settings) : Base(state, settings) {}

  // ---- pairs of shapes of the object
  /// As points, with rows over all links: those of the first shape less those of the second.
  [[gnu::noinline]] void make_pair_rows() {
    const Real zero(Lane(0)), dt(this->settings_.dt);
#pragma GCC unroll 1
    for (std::size_t p = 0; p < kPairCount; ++p) {
      const auto& pair = kPairsOf<Model>[p];
      const Moving<Real>* const links[2] = {link_of(pair[0].link), link_of(pair[1].link)};
      const PairTouch<Real> touch = touch_of_pair(pair, links);
      pairs_.axes[p] = {touch.frame};
      PairRecord& record = pairs_.record[p];
      for (auto& row : record.row) {
        for (auto& element : row) element = zero;
      }
      for (auto& row : record.row_base) {
        for (auto& element : row) element = zero;
      }
      record.motion.depth = touch.depth;
      record.motion.velocity = record.motion.bias = all(zero);
      add_side<false>(*links[0], pair[0].link, touch.side[0], record);
      add_side<true>(*links[1], pair[1].link, touch.side[1], record);
      turn_pair(pairs_.axes[p], record);
      record.free = record.motion.velocity + record.motion.bias * dt;
      weigh_pair(record);
      finish_rows<Real, kPairLinks, kFloating>(this->settings_, record);
      if (bounce_of(pair) > 0.0)
        let_bounce(this->settings_, Real(static_cast<Lane>(bounce_of(pair))), record);
      Vec<Real>& impulse = this->state_.pair_force[p];
      impulse = pairs_.axes[p].from_world(impulse) * dt;
      push_pair(record, impulse);
    }
  }
  [[nodiscard]] const Moving<Real>* link_of(std::size_t link) const {
    return link == kNone ? &base_ : &pairs_.link[link];
  }
  static constexpr double bounce_of(const std::array<RoundShape, 2>& pair) {
    return eagerx::max(Model::kGeometries[pair[0].geometry].bounce,
                       Model::kGeometries[pair[1].geometry].bounce);
  }
  /// In the world's axes. The contact stays between the shapes while they turn, so the bias is that
  /// of the middle line.
  template <bool kSecond>
  void add_side(const Moving<Real>& on, std::size_t link, const PairSide<Real>& side,
                PairRecord& to) {
    const auto add = [](auto& sum, const auto& x) {
      if constexpr (kSecond) {
        sum = sum - x;
      } else {
        sum = sum + x;
      }
    };
    const Vec<Real> d = side.at - on.at, center = side.center - on.at;
    const Vec<Real> bias = on.acceleration + this->state_.gravity +
                           cross(on.spin_acceleration, center) +
                           cross(on.spin, cross(on.spin, center));
    add(to.motion.velocity, on.velocity + cross(on.spin, d));
    add(to.motion.bias, bias);
    for (std::size_t l = link; l != kNone; l = kTree<Model>.links[l].parent) {
      const Moving<Real>& up = pairs_.link[l];
      const Vec<Real> along =
          kTree<Model>.links[l].slides ? up.axis : cross(up.axis, side.at - up.at);
      add(to.row[0][l], along.x), add(to.row[1][l], along.y), add(to.row[2][l], along.z);
    }
    if constexpr (kFloating) {
      Real rows[3][6];
      set_base_rows(side.at, rows);
      for (std::size_t d3 = 0; d3 < 3; ++d3) {
        for (std::size_t j = 0; j < 6; ++j) add(to.row_base[d3][j], rows[d3][j]);
      }
    }
  }
  static void turn_pair(const ContactAxes<Real>& axes, PairRecord& record) {
    record.motion.velocity = axes.from_world(record.motion.velocity);
    record.motion.bias = axes.from_world(record.motion.bias);
    axes.turn_rows(record.row_base);
    for (std::size_t l = 0; l < State::kLinks; ++l) {
      const Vec<Real> turned =
          axes.from_world({record.row[0][l], record.row[1][l], record.row[2][l]});
      record.row[0][l] = turned.x, record.row[1][l] = turned.y, record.row[2][l] = turned.z;
    }
  }
  /// L⁻ᵀJᵀ, and the velocity that torques and forces add.
  void weigh_pair(PairRecord& record) {
    Real* const free[3] = {&record.free.x, &record.free.y, &record.free.z};
    const Real dt(this->settings_.dt);
    for (std::size_t d = 0; d < 3; ++d) {
      this->each_limb([&]<std::size_t g>(std::size_t k, auto& limb) __attribute__((always_inline)) {
        const std::size_t first = GroupOf<Model, g>::index(k, 0);
        Real* const row = record.row[d] + first;
        LimbOf<g>::reduce(limb, row, record.row_base[d]);
        for (std::size_t j = 0; j < LimbOf<g>::n; ++j) {
          record.weighted[d][first + j] = row[j] * limb.inverse[j];
          *free[d] += dt * (record.weighted[d][first + j] * limb.rhs[j]);
        }
      });
    }
    if constexpr (kFloating) finish_base_rows(record);
  }
  void push_pair(const PairRecord& record, const Vec<Real>& impulse) {
    Real links[kPairLinks];
    for (auto& element : links) element = Real(Lane(0));
    push<Real, kPairLinks, kFloating>(record, impulse, links, this->base_pushed_);
    this->each_limb([&]<std::size_t g>(std::size_t k, auto& limb) __attribute__((always_inline)) {
      for (std::size_t j = 0; j < LimbOf<g>::n; ++j)
        limb.pushed[j] += links[GroupOf<Model, g>::index(k, j)];
    });
  }
  [[gnu::noinline]] void sweep_pairs() {
    Real links[kPairLinks];
    this->each_limb([&]<std::size_t g>(std::size_t k, auto& limb) __attribute__((always_inline)) {
      for (std::size_t j = 0; j < LimbOf<g>::n; ++j)
        links[GroupOf<Model, g>::index(k, j)] = limb.pushed[j];
    });
#pragma GCC unroll 1
    for (std::size_t p = 0; p < kPairCount; ++p) {
      const auto& pair = kPairsOf<Model>[p];
      const Real friction =
          this->state_.friction[pair[0].geometry] * this->state_.friction[pair[1].geometry];
      sweep<Real, kPairLinks, kFloating>(pairs_.record[p], friction, this->state_.pair_force[p],
                                         links, this->base_pushed_);
    }
    this->each_limb([&]<std::size_t g>(std::size_t k, auto& limb) __attribute__((always_inline)) {
      for (std::size_t j = 0; j < LimbOf<g>::n; ++j)
        limb.pushed[j] = links[GroupOf<Model, g>::index(k, j)];
    });
  }
  void keep_pair_forces(const Real& per_step) {
    for (std::size_t p = 0; p < kPairCount; ++p) {
      Vec<Real>& force = this->state_.pair_force[p];
      force = pairs_.axes[p].to_world(force) * per_step;
    }
  }

  /// The base's part of L⁻ᵀJᵀ.
  template <std::size_t n>
  [[gnu::always_inline]] void finish_base_rows(PointRecord<Real, n>& point) {
    Real* const free[3] = {&point.free.x, &point.free.y, &point.free.z};
    const Real dt(this->settings_.dt);
    unrolled<3>([&](auto d) __attribute__((always_inline)) {
      Real(&row)[6] = point.row_base[d];
      unrolled<6>([&](auto back) __attribute__((always_inline)) {
        constexpr std::size_t j = 5 - back;
        unrolled<j>([&](auto i) __attribute__((always_inline)) {
          row[i] -= this->equation_.a[j][i] * row[j];
        });
        point.weighted_base[d][j] = row[j] * this->base_inverse_[j];
        *free[d] += dt * (point.weighted_base[d][j] * this->equation_.rhs[j]);
      });
    });
  }

  Moving<Real> base_;
  std::conditional_t<(kPairCount > 0), Pairs, NoPairs> pairs_;
};

}  // namespace eagerx::models::multibody

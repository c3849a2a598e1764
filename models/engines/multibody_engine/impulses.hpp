// Data that the parts of a step share, and impulses on joints that follow others or exceed their
// speed limits.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/math.hpp>
#include <limits>
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
class Impulses {
 public:
  using Real = typename Model::Real;
  using Lane = LaneOf<Real>;
  using State = multibody::State<Model>;
  using Settings = ContactSettings<Lane>;
  static constexpr bool kFloating = kFloats<Model>;
  static constexpr std::size_t kGroups = kTree<Model>.group_count;

  Real acceleration[at_least_one(State::kLinks)];
  Real base_acceleration[6];  // linear, angular

 protected:
  template <std::size_t g>
  using LimbOf = Limb<Model, g, kFloating>;
  static constexpr bool kMimicking = count_mimics<Model>() > 0;
  /// The torque that limits a joint's speed considers the joint alone. If other links drive it
  /// faster, an impulse stops it at this speed.
  static constexpr double kCut = 1.25;  // of the limit
  static constexpr auto kFastest = [] {
    std::array<Lane, at_least_one(State::kLinks)> fastest{};
    for (std::size_t l = 0; l < State::kLinks; ++l)
      fastest[l] =
          static_cast<Lane>(kCut * Model::kJoints[kTree<Model>.links[l].joint].max_velocity);
    return fastest;
  }();
  static constexpr bool kHasFastest = [] {
    for (std::size_t l = 0; l < State::kLinks; ++l) {
      if (kFastest[l] < std::numeric_limits<Lane>::infinity()) return true;
    }
    return false;
  }();

  Impulses(State& state, const Settings& settings) : state_(state), settings_(settings) {}

  template <class F>
  [[gnu::always_inline]] static void each_group(const F& f) {
    unrolled<kGroups>(f);
  }
  template <std::size_t g>
  [[gnu::always_inline]] auto& records() {
    return static_cast<GroupRecords<Model, g>&>(records_).limb;
  }
  // ---- limits of speed
  static Real fastest(std::size_t link) { return Real(kFastest[link]); }
  [[gnu::always_inline]] Real next_velocity(std::size_t link) const {
    return state_.v[link] + Real(settings_.dt) * acceleration[link];
  }
  [[gnu::always_inline]] void limit_speeds() {
    auto some = eagerx::abs(next_velocity(0)) > fastest(0);
    for (std::size_t l = 1; l < State::kLinks; ++l)
      some = some || eagerx::abs(next_velocity(l)) > fastest(l);
    if (any(some)) stop_the_fastest();
  }
  /// Joint by joint, twice: as impulses of contacts, but there is nearly never one.
  [[gnu::noinline]] void stop_the_fastest() {
#pragma GCC unroll 1
    for (int pass = 0; pass < 2; ++pass) {
      each_limb([&]<std::size_t g>(std::size_t k, auto& record) __attribute__((always_inline)) {
#pragma GCC unroll 1
        for (std::size_t j = 0; j < LimbOf<g>::n; ++j) {
          const std::size_t index = GroupOf<Model, g>::index(k, j);
          const auto beyond = eagerx::abs(next_velocity(index)) > fastest(index);
          if (any(beyond)) push_joint<g>(k, j, record, beyond);
        }
      });
    }
  }
  /// An impulse on a joint, and its effect on all others: a column of the inverse mass matrix.
  template <std::size_t g, class Record, class Truth>
  [[gnu::noinline]] void push_joint(std::size_t k, std::size_t joint, const Record& record,
                                    const Truth& beyond) {
    const Real zero(Lane(0));
    Real row[LimbOf<g>::n], base[6], column[at_least_one(State::kLinks)];
    for (auto& element : row) element = zero;
    for (auto& element : base) element = zero;
    row[joint] = Real(Lane(1));
    LimbOf<g>::reduce(record, row, base);
    if constexpr (kFloating) solve_base(base);
    const std::size_t pushed = GroupOf<Model, g>::index(k, 0);
    each_limb([&]<std::size_t h>(std::size_t limb, auto& other) __attribute__((always_inline)) {
      const std::size_t first = GroupOf<Model, h>::index(limb, 0);
      Real along[LimbOf<h>::n];
      for (std::size_t j = 0; j < LimbOf<h>::n; ++j)
        along[j] = first == pushed ? row[first == pushed ? j : 0] * other.inverse[j] : zero;
      LimbOf<h>::substitute(other, base, along);
      for (std::size_t j = 0; j < LimbOf<h>::n; ++j) column[first + j] = along[j];
    });
    const std::size_t index = pushed + joint;
    const Real velocity = next_velocity(index), most = fastest(index);
    const Real end = eagerx::max(-most, eagerx::min(velocity, most));
    const Real impulse = (end - velocity) / (Real(settings_.dt) * column[index]);
    for (std::size_t l = 0; l < State::kLinks; ++l)
      acceleration[l] =
          eagerx::select(beyond, acceleration[l] + column[l] * impulse, acceleration[l]);
    for (std::size_t b = 0; kFloating && b < 6; ++b)
      base_acceleration[b] =
          eagerx::select(beyond, base_acceleration[b] + base[b] * impulse, base_acceleration[b]);
  }
  /// The base's motion of a row.
  [[gnu::always_inline]] void solve_base(Real (&row)[6]) const {
    for (std::size_t j = 6; j-- > 0;) {
      for (std::size_t i = 0; i < j; ++i) row[i] -= equation_.a[j][i] * row[j];
    }
    for (std::size_t j = 0; j < 6; ++j) {
      row[j] *= base_inverse_[j];
      for (std::size_t i = 0; i < j; ++i) row[j] -= equation_.a[j][i] * row[i];
    }
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
  /// Called after the contacts' impulses.
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

  State& state_;
  const Settings settings_;
  BaseEquation<Real> equation_;
  Real base_inverse_[6], base_pushed_[6];
  Records<Model, std::make_index_sequence<kGroups>> records_;
  struct None {};
  std::conditional_t<kMimicking, MimicRows<Model>, None> mimics_;
};

}  // namespace eagerx::models::multibody

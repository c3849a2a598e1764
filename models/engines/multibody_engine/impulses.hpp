// Data that the parts of a step share, and impulses on joints that follow others.
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
  Impulses(State& state, const Settings& settings) : state_(state), settings_(settings) {}

  template <class F>
  [[gnu::always_inline]] static void each_group(const F& f) {
    unrolled<kGroups>(f);
  }
  template <std::size_t g>
  [[gnu::always_inline]] auto& records() {
    return static_cast<GroupRecords<Model, g>&>(records_).limb;
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

// Pushes every few seconds.
#pragma once

#include <array>
#include <cstddef>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// force [3] in N: a row of `impulses` [3, 2] in N·s over the duration of a push; see the manifest.
template <class Io>
class Pushes {
 public:
  void reset(const typename Io::States& states) {
    ticks_ = Real(0);
    if constexpr (requires { states.impulses; }) set(impulses_, states.impulses);
    if constexpr (requires { states.waits; }) set(waits_, states.waits);
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& /*in*/,
                typename Io::Outputs& out) {
    const Real time = ticks_ * Real(kPeriod);
    Real x(0);
    Real y(0);
    Real begin(0);
    for (std::size_t k = 0; k < kCount; ++k) {
      begin = begin + waits_[k];
      const auto pushes = time >= begin && time < begin + Real(kDuration);
      x = eagerx::select(pushes, impulses_[2 * k] * Real(kRate), x);
      y = eagerx::select(pushes, impulses_[2 * k + 1] * Real(kRate), y);
    }
    put(out.force, 0, x);
    put(out.force, 1, y);
    put(out.force, 2, Real(0));
    ticks_ = ticks_ + Real(1);
  }

 private:
  using Real = typename Io::Real;
  static constexpr std::size_t kCount = 3;
  static constexpr auto kPeriod = constant<Real>(Io::Rate::period_s);
  static constexpr auto kDuration = constant<Real>(Io::Config::duration);
  static constexpr auto kRate = constant<Real>(1.0 / Io::Config::duration);

  template <std::size_t N, class State>
  static void set(std::array<Real, N>& numbers, const State& state) {
    if (!state) return;
    for (std::size_t i = 0; i < N; ++i) numbers[i] = static_cast<Real>(eagerx::element(*state, i));
  }

  Real ticks_{};
  std::array<Real, 2 * kCount> impulses_{};  // [N·s]
  std::array<Real, kCount> waits_{};         // [s]
};

}  // namespace eagerx::models

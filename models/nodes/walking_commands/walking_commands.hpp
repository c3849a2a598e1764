// Commands of speeds that change every few seconds.
#pragma once

#include <array>
#include <cstddef>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// command [3] in m/s and rad/s: the row of `speeds` [4, 3] whose turn it is; see the manifest.
template <class Io>
class WalkingCommands {
 public:
  void reset(const typename Io::States& states) {
    ticks_ = Real(0);
    if constexpr (requires { states.speeds; }) set(speeds_, states.speeds);
    if constexpr (requires { states.durations; }) set(durations_, states.durations);
    if constexpr (requires { states.stand; }) set(stand_, states.stand);
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& /*in*/,
                typename Io::Outputs& out) {
    const Real time = ticks_ * Real(kPeriod);
    std::array<Real, 3> command = row(0);
    Real end = durations_[0];
    for (std::size_t k = 1; k < kCount; ++k) {
      const auto later = time >= end;
      const std::array<Real, 3> next = row(k);
      for (std::size_t i = 0; i < 3; ++i) command[i] = eagerx::select(later, next[i], command[i]);
      end = end + durations_[k];
    }
    for (std::size_t i = 0; i < 3; ++i) put(out.command, i, command[i]);
    ticks_ = ticks_ + Real(1);
  }

 private:
  using Real = typename Io::Real;
  static constexpr std::size_t kCount = 4;
  static constexpr auto kPeriod = constant<Real>(Io::Rate::period_s);
  static constexpr auto kStanding = constant<Real>(Io::Config::standing);

  template <std::size_t N, class State>
  static void set(std::array<Real, N>& numbers, const State& state) {
    if (!state) return;
    for (std::size_t i = 0; i < N; ++i) numbers[i] = static_cast<Real>(eagerx::element(*state, i));
  }

  [[nodiscard]] std::array<Real, 3> row(std::size_t k) const {
    const auto stands = stand_[k] < Real(kStanding);
    std::array<Real, 3> result{};
    for (std::size_t i = 0; i < 3; ++i)
      result[i] = eagerx::select(stands, Real(0), speeds_[3 * k + i]);
    return result;
  }

  Real ticks_{};
  std::array<Real, 3 * kCount> speeds_{};
  std::array<Real, kCount> durations_{};  // [s]
  std::array<Real, kCount> stand_{};
};

}  // namespace eagerx::models

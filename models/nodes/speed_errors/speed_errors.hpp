// Mean errors of a velocity that follows commands.
#pragma once

#include <array>
#include <cstddef>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// speed [m/s], turn [rad/s] and instant [m/s] of velocity [3], angular_velocity [3] and command
/// [3]; see the manifest.
template <class Io>
class SpeedErrors {
 public:
  void reset(const typename Io::States& /*states*/) { *this = SpeedErrors{}; }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out) {
    const std::array<Real, 3> motion = {newest<Real>(in.velocity, 0), newest<Real>(in.velocity, 1),
                                        newest<Real>(in.angular_velocity, 2)};
    const std::array<Real, 3> command = {newest<Real>(in.command, 0), newest<Real>(in.command, 1),
                                         newest<Real>(in.command, 2)};
    add(motion, ticks_ > Real(0));
    auto changes = ticks_ == Real(0);
    for (std::size_t i = 0; i < 3; ++i) changes = changes || command[i] != command_[i];
    begin_where(changes);
    command_ = command;
    ticks_ = ticks_ + Real(1);
    const Real windows = eagerx::max(windows_, Real(1));
    const Real ticks = eagerx::max(ticks_ - Real(1), Real(1));
    put(out.speed, 0, speed_ / windows);
    put(out.turn, 0, turn_ / windows);
    put(out.instant, 0, instant_ / ticks);
  }

 private:
  using Real = typename Io::Real;
  using Truth = eagerx::TruthOf<Real>;
  static constexpr auto kTicks = constant<Real>(
      static_cast<double>(static_cast<int>(Io::Config::window / Io::Rate::period_s + 0.5)));

  static Real distance(const std::array<Real, 3>& a, const std::array<Real, 3>& b) {
    const Real x = a[0] - b[0];
    const Real y = a[1] - b[1];
    return eagerx::sqrt(x * x + y * y);
  }

  void add(const std::array<Real, 3>& motion, const Truth& counts) {
    instant_ = eagerx::select(counts, instant_ + distance(motion, command_), instant_);
    in_window_ = eagerx::select(counts, in_window_ + Real(1), in_window_);
    std::array<Real, 3> mean{};
    for (std::size_t i = 0; i < 3; ++i) {
      sum_[i] = eagerx::select(counts, sum_[i] + motion[i], sum_[i]);
      mean[i] = sum_[i] / Real(kTicks);
    }
    const Truth full = in_window_ >= Real(kTicks);
    speed_ = eagerx::select(full, speed_ + distance(mean, command_), speed_);
    turn_ = eagerx::select(full, turn_ + eagerx::abs(mean[2] - command_[2]), turn_);
    windows_ = eagerx::select(full, windows_ + Real(1), windows_);
    begin_where(full);
  }
  void begin_where(const Truth& begins) {
    in_window_ = eagerx::select(begins, Real(0), in_window_);
    for (Real& sum : sum_) sum = eagerx::select(begins, Real(0), sum);
  }

  std::array<Real, 3> command_{};  // of the tick before
  std::array<Real, 3> sum_{};      // of the motion in this window
  Real in_window_{};               // ticks of it
  Real windows_{};
  Real speed_{};
  Real turn_{};
  Real instant_{};
  Real ticks_{};
};

}  // namespace eagerx::models

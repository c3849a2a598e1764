// The routine by which reset nodes of EAGERx's pendulums move to an angle.
#pragma once

#include <eagerx/math.hpp>
#include <eagerx/rate.hpp>
#include <models/nodes/block.hpp>
#include <models/processors/normalize_angle/normalize_angle.hpp>
#include <numbers>

namespace eagerx::models {

/// The PID controller that EAGERx's tutorials have in differences,
///   u ← u + F₀·e_k + F₁·e_{k−1} + F₂·e_{k−2},  u = 0 at a reset
///   F = [kp + ki·dt + kd/dt, −kp − 2·kd/dt, kd/dt]
/// with one and two terms at the first two calls, as the sum that this is: u = kp·e_k + ki·dt·Σe +
/// kd/dt·(e_k − e_{k−1}), whose roundings do not add up. Nothing limits u here. An error that is
/// not finite leaves u as it is. Source: eagerx_tutorials, pendulum/pid.py.
template <class Real>
class DifferencePid {
 public:
  struct Gains {
    Real kp, kd, ki;
  };

  void reset() {
    sum_ = {};
    last_ = {};
    u_ = {};
  }

  Real next(const Gains& gains, Real dt, Real error) {
    if (!eagerx::isfinite(error)) return u_;
    sum_ = sum_.plus(error);
    u_ = gains.kp * error + gains.ki * dt * sum_.value + gains.kd / dt * (error - last_);
    last_ = error;
    return u_;
  }

 private:
  CompensatedSum<Real> sum_{};  // of errors
  Real last_{};
  Real u_{};
};

/// Drives an angle to a goal near hanging down and says when it is there: angle and speed both
/// within `threshold` (and 1e-5 of the goal, as numpy.isclose), or more than `timeout` s after the
/// first call. Angles count from hanging down, so that no jump is near the pendulum.
template <class Io>
class AngleRoutine {
 public:
  using Real = typename Io::Real;
  struct Command {
    Real u;  // within u_range
    bool done;
  };

  void reset() {
    controller_.reset();
    running_ = false;
  }

  /// Angles in rad with 0 upright, speed in rad/s.
  Command next(const Tick& tick, Real angle, Real speed, Real goal_angle) {
    using Config = typename Io::Config;
    static_assert(Config::gains.size() == 3, "ResetAngle: `gains` are [kp, kd, ki]");
    static_assert(Config::u_range.size() == 2 && Config::u_range[0] <= Config::u_range[1],
                  "ResetAngle: `u_range` is [lowest, highest]");
    constexpr typename DifferencePid<Real>::Gains kGains = {static_cast<Real>(Config::gains[0]),
                                                            static_cast<Real>(Config::gains[1]),
                                                            static_cast<Real>(Config::gains[2])};
    constexpr auto kThreshold = static_cast<Real>(Config::threshold);
    constexpr auto kRelative = Real(1e-5);
    if (!running_) {
      running_ = true;
      start_ = tick.n;
    }
    const Real now = from_below(angle);
    const Real goal = from_below(goal_angle);
    const Real u = controller_.next(kGains, static_cast<Real>(Io::Rate::period_s), goal - now);
    const bool reached = eagerx::abs(now - goal) <= kThreshold + kRelative * eagerx::abs(goal) &&
                         eagerx::abs(speed) <= kThreshold;
    const bool late = Io::Rate::template seconds<double>(tick.n - start_) > Config::timeout;
    return {eagerx::clamp(u, static_cast<Real>(Config::u_range[0]),
                          static_cast<Real>(Config::u_range[1])),
            reached || late};
  }

 private:
  static Real from_below(Real angle) { return normalized_angle(angle + std::numbers::pi_v<Real>); }

  DifferencePid<Real> controller_{};
  Seq start_ = 0;
  bool running_ = false;
};

}  // namespace eagerx::models

// The reset node of EAGERx's tutorials.
#pragma once

#include <eagerx/rate.hpp>
#include <models/nodes/reset_angle/angle_routine.hpp>

namespace eagerx::models {

/// During a reset, every tick: u [1] := the routine's voltage for `theta` [rad] and `theta_dot`
/// [rad/s]; done when it says so. Zero and done if no goal is asked for.
/// Source: eagerx_tutorials, pendulum/reset.py.
template <class Io>
class ResetAngle {
 public:
  void reset(const typename Io::States& /*states*/) { routine_.reset(); }

  void callback(const Tick& tick, const typename Io::Inputs& in,
                const typename Io::Targets& targets, typename Io::Outputs& out,
                typename Io::Done& done) {
    using Real = typename Io::Real;
    out.u[0] = 0;
    done.goal = true;
    if (!targets.goal || in.theta.empty() || in.theta_dot.empty()) return;
    const auto command = routine_.next(tick, static_cast<Real>(in.theta.back()),
                                       static_cast<Real>(in.theta_dot.back()),
                                       static_cast<Real>((*targets.goal)[0]));
    out.u[0] = static_cast<float>(command.u);
    done.goal = command.done;
  }

 private:
  AngleRoutine<Io> routine_{};
};

}  // namespace eagerx::models

// The reset node of EAGERx's real pendulum.
#pragma once

#include <eagerx/math.hpp>
#include <eagerx/rate.hpp>
#include <models/nodes/reset_angle/angle_routine.hpp>

namespace eagerx::models {

/// During a reset, every tick: u [1] := the routine's voltage for x = [cos θ, sin θ, dθ/dt]
/// [-, -, rad/s]; done when it says so. Zero and done if no goal is asked for.
/// Source: eagerx_dcsc_setups, pendulum/nodes.py.
template <class Io>
class ResetDecomposedAngle {
 public:
  void reset(const typename Io::States& /*states*/) { routine_.reset(); }

  void callback(const Tick& tick, const typename Io::Inputs& in,
                const typename Io::Targets& targets, typename Io::Outputs& out,
                typename Io::Done& done) {
    using Real = typename Io::Real;
    out.u[0] = 0;
    done.goal = true;
    if (!targets.goal || in.x.empty()) return;
    const auto& x = in.x.back();
    const Real angle = eagerx::atan2(static_cast<Real>(x[1]), static_cast<Real>(x[0]));
    const auto command =
        routine_.next(tick, angle, static_cast<Real>(x[2]), static_cast<Real>((*targets.goal)[0]));
    out.u[0] = static_cast<float>(command.u);
    done.goal = command.done;
  }

 private:
  AngleRoutine<Io> routine_{};
};

}  // namespace eagerx::models

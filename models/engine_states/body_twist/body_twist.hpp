// Sets the velocities of a body simulated by OpenDynamicsEngine.
#pragma once

#include <models/engine_states/rigid_states.hpp>

namespace eagerx::models {

/// At a reset: velocity [m/s] and angular velocity [rad/s] of a body without a joint to a parent.
template <class Io>
struct BodyTwist {
  static void reset(const typename Io::State& value, typename Io::Simulator& simulator) {
    using Body = FreeBodyNumbers<Io, 6>;
    simulator.want_twist(Body::kBody, Body::of(value));
  }
};

}  // namespace eagerx::models

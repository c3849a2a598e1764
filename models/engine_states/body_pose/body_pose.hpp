// Sets the pose of a body simulated by OpenDynamicsEngine.
#pragma once

#include <models/engine_states/rigid_states.hpp>

namespace eagerx::models {

/// At a reset: position [m] and quaternion [w, x, y, z] of a body without a joint to a parent.
template <class Io>
struct BodyPose {
  static void reset(const typename Io::State& value, typename Io::Simulator& simulator) {
    using Body = FreeBodyNumbers<Io, 7>;
    simulator.want_pose(Body::kBody, Body::of(value));
  }
};

}  // namespace eagerx::models

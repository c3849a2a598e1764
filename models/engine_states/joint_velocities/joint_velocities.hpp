// Sets the velocities of joints simulated by OpenDynamicsEngine.
#pragma once

#include <models/engine_states/rigid_states.hpp>

namespace eagerx::models {

/// At a reset: the velocities [n] that `joints` have together.
template <class Io>
struct JointVelocities : JointNumbers<Io, JointVelocities<Io>> {
  static auto& part(JointCoordinates& at) { return at.velocity; }
};

}  // namespace eagerx::models

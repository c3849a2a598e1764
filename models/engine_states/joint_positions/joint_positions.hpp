// Sets the positions of joints simulated by OpenDynamicsEngine.
#pragma once

#include <models/engine_states/rigid_states.hpp>

namespace eagerx::models {

/// At a reset: the positions [n] that `joints` have together.
template <class Io>
struct JointPositions : JointNumbers<Io, JointPositions<Io>> {
  static auto& part(JointCoordinates& at) { return at.position; }
};

}  // namespace eagerx::models

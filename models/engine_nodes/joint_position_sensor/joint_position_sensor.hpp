// Positions of joints simulated by OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <models/engine_nodes/rigid_nodes.hpp>

namespace eagerx::models {

/// Every tick: observation [size] := positions of `joints` [rad, m] at the time of the tick.
template <class Io>
class JointPositionSensor : public JointSensor<Io, JointPositionSensor<Io>> {
 public:
  static auto number(const typename Io::Simulator& simulator, std::size_t joint, std::size_t axis) {
    return simulator.joint_position(joint, axis);
  }
};

}  // namespace eagerx::models

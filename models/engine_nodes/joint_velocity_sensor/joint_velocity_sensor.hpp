// Velocities of joints simulated by OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <models/engine_nodes/rigid_nodes.hpp>

namespace eagerx::models {

/// Every tick: observation [size] := velocities of `joints` [rad/s, m/s] at the time of the tick.
template <class Io>
class JointVelocitySensor : public JointSensor<Io, JointVelocitySensor<Io>> {
 public:
  static auto number(const typename Io::Simulator& simulator, std::size_t joint, std::size_t axis) {
    return simulator.joint_velocity(joint, axis);
  }
};

}  // namespace eagerx::models

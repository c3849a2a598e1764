// Sets torques of joints simulated by OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <models/engine_nodes/rigid_nodes.hpp>

namespace eagerx::models {

/// Torque of a hinge [N·m] or force of a slider [N] := action, for each of `joints`.
template <class Io>
class JointTorqueActuator : public JointActuator<Io, JointTorqueActuator<Io>> {
 public:
  static void command(typename Io::Simulator& simulator, std::size_t joint, std::size_t /*place*/,
                      const typename Io::Simulator::Number& value) {
    simulator.set_joint_torque(joint, value);
  }
};

}  // namespace eagerx::models

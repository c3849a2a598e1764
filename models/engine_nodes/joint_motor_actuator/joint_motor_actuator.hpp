// Velocity motors of joints simulated by OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <models/engine_nodes/rigid_nodes.hpp>

namespace eagerx::models {

/// Velocity that the joint's motor holds [rad/s, m/s] := action, for each of `joints`.
template <class Io>
class JointMotorActuator : public JointActuator<Io, JointMotorActuator<Io>> {
 public:
  static void command(typename Io::Simulator& simulator, std::size_t joint, std::size_t /*place*/,
                      const typename Io::Simulator::Number& value) {
    simulator.set_joint_motor(joint, value,
                              number_for<typename Io::Simulator>(Io::Config::max_torque));
  }
};

}  // namespace eagerx::models

// Position control of joints simulated by OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <models/engine_nodes/rigid_nodes.hpp>

namespace eagerx::models {

/// Position that the joint's servo turns to [rad, m] := action, for each of `joints`.
template <class Io>
class JointPositionActuator : public JointActuator<Io, JointPositionActuator<Io>> {
 public:
  static void command(typename Io::Simulator& simulator, std::size_t joint, double value) {
    simulator.set_joint_servo(joint, {.position = value,
                                      .stiffness = Io::Config::stiffness,
                                      .damping = Io::Config::damping,
                                      .max_torque = Io::Config::max_torque});
  }
};

}  // namespace eagerx::models

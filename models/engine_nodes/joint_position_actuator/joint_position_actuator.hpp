// Position control of joints simulated by OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <models/engine_nodes/rigid_nodes.hpp>

namespace eagerx::models {

/// Position that the joint's servo turns to [rad, m] := action, for each of `joints`.
template <class Io>
class JointPositionActuator : public JointActuator<Io, JointPositionActuator<Io>> {
 public:
  static void command(typename Io::Simulator& simulator, std::size_t joint,
                      const typename Io::Simulator::Number& value) {
    using Simulator = typename Io::Simulator;
    simulator.set_joint_servo(joint, {.position = value,
                                      .stiffness = number_for<Simulator>(Io::Config::stiffness),
                                      .damping = number_for<Simulator>(Io::Config::damping),
                                      .max_torque = number_for<Simulator>(Io::Config::max_torque)});
  }
};

}  // namespace eagerx::models
